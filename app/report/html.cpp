// The page: everything inside, texts escaped, a policy that forbids the browser to fetch anything.
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>

#include "app/report/document.h"

namespace voussoir::app::report
{
namespace
{

constexpr std::uintmax_t largest_film = 8 << 20;  // bytes; base64 makes a third more of it

constexpr const char* style = R"(
:root { --ink: #22252b; --faint: #616672; --line: #d8dce2; --accent: #31688e; }
* { box-sizing: border-box; }
body { font: 16px/1.55 "DejaVu Sans", system-ui, sans-serif; color: var(--ink); margin: 0 auto; max-width: 62rem;
  padding: 2rem 1.5rem 4rem; overflow-wrap: break-word; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 1rem 0 .4rem; }
h2 { font-size: 1.3rem; margin: 2.6rem 0 .6rem; padding-bottom: .3rem; border-bottom: 2px solid var(--line); }
.outcome { padding: .8rem 1rem; border-left: 6px solid #2a8f57; background: #eef7f1; font-weight: 600; }
.alarm .outcome { border-color: #c4161c; background: #fdeeee; }
.mechanism { font-size: 1.08rem; }
nav a { color: var(--accent); margin-right: 1.1rem; white-space: nowrap; }
table { border-collapse: collapse; font-size: .86rem; margin: .6rem 0 1.4rem; width: 100%; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; caption-side: top; }
th, td { border-bottom: 1px solid var(--line); padding: .3rem .7rem .3rem 0; text-align: left; vertical-align: top; }
th { color: var(--faint); font-weight: 600; }
td.n { white-space: nowrap; }
td { overflow-wrap: anywhere; min-width: 3rem; }
figure { margin: 1rem 0 1.6rem; break-inside: avoid; }
figure img, figure video { width: 100%; height: auto; border: 1px solid var(--line); display: block; }
figcaption, .more { color: var(--faint); font-size: .88rem; }
pre { font-size: .78rem; line-height: 1.4; background: #f6f7f9; padding: 1rem; white-space: pre-wrap; }
@media print { body { max-width: none; padding: 0; font-size: 11pt; } nav, .film, section:has(> .film) { display: none; }
  table { font-size: 8.5pt; } th, td { padding-right: .4rem; }
  h2 { break-after: avoid; } tr { break-inside: avoid; } figure img { max-height: 22cm; width: auto; max-width: 100%; } }
)";

std::string escaped(std::string_view text)
{
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else if (c == '\'')
            safe += "&#39;";
        else
            safe += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? ' ' : c;
    }
    return safe;
}

std::string bytes_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string base64(const std::string& bytes)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63U];
    }
    return text;
}

std::string picture(const Picture& of)
{
    const std::string caption = "<figcaption>" + escaped(of.caption) + "</figcaption></figure>\n";
    std::error_code none;
    if (!of.is_film)
        return "<figure><img alt=\"" + escaped(of.caption) + "\" src=\"data:image/png;base64," +
               base64(bytes_of(of.file)) + "\">" + caption;
    if (std::filesystem::file_size(of.file, none) > largest_film)
        return "<p>The film is too large for this page and lies beside it: " +
               escaped(of.file.filename().string()) + ".</p>\n";
    return "<figure class=\"film\"><video controls muted loop playsinline src=\"data:video/mp4;base64," +
           base64(bytes_of(of.file)) + "\"></video>" + caption;
}

bool is_number(const std::string& cell)
{
    return !cell.empty() && cell.find_first_not_of("0123456789.+-e") == std::string::npos;
}

std::string table(const Table& of)
{
    std::string text = "<table><caption>" + escaped(of.title) + "</caption>\n<thead><tr>";
    for (const std::string& column : of.columns) text += "<th>" + escaped(column) + "</th>";
    text += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < of.rows.size() && i < of.shown; ++i) {
        text += "<tr>";
        for (const std::string& cell : of.rows[i])
            text += (is_number(cell) ? "<td class=\"n\">" : "<td>") + escaped(cell) + "</td>";
        text += "</tr>\n";
    }
    text += "</tbody></table>\n";
    if (of.rows.size() > of.shown)
        text += "<p class=\"more\">" + std::to_string(of.rows.size() - of.shown) + " more rows in report/" +
                escaped(of.name) + ".csv.</p>\n";
    return text;
}

std::string section(const Section& of, std::size_t number)
{
    std::string text = "<section id=\"s" + std::to_string(number) + "\">\n<h2>" + escaped(of.title) + "</h2>\n";
    for (const std::string& paragraph : of.paragraphs) text += "<p>" + escaped(paragraph) + "</p>\n";
    if (!of.points.empty()) {
        text += "<ul>\n";
        for (const std::string& point : of.points) text += "<li>" + escaped(point) + "</li>\n";
        text += "</ul>\n";
    }
    for (const Picture& one : of.pictures) text += picture(one);
    for (const Table& one : of.tables) text += table(one);
    if (!of.verbatim.empty()) text += "<pre>" + escaped(of.verbatim) + "</pre>\n";
    return text + "</section>\n";
}

}  // namespace

std::string to_html(const Document& document)
{
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; media-src "
        "data:; "
        "style-src 'unsafe-inline'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
        escaped(document.title) + "</title>\n<style>" + style + "</style>\n</head>\n";
    text += document.alarm ? "<body class=\"alarm\">\n" : "<body>\n";
    text += "<p class=\"outcome\">" + escaped(document.first_line) + "</p>\n<h1>" + escaped(document.title) +
            "</h1>\n<p class=\"mechanism\">" + escaped(document.mechanism_line) + "</p>\n<nav>";
    for (std::size_t i = 0; i < document.sections.size(); ++i)
        text += "<a href=\"#s" + std::to_string(i) + "\">" + escaped(document.sections[i].title) + "</a>";
    text += "</nav>\n";
    for (std::size_t i = 0; i < document.sections.size(); ++i) text += section(document.sections[i], i);
    return text + "</body>\n</html>\n";
}

}  // namespace voussoir::app::report
