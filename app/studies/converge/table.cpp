#include <fmt/format.h>

#include "app/studies/converge/conclusion.h"
#include "app/studies/converge/report.h"
#include "app/studies/converge/verdict.h"

namespace voussoir::app::studies::converge
{
namespace
{

std::string met_in_words(const Series& series, const SeriesRow& row)
{
    for (const double tolerance : tolerances)
        if (meets(series, row, tolerance)) return fmt::format("{:g} %", 100 * tolerance);
    return "-";
}

std::string series_table(const QuantityStudy& study, const Series& series)
{
    std::string text = fmt::format("  {}\n", title_of(series));
    text += fmt::format("    {:>9} {:>14} {:>10} {:>10} {:>6} {:>9} {:>9} {:>8} {:>6}\n", "", "value", "error",
                        "to next", "meets", "CPU s", "of static", "steps", "cuts");
    for (const SeriesRow& row : series.rows) {
        text += fmt::format("    {:>9} {:>14} {:>10} {:>10} {:>6} {:>9.3g} {:>9.3g} {:>8} {:>6}",
                            setting_in_words(series, row), value_in_words(row.value, study.unit),
                            error_of(series, row), share_in_words(row.difference), met_in_words(series, row),
                            row.cost.cpu(), row.cost.cpu_static, row.cost.steps, row.cost.step_cuts);
        const std::string remark = remark_of(row);
        text += (remark.empty() ? "" : "  " + remark) + "\n";
    }
    for (const std::string& line : verdict(study, series)) text += "    " + line + "\n";
    return text;
}

}  // namespace

std::string converge_table(const ConvergeStudy& study)
{
    std::string text = fmt::format("{}; collapse: {}\n", study.title, study.collapse_rule);
    for (const QuantityStudy& quantity : study.quantities) {
        text += "\n" + quantity.name + (quantity.added.empty() ? "" : " (" + quantity.added + ")") + "\n";
        for (const Series& series : quantity.series) text += series_table(quantity, series);
    }
    if (!study.notes.empty()) text += "\n";
    for (const std::string& note : study.notes) text += "note: " + note + "\n";
    text += "\n";
    for (const std::string& line : in_words(conclude(study))) text += line + "\n";
    return text;
}

}  // namespace voussoir::app::studies::converge
