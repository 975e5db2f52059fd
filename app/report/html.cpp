// The page: everything inside, texts escaped, a policy that forbids the browser to fetch anything.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

#include "app/report/base64.h"
#include "app/report/document.h"
#include "app/words/xml_text.h"

namespace voussoir::app::report
{
namespace
{

constexpr std::uintmax_t largest_film = 6 << 20;  // bytes; base64 makes a third more of it

constexpr const char* style = R"(
:root { --ink: #22252b; --faint: #616672; --line: #d8dce2; --accent: #31688e; }
* { box-sizing: border-box; }
body { font: 16px/1.55 "DejaVu Sans", system-ui, sans-serif; color: var(--ink); margin: 0 auto; max-width: 62rem;
  padding: 2rem 1.5rem 4rem; overflow-wrap: break-word; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 1rem 0 .4rem; }
h2 { font-size: 1.3rem; margin: 2.6rem 0 .6rem; padding-bottom: .3rem; border-bottom: 2px solid var(--line); }
.outcome { padding: .8rem 1rem; border-left: 6px solid #2a8f57; background: #eef7f1; font-weight: 600; }
.doubt .outcome { border-color: #c98a00; background: #fdf6e3; }
.alarm .outcome { border-color: #c4161c; background: #fdeeee; }
.outcome + .doubts { margin-top: -1rem; }
.doubts { padding: .6rem 1rem .2rem; border-left: 6px solid #c98a00; background: #fdf6e3; font-size: .95rem; }
.doubts p, .doubts ul { margin: 0 0 .4rem; }
.mechanism { font-size: 1.08rem; }
nav a { color: var(--accent); margin-right: 1.1rem; white-space: nowrap; }
table { border-collapse: collapse; font-size: .86rem; margin: .6rem 0 1.4rem; width: 100%; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; caption-side: top; }
th, td { border-bottom: 1px solid var(--line); padding: .3rem .7rem .3rem 0; text-align: left; vertical-align: top; }
th { color: var(--faint); font-weight: 600; }
td.n { white-space: nowrap; }
td { overflow-wrap: anywhere; min-width: 7.8rem; }
td.n { min-width: 3rem; }
#view td { min-width: 3rem; }
figure { margin: 1rem 0 1.6rem; break-inside: avoid; }
figure img, figure video { width: 100%; height: auto; border: 1px solid var(--line); display: block; }
figcaption, .more { color: var(--faint); font-size: .88rem; }
pre { font-size: .78rem; line-height: 1.4; background: #f6f7f9; padding: 1rem; white-space: pre-wrap; }
#view h3 { margin: 0; font-size: 1.05rem; overflow-wrap: anywhere; }
#view p { margin: .2rem 0 .6rem; }
.view-body { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; }
.view-stage { position: relative; flex: 3 1 24rem; min-width: 0; }
.view-stage canvas { display: block; width: 100%; border: 1px solid var(--line); touch-action: none; }
.view-stage canvas:focus { outline: 2px solid var(--accent); }
.view-panel { flex: 1 1 15rem; min-width: 0; max-height: 32rem; overflow: auto; }
#view th, #view td { padding-right: .3rem; font-size: .8rem; }
#view td + td { white-space: nowrap; }
.view-panel button { all: unset; color: var(--accent); cursor: pointer; overflow-wrap: anywhere; }
.view-panel button:focus-visible { outline: 2px solid var(--accent); }
.view-history { width: 100%; height: auto; font-family: inherit; }
.view-legend { position: absolute; left: .6rem; bottom: .6rem; font-size: .8rem; background: #ffffffd0; padding: .15rem .5rem; }
.view-scale { display: inline-block; width: 8rem; height: .7rem; margin: 0 .4rem;
  background: linear-gradient(90deg, #440154, #482878, #3e4989, #31688e, #26828e, #1f9e89, #35b779, #6ece58, #b5de2b, #fde725); }
.view-swatch { display: inline-block; width: .8rem; height: .8rem; margin-right: .4rem; }
.view-bar { display: flex; flex-wrap: wrap; align-items: center; gap: .4rem 1rem; margin: .6rem 0; font-size: .88rem; }
.view-bar input { flex: 1 1 12rem; }
@media screen and (max-width: 40rem) { table { display: block; overflow-x: auto; } td { min-width: 5rem; } }
@media print { body { max-width: none; padding: 0; font-size: 11pt; }
  nav, .film, section:has(> .film), section:has(> #view) { display: none; }
  table { font-size: 8.5pt; } th, td { padding-right: .4rem; }
  h2 { break-after: avoid; } tr { break-inside: avoid; }
  .short { break-inside: avoid; } caption, thead { break-after: avoid; }
  tbody tr:first-child { break-before: avoid; } figure img { max-height: 22cm; width: auto; max-width: 100%; } }
)";

std::string bytes_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string picture(const Picture& of)
{
    const std::string caption = "<figcaption>" + words::xml_text(of.caption) + "</figcaption></figure>\n";
    std::error_code none;
    if (!of.is_film)
        return "<figure><img alt=\"" + words::xml_text(of.caption) + "\" src=\"data:image/png;base64," +
               base64(bytes_of(of.file)) + "\">" + caption;
    if (std::filesystem::file_size(of.file, none) > largest_film)
        return "<p>The film is too large for this page and lies beside it: " +
               words::xml_text(of.file.filename().string()) + ".</p>\n";
    return "<figure class=\"film\"><video controls muted loop playsinline src=\"data:video/mp4;base64," +
           base64(bytes_of(of.file)) + "\"></video>" + caption;
}

bool is_number(const std::string& cell)
{
    return !cell.empty() && cell.find_first_not_of("0123456789.+-e") == std::string::npos;
}

std::string table(const Table& of, const std::string& folder)
{
    const bool is_short = std::min(of.rows.size(), of.shown) <= 12;  // stays on one sheet of paper
    std::string text = std::string(is_short ? "<table class=\"short\">" : "<table>") + "<caption>" +
                       words::xml_text(of.title) + "</caption>\n<thead><tr>";
    for (const std::string& column : of.columns) text += "<th>" + words::xml_text(column) + "</th>";
    text += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < of.rows.size() && i < of.shown; ++i) {
        text += "<tr>";
        for (const std::string& cell : of.rows[i])
            text += (is_number(cell) ? "<td class=\"n\">" : "<td>") + words::xml_text(cell) + "</td>";
        text += "</tr>\n";
    }
    text += "</tbody></table>\n";
    if (of.rows.size() > of.shown)
        text += "<p class=\"more\">" + std::to_string(of.rows.size() - of.shown) + " more rows in " + folder +
                "/" + words::xml_text(of.name) + ".csv.</p>\n";
    return text;
}

std::string doubts(const Document& document)
{
    if (document.doubts.empty()) return "";
    std::string text = std::string("<div class=\"doubts\"><p>") + before_the_doubts + "</p>\n<ul>\n";
    for (const std::string& doubt : document.doubts) text += "<li>" + words::xml_text(doubt) + "</li>\n";
    return text + "</ul></div>\n";
}

/// Red what did not go as planned, amber what breaks a limit; green is only what is neither.
const char* body_of(const Document& document)
{
    if (document.alarm) return "<body class=\"alarm\">\n";
    return document.doubts.empty() ? "<body>\n" : "<body class=\"doubt\">\n";
}

std::string section(const Section& of, std::size_t number, const std::string& folder)
{
    std::string text =
        "<section id=\"s" + std::to_string(number) + "\">\n<h2>" + words::xml_text(of.title) + "</h2>\n";
    for (const std::string& paragraph : of.paragraphs) text += "<p>" + words::xml_text(paragraph) + "</p>\n";
    if (!of.points.empty()) {
        text += "<ul>\n";
        for (const std::string& point : of.points) text += "<li>" + words::xml_text(point) + "</li>\n";
        text += "</ul>\n";
    }
    if (of.has_view)
        text +=
            "<div id=\"view\"><p class=\"more\">The view needs a browser with scripts and WebGL; the pictures "
            "show "
            "the same without.</p></div>\n";
    for (const Picture& one : of.pictures) text += picture(one);
    for (const Table& one : of.tables) text += table(one, folder);
    if (!of.verbatim.empty()) text += "<pre>" + words::xml_text(of.verbatim) + "</pre>\n";
    return text + "</section>\n";
}

}  // namespace

std::string to_html(const Document& document)
{
    const bool has_view = !document.view.data.empty();
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; media-src "
        "data:; "
        "style-src 'unsafe-inline'" +
        (has_view ? "; script-src '" + document.view.script.hash + "'" : std::string()) +
        "\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
        words::xml_text(document.title) + "</title>\n<style>" + style + "</style>\n</head>\n";
    text += body_of(document);
    text += "<p class=\"outcome\">" + words::xml_text(document.first_line) + "</p>\n" + doubts(document) + "<h1>" +
            words::xml_text(document.title) + "</h1>\n<p class=\"mechanism\">" +
            words::xml_text(document.mechanism_line) + "</p>\n<nav>";
    for (std::size_t i = 0; i < document.sections.size(); ++i)
        text += "<a href=\"#s" + std::to_string(i) + "\">" + words::xml_text(document.sections[i].title) + "</a>";
    text += "</nav>\n";
    for (std::size_t i = 0; i < document.sections.size(); ++i)
        text += section(document.sections[i], i, document.companions);
    if (has_view)
        text += "<script type=\"application/json\" id=\"view-data\">" + document.view.data +
                "</script>\n<script>" + document.view.script.text + "</script>\n";
    return text + "</body>\n</html>\n";
}

}  // namespace voussoir::app::report
