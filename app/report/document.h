// A report as data, whatever it is written as.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace voussoir::app::report
{

/// What stands before the doubts of a document.
constexpr const char* before_the_doubts = "Before you use these figures:";

struct Table {
    std::string name;  // of its CSV file, without ending
    std::string title;
    std::vector<std::string> columns;            // with units
    std::vector<std::vector<std::string>> rows;  // (rows x columns)
    std::size_t shown = 25;                      // rows on the page; the CSV file has all
};

struct Picture {
    std::filesystem::path file;  // PNG, or a film
    std::string caption;
    bool is_film = false;
};

struct Section {
    std::string title;
    std::vector<std::string> paragraphs;
    std::vector<std::string> points;  // a list
    std::vector<Table> tables;
    std::vector<Picture> pictures;
    std::string verbatim;   // as it was written, line by line
    bool has_view = false;  // the interactive view stands here, on a page
};

/// A script, and the hash by which a page's policy lets it run.
struct ViewScript {
    std::string hash, text;  // "sha256-..."; both empty where there is none
};

/// What makes a page's interactive view.
struct InteractiveView {
    ViewScript script;
    std::string data;  // JSON without "<"; empty: no view
};

struct Document {
    std::string title;
    std::string outcome;              // of the run, as in summary.json; "unfinished" of one that was killed
    std::string first_line;           // what became of it, in words
    bool alarm = false;               // it did not go as planned
    std::vector<std::string> doubts;  // what a reader must know before using any figure, one sentence each
    std::string mechanism;            // name_of(MechanismKind)
    std::string mechanism_line;       // in words
    std::vector<Section> sections;
    InteractiveView view;
    std::string companions = "report";  // folder of its tables and pictures
};

/// One page with all pictures in it, which asks nothing of any network and prints.
std::string to_html(const Document& document);

/// The same as Markdown. @param folder that the names of its pictures begin from
std::string to_markdown(const Document& document, const std::filesystem::path& folder);

/// The same as JSON, without the pictures.
std::string to_json(const Document& document);

/// A table as comma-separated values. Texts that a spreadsheet would take for a formula are made plain.
std::string to_csv(const Table& table);

}  // namespace voussoir::app::report
