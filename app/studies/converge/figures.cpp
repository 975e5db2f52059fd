#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "app/results/settings.h"
#include "app/studies/converge/report.h"
#include "app/studies/converge/verdict.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::converge
{
namespace
{

std::string file_name(std::size_t number, const std::string& quantity)
{
    std::string name = fmt::format("{:02}_", number + 1);
    for (const char c : quantity) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
        name += plain ? c : '_';
    }
    return name;
}

/// What is held against the tolerances: error and uncertainty of the reference together. Rows without one, or with
/// nothing a logarithmic scale could show, are left out.
/// @param abscissa picks x of a row
template <typename Abscissa>
plots::Curve curve_of(const Series& series, Abscissa abscissa)
{
    plots::Curve curve{std::string(results::name_of(series.integrator)), {}, {}};
    if (series.varied == Varied::stiffness) curve.name = title_of(series);
    for (const SeriesRow& row : series.rows) {
        const double together = row.error ? *row.error + series.uncertainty : 0;
        if (together <= 0 || !std::isfinite(together)) continue;
        curve.x.push_back(abscissa(row));
        curve.y.push_back(together);
    }
    return curve;
}

/// One curve a series; where there is no such series, nothing is added.
template <typename Abscissa>
void add_diagram(const QuantityStudy& study, Varied varied, const std::string& x_title, Abscissa abscissa,
                 plots::Figure& figure)
{
    plots::Diagram diagram{x_title, "estimated error with its uncertainty [-]", {}, {}};
    for (const Series& series : study.series)
        if (series.varied == varied) diagram.curves.push_back(curve_of(series, abscissa));
    for (const double tolerance : tolerances)
        diagram.levels.push_back({fmt::format("{:g} %", 100 * tolerance), tolerance, true});
    if (!diagram.curves.empty()) figure.diagrams.push_back(diagram);
}

std::vector<std::string> notes_of(const QuantityStudy& study)
{
    std::vector<std::string> notes;
    for (const Series& series : study.series) {
        for (const SeriesRow& row : series.rows)
            if (!row.failure.empty())
                notes.push_back(fmt::format("failed: {}, {}", title_of(series), setting_in_words(series, row)));
        const std::string title = title_of(series);
        if (!series.reference) notes.push_back(title + ": not compared, " + series.no_order);
        if (series.reference && !series.order) notes.push_back(title + ": no order, " + series.no_order);
    }
    return notes;
}

}  // namespace

std::vector<plots::Figure> converge_figures(const ConvergeStudy& study)
{
    const auto time_step = [](const SeriesRow& row) { return row.time_step; };
    const auto cpu_time = [](const SeriesRow& row) { return row.cost.cpu(); };
    const auto stiffness = [](const SeriesRow& row) { return row.setting.stiffness_factor; };
    std::vector<plots::Figure> figures;
    for (const QuantityStudy& quantity : study.quantities) {
        plots::Figure figure{
            file_name(figures.size(), quantity.name), study.title, quantity.name, {}, false, notes_of(quantity)};
        add_diagram(quantity, Varied::time_step, "time step [s]", time_step, figure);
        add_diagram(quantity, Varied::time_step, "CPU time [s]", cpu_time, figure);
        add_diagram(quantity, Varied::stiffness, "contact stiffness / the case's [-]", stiffness, figure);
        figures.push_back(figure);
    }
    return figures;
}

}  // namespace voussoir::app::studies::converge
