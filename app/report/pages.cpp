#include "app/report/pages.h"

#include <algorithm>
#include <cmath>

#include "app/plots/plots.h"
#include "app/results/atomic_file.h"
#include "app/results/own_folder.h"
#include "libdda/errors.h"

namespace voussoir::app::report
{

namespace fs = std::filesystem;

double visible_magnification(const RunRecord& record)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& centroid : record.results.model.centroids) box.extend(centroid);
    const double size = box.isEmpty() ? 0 : box.diagonal().norm();
    const double largest =
        record.course.displacement.empty()
            ? 0
            : *std::max_element(record.course.displacement.begin(), record.course.displacement.end());
    if (!(largest > 0) || largest > 1e-3 * size) return 1;
    const double wanted = std::min(0.02 * size / largest, 1e4),
                 power = std::pow(10, std::floor(std::log10(wanted)));
    return wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
}

void attempt(Section& section, const char* what, const std::function<void()>& draw)
{
    try {
        draw();
    } catch (const InputError& error) {
        section.paragraphs.push_back(std::string(what) + ": " + error.what() + ".");
    }
}

void add_diagrams(const std::vector<NamedFigure>& figures, const fs::path& folder, std::vector<Section>& sections)
{
    std::vector<plots::Figure> drawn;
    drawn.reserve(figures.size());
    for (const NamedFigure& figure : figures) drawn.push_back(figure.figure);
    if (drawn.empty()) return;
    try {
        plots::draw_figures(drawn, folder);
    } catch (const InputError& error) {
        sections.front().paragraphs.push_back(std::string("There are no diagrams: ") + error.what() + ".");
        return;
    }
    for (const NamedFigure& figure : figures)
        for (Section& section : sections)
            if (section.title == figure.section)
                section.pictures.push_back({folder / (figure.figure.name + ".png"), figure.caption});
}

void drop_empty_sections(Document& document)
{
    std::erase_if(document.sections, [](const Section& section) {
        return section.paragraphs.empty() && section.points.empty() && section.tables.empty() &&
               section.pictures.empty() && section.verbatim.empty();
    });
}

fs::path companions_folder(const fs::path& folder, const std::string& name)
{
    const fs::path companions = fs::absolute(folder) / name;
    results::make_own_folder(companions);
    return companions;
}

std::vector<fs::path> write_document(const Document& document, const fs::path& folder, const std::string& name)
{
    for (const Section& section : document.sections)
        for (const Table& table : section.tables)
            results::write_atomically(fs::absolute(folder) / name / (table.name + ".csv"), to_csv(table));
    const std::vector<fs::path> files = {folder / (name + ".html"), folder / (name + ".md"),
                                         folder / (name + ".json")};
    results::write_atomically(files[1], to_markdown(document, fs::absolute(folder)));
    results::write_atomically(files[2], to_json(document));
    results::write_atomically(files[0], to_html(document));
    return {files[0], files[1], files[2], folder / name};
}

}  // namespace voussoir::app::report
