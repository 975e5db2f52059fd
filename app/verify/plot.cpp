#include "app/verify/plot.h"

#include <fmt/format.h>

#include <algorithm>

namespace voussoir
{
namespace
{

/// One curve a method, of the rows that ran. @param abscissa picks x of a row
template <typename Abscissa>
std::vector<Curve> curves_of(const std::vector<PlotRow>& rows, bool of_stiffness, Abscissa abscissa)
{
    std::vector<Curve> curves;
    for (const PlotRow& row : rows) {
        if (!row.error || *row.error <= 0 || row.stiffness_factor.has_value() != of_stiffness) continue;
        auto curve =
            std::find_if(curves.begin(), curves.end(), [&](const Curve& each) { return each.name == row.method; });
        if (curve == curves.end()) curve = curves.insert(curves.end(), Curve{row.method, {}, {}});
        curve->x.push_back(abscissa(row));
        curve->y.push_back(*row.error);
    }
    return curves;
}

std::vector<std::string> failures(const std::vector<PlotRow>& rows)
{
    std::vector<std::string> notes;
    for (const PlotRow& row : rows) {
        if (row.error) continue;
        notes.push_back(fmt::format(
            "failed: {} at {:g} ms{}", row.method, 1e3 * row.time_step,
            row.stiffness_factor ? fmt::format(", stiffness x {:g}", *row.stiffness_factor) : std::string()));
    }
    return notes;
}

}  // namespace

Figure work_precision(const PlotData& data)
{
    std::vector<Level> levels{{"tolerance", data.tolerance}};
    if (data.paper_level) levels.push_back({"the paper's error", *data.paper_level});
    Figure figure{data.title, data.source, {}, failures(data.rows)};
    figure.diagrams.push_back({"time step [s]", "error [-]",
                               curves_of(data.rows, false, [](const PlotRow& row) { return row.time_step; }),
                               levels});
    figure.diagrams.push_back({"CPU time [s]", "error [-]",
                               curves_of(data.rows, false, [](const PlotRow& row) { return row.cpu_time; }),
                               levels});
    const Diagram stiffness{"contact stiffness / default [-]", "error [-]",
                            curves_of(data.rows, true, [](const PlotRow& row) { return *row.stiffness_factor; }),
                            levels};
    if (!stiffness.curves.empty()) figure.diagrams.push_back(stiffness);
    return figure;
}

}  // namespace voussoir
