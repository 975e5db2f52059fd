// The report as Markdown, JSON and CSV.
#include <nlohmann/json.hpp>

#include "app/report/document.h"
#include "app/words/csv_cell.h"

namespace voussoir::app::report
{
namespace
{

/// Of other people's names no markup is made: what Markdown or HTML would read gets a backslash.
std::string plain(const std::string& text)
{
    std::string safe;
    for (const char c : text) {
        if (std::string_view("\\`*_[]<>|#&").find(c) != std::string_view::npos) safe += '\\';
        safe += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return safe;
}

std::string row(const std::vector<std::string>& cells)
{
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + plain(cell) + " |";
    return text + "\n";
}

std::string table(const Table& of, const std::string& folder)
{
    std::string text = "**" + plain(of.title) + "**\n\n" + row(of.columns) + "|";
    for (std::size_t i = 0; i < of.columns.size(); ++i) text += "---|";
    text += "\n";
    for (std::size_t i = 0; i < of.rows.size() && i < of.shown; ++i) text += row(of.rows[i]);
    if (of.rows.size() > of.shown)
        text += "\n" + std::to_string(of.rows.size() - of.shown) + " more rows in " + folder + "/" + of.name +
                ".csv.\n";
    return text + "\n";
}

/// A block of code whose fence is longer than any in it.
std::string code(const std::string& text)
{
    std::string fence = "```";
    while (text.find(fence) != std::string::npos) fence += '`';
    return fence + "\n" + text + (text.ends_with('\n') ? "" : "\n") + fence + "\n\n";
}

}  // namespace

std::string to_markdown(const Document& document, const std::filesystem::path& folder)
{
    std::string text = "**" + plain(document.first_line) + "**\n\n";
    if (!document.doubts.empty()) text += std::string(before_the_doubts) + "\n\n";
    for (const std::string& doubt : document.doubts) text += "- " + plain(doubt) + "\n";
    if (!document.doubts.empty()) text += "\n";
    text += "# " + plain(document.title) + "\n\n" + plain(document.mechanism_line) + "\n\n";
    for (const Section& section : document.sections) {
        text += "## " + plain(section.title) + "\n\n";
        for (const std::string& paragraph : section.paragraphs) text += plain(paragraph) + "\n\n";
        for (const std::string& point : section.points) text += "- " + plain(point) + "\n";
        if (!section.points.empty()) text += "\n";
        for (const Picture& picture : section.pictures)
            text += std::string(picture.is_film ? "" : "!") + "[" + plain(picture.caption) + "](<" +
                    picture.file.lexically_relative(folder).generic_string() + ">)\n\n";
        for (const Table& one : section.tables) text += table(one, document.companions);
        if (!section.verbatim.empty()) text += code(section.verbatim);
    }
    return text;
}

std::string to_json(const Document& document)
{
    nlohmann::ordered_json json = {
        {"title", document.title},           {"outcome", document.outcome},
        {"first_line", document.first_line}, {"doubts", document.doubts},
        {"mechanism", document.mechanism},   {"mechanism_line", document.mechanism_line}};
    json["sections"] = nlohmann::ordered_json::array();
    for (const Section& section : document.sections) {
        nlohmann::ordered_json one = {
            {"title", section.title}, {"paragraphs", section.paragraphs}, {"points", section.points}};
        for (const Table& table : section.tables)
            one["tables"].push_back(
                {{"name", table.name}, {"title", table.title}, {"columns", table.columns}, {"rows", table.rows}});
        if (!section.verbatim.empty()) one["text"] = section.verbatim;
        json["sections"].push_back(one);
    }
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string to_csv(const Table& table)
{
    std::string text;
    const auto line = [&](const std::vector<std::string>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + words::csv_cell(cells[i]);
        text += "\n";
    };
    line(table.columns);
    for (const std::vector<std::string>& cells : table.rows) line(cells);
    return text;
}

}  // namespace voussoir::app::report
