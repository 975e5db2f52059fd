#include "app/report/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/render/snapshots.h"
#include "app/report/comparison_tables.h"
#include "app/report/curves.h"
#include "app/report/mechanism_words.h"
#include "app/report/pages.h"
#include "app/report/point_history.h"
#include "app/report/sections.h"
#include "app/words/lines.h"

namespace voussoir::app::report
{
namespace
{

namespace fs = std::filesystem;

/// The names by which two runs are told apart: those of their folders, or else of their files.
std::pair<std::string, std::string> labels_of(const RunRecord& a, const RunRecord& b)
{
    const std::string folder_a = a.file.parent_path().filename().string(),
                      folder_b = b.file.parent_path().filename().string();
    if (folder_a != folder_b) return {"A: " + folder_a, "B: " + folder_b};
    return {"A: " + a.file.string(), "B: " + b.file.string()};
}

Section outcome_section(const RunRecord& a, const RunRecord& b)
{
    Section section{"How they moved", {}, {}, {}, {}, {}};
    for (const auto& [name, record] : {std::pair<const char*, const RunRecord*>{"A", &a}, {"B", &b}}) {
        const MechanismWords words = words_of(record->mechanism, record->results.model, record->course);
        section.paragraphs.push_back(fmt::format("{}: {}", name, words.headline));
        for (std::size_t i = 0; i < std::min<std::size_t>(5, words.joints.size()); ++i)
            section.points.push_back(fmt::format("{}: {}", name, words.joints[i]));
    }
    return section;
}

Section differences_section(const RunRecord& a, const RunRecord& b)
{
    Section section{"What differs", {}, {}, {}, {}, {}};
    const auto with_overrides = [](const RunRecord& record) {
        std::string text = record.case_text;
        for (const std::string& change : record.overrides) text += "\n--set " + change;
        return text;
    };
    const std::string text_a = with_overrides(a), text_b = with_overrides(b);
    for (const std::string& line : lines_only_in(text_a, text_b)) section.verbatim += "A  " + line + "\n";
    for (const std::string& line : lines_only_in(text_b, text_a)) section.verbatim += "B  " + line + "\n";
    section.paragraphs.emplace_back(section.verbatim.empty() ? "Both have the same case file."
                                                             : "Lines of the case file that the other has not:");
    if (a.engine != b.engine)
        section.paragraphs.push_back("Made by different engines: A by " + a.engine + "; B by " + b.engine + ".");
    return section;
}

/// Both runs with the same camera and the same colours.
struct Both {
    const RunRecord &a, &b;
    render::Beside beside;
    double magnification = 1;
    double start = 0, end = 0;  // s
};

Section pictures_of(const Both& both, const fs::path& folder)
{
    Section section{"Pictures", {}, {}, {}, {}, {}};
    SnapshotOptions options;
    options.width = 1600;
    options.height = 720;
    options.deformation_scale = both.magnification;
    const double described = std::max(both.a.mechanism.time, both.b.mechanism.time);
    options.times = {described};
    if (both.end > described) options.times.push_back(both.end);
    attempt(section, "There are no pictures", [&] {
        for (const fs::path& picture : render::render_snapshots(both.a.file, folder, options, &both.beside)) {
            const std::string name = picture.stem().string();
            section.pictures.push_back({picture, "Displacement " + results::counted_from(both.a.results.model) +
                                                     ", " + name.substr(std::min(name.find("t="), name.size())) +
                                                     ", A on the left, B on the right, one scale for both."});
        }
    });
    return section;
}

Section film_of(const Both& both, const fs::path& folder, const std::function<void(int, int)>& told)
{
    Section section{"Film", {}, {}, {}, {}, {}};
    if (!(both.end > both.start)) return section;
    FilmOptions options;
    options.width = 1280;
    options.height = 540;
    options.slow_down = std::clamp(std::round(6 / (both.end - both.start)), 1.0, 1e4);
    options.deformation_scale = both.magnification;
    attempt(section, "There is no film", [&] {
        render::request_film(both.a.file, folder / "film.mp4", options, told, &both.beside);
        section.pictures.push_back(
            {folder / "film.mp4",
             fmt::format("A on the left, B on the right, slowed down {:g} times.", options.slow_down), true});
    });
    return section;
}

/// The same of both runs over time, one diagram a quantity.
NamedFigure courses_of(const RunRecord& a, const RunRecord& b)
{
    std::vector<plots::Diagram> diagrams;
    const auto add = [&](const char* title, const std::vector<double> Course::*list, double unit) {
        diagrams.push_back(over_time(title, {thinned("A", a.course.times, a.course.*list, unit),
                                             thinned("B", b.course.times, b.course.*list, unit)}));
    };
    add("displacement [mm]", &Course::displacement, 1e-3);
    add("joint opening [mm]", &Course::opening, 1e-3);
    add("joint slip [mm]", &Course::slip, 1e-3);
    return {figure_of("courses", "The largest of each at every moment", diagrams), "Histories",
            "The largest displacement (since the motion began), opening and slip at every stored moment."};
}

/// Histories of the points that both have, up to six of them.
NamedFigure histories_of(const RunRecord& a, const RunRecord& b)
{
    std::vector<plots::Diagram> diagrams;
    for (const std::string& name : a.histories.names) {
        const bool moves = name.find(" ux") != std::string::npos || name.find(" uz") != std::string::npos;
        if (!moves || is_of_foot(name) || diagrams.size() == 6) continue;
        if (std::find(b.histories.names.begin(), b.histories.names.end(), name) == b.histories.names.end())
            continue;
        const auto curve = [&](const char* label, const RunRecord& record) {
            const PointHistory history = point_history(record, name);
            return thinned(label, history.times, history.moved, 1e-3);
        };
        diagrams.push_back(over_time(name.substr(0, name.find(" [")) + " [mm]", {curve("A", a), curve("B", b)}));
    }
    return {figure_of("histories", "Displacements of the chosen points", diagrams), "Histories",
            "Displacements of the points that both have, " + results::counted_from(a.results.model) + "."};
}

std::vector<NamedFigure> figures_of(const RunRecord& a, const RunRecord& b)
{
    std::vector<NamedFigure> figures;
    if (a.course.times.size() > 1 && b.course.times.size() > 1) figures.push_back(courses_of(a, b));
    NamedFigure histories = histories_of(a, b);
    if (!histories.figure.diagrams.empty()) figures.push_back(std::move(histories));
    return figures;
}

Document document_of(const RunRecord& a, const RunRecord& b, const fs::path& folder, bool film,
                     const std::function<void(int, int)>& told)
{
    const auto [label_a, label_b] = labels_of(a, b);
    Document document;
    document.companions = "comparison";
    document.title = label_a + " and " + label_b;
    document.outcome = a.end.outcome == b.end.outcome ? a.end.outcome : a.end.outcome + ", " + b.end.outcome;
    document.first_line = "A: " + first_line_of(a) + " B: " + first_line_of(b);
    document.alarm = is_alarming(a) || is_alarming(b);
    for (const std::string& doubt : a.doubts) document.doubts.push_back("A: " + doubt);
    for (const std::string& doubt : b.doubts) document.doubts.push_back("B: " + doubt);
    document.mechanism = std::string(name_of(a.mechanism.kind)) + ", " + name_of(b.mechanism.kind);
    document.mechanism_line = "A: " + a.results.model.title + ". B: " + b.results.model.title + ".";
    const Both both{a,
                    b,
                    {b.file, label_a, label_b},
                    std::min(visible_magnification(a), visible_magnification(b)),
                    std::min(a.course.times.front(), b.course.times.front()),
                    std::max(a.course.times.back(), b.course.times.back())};
    document.sections = {key_figures_compared(a, b), outcome_section(a, b), pictures_of(both, folder)};
    if (film) document.sections.push_back(film_of(both, folder, told));
    document.sections.push_back({"Histories", {}, {}, {}, {}, {}});
    document.sections.push_back(bars_compared(a, b));
    document.sections.push_back(stones_compared(a, b));
    document.sections.push_back(computations_compared(a, b));
    document.sections.push_back(differences_section(a, b));
    add_diagrams(figures_of(a, b), folder, document.sections);
    drop_empty_sections(document);
    return document;
}

}  // namespace

std::vector<std::string> lines_only_in(const std::string& one, const std::string& other)
{
    std::map<std::string, int> there;
    for (const std::string& line : words::lines_of(other)) ++there[line];
    std::vector<std::string> only;
    for (const std::string& line : words::lines_of(one))
        if (there[line]-- <= 0 && line.find_first_not_of(" \t\r") != std::string::npos) only.push_back(line);
    return only;
}

std::vector<fs::path> make_comparison(const fs::path& a, const fs::path& b, const fs::path& folder, bool film,
                                      const std::function<void(int done, int all)>& told)
{
    const RunRecord first(fs::absolute(a)), second(fs::absolute(b));
    const fs::path companions = companions_folder(folder, "comparison");
    return write_document(document_of(first, second, companions, film, told), folder, "comparison");
}

}  // namespace voussoir::app::report
