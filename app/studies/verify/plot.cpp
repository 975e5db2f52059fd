#include "app/studies/verify/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/studies/verify/settings.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::verify
{
namespace
{

/// One curve a method, of the rows that ran. @param abscissa picks x of a row
template <typename Abscissa>
std::vector<plots::Curve> curves_of(const std::vector<VerifyRow>& rows, bool of_stiffness, Abscissa abscissa)
{
    std::vector<plots::Curve> curves;
    for (const VerifyRow& row : rows) {
        const bool drawable = row.result.failure.empty() && row.result.error > 0;
        if (!drawable || row.setting.stiffness_factor.has_value() != of_stiffness) continue;
        const std::string name = method_name(row.setting);
        auto curve = std::find_if(curves.begin(), curves.end(),
                                  [&](const plots::Curve& each) { return each.name == name; });
        if (curve == curves.end()) curve = curves.insert(curves.end(), plots::Curve{name, {}, {}});
        curve->x.push_back(abscissa(row));
        curve->y.push_back(row.result.error);
    }
    return curves;
}

std::string in_words(const scenes::SceneSetting& setting)
{
    const std::optional<double>& factor = setting.stiffness_factor;
    return fmt::format("{} at {}{}", method_name(setting), words::step_in_words(setting.time_step),
                       factor ? fmt::format(", stiffness x {:g}", *factor) : std::string());
}

/// What the axes cannot show: runs that failed, and runs without any error.
std::vector<std::string> notes_on(const std::vector<VerifyRow>& rows)
{
    std::vector<std::string> notes;
    for (const VerifyRow& row : rows) {
        if (!row.result.failure.empty())
            notes.push_back("failed: " + in_words(row.setting));
        else if (row.result.error == 0)
            notes.push_back("no error at all: " + in_words(row.setting));
    }
    return notes;
}

}  // namespace

plots::Figure work_precision(const VerifyOutcome& outcome)
{
    const Benchmark& benchmark = outcome.benchmark;
    const std::vector<VerifyRow>& rows = outcome.rows;
    std::vector<plots::Level> levels;
    if (benchmark.tolerance > 0) levels.push_back({"tolerance", benchmark.tolerance, true});
    if (benchmark.paper_level) levels.push_back({"the paper's error", *benchmark.paper_level, false});
    plots::Figure figure{benchmark.name, benchmark.title, benchmark.source, {}, false, notes_on(rows)};
    const auto add = [&](const std::string& x_title, std::vector<plots::Curve> curves) {
        if (!curves.empty()) figure.diagrams.push_back({x_title, "error [-]", std::move(curves), levels});
    };
    add("time step [s]", curves_of(rows, false, [](const VerifyRow& row) { return row.setting.time_step; }));
    add("CPU time [s]", curves_of(rows, false, [](const VerifyRow& row) { return row.result.cpu_time; }));
    add("contact stiffness / default [-]",
        curves_of(rows, true, [](const VerifyRow& row) { return *row.setting.stiffness_factor; }));
    return figure;
}

plots::Figure picture(const VerifyOutcome& outcome)
{
    const Benchmark& benchmark = outcome.benchmark;
    const VerifyRow& row = outcome.row;
    plots::Figure figure{benchmark.name + "-run",
                         benchmark.title,
                         method_name(row.setting) + ", " + words::step_in_words(row.setting.time_step),
                         {},
                         false,
                         {}};
    if (!row.result.picture.curves.empty()) figure.diagrams.push_back(row.result.picture);
    return figure;
}

}  // namespace voussoir::app::studies::verify
