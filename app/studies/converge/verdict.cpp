#include "app/studies/converge/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/results/settings.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::converge
{
namespace
{

std::string cost_in_words(const RunCost& cost)
{
    return fmt::format("{:.3g} s CPU", cost.cpu());
}

std::string order_in_words(const QuantityStudy& study, const Series& series)
{
    if (!series.reference) return "not compared: " + series.no_order;
    const std::string reference = value_in_words(series.reference, study.unit);
    const std::string limit = series.varied == Varied::time_step ? "time step 0" : "rigid contact";
    if (series.order)
        return fmt::format(
            "observed order {:.2f}; reference: extrapolated to {}, {}, uncertain by {}{}", *series.order, limit,
            reference, share_in_words(series.uncertainty),
            series.vanishes ? "; it cannot be distinguished from 0: errors are fractions of the finest run" : "");
    if (series.vanishes)
        return fmt::format(
            "no order: {}; reference: the finest run, which is 0: errors are fractions of the largest run",
            series.no_order);
    if (std::isinf(series.uncertainty))
        return fmt::format("no order: {}; nothing to compare with", series.no_order);
    return fmt::format("no order: {}; reference: the finest run, {}, uncertain by {}", series.no_order, reference,
                       share_in_words(series.uncertainty));
}

std::string cheapest_in_words(const Series& series, double tolerance)
{
    const SeriesRow* row = cheapest(series, tolerance);
    return fmt::format("{} ({})", setting_in_words(series, *row), cost_in_words(row->cost));
}

/// "x 1, x 2, x 4; cheapest: x 1 (7.2 s CPU)".
std::string all_within(const Series& series, double tolerance)
{
    std::string text;
    for (const SeriesRow& row : series.rows)
        if (meets(series, row, tolerance)) text += (text.empty() ? "" : ", ") + setting_in_words(series, row);
    return text.empty() ? "none of these" : text + "; cheapest: " + cheapest_in_words(series, tolerance);
}

std::string sensitivity_in_words(const Series& series)
{
    const std::optional<double> change = change_per_doubling(series);
    if (!change) return "sensitivity: unknown, because neighbouring runs are missing";
    return fmt::format("sensitivity: doubling the contact stiffness changes it by {}", share_in_words(change));
}

/// The cheapest for each tolerance that any setting meets, and what comes closest where none does.
void add_cheapest(const Series& series, std::vector<std::string>& lines)
{
    std::string missed;
    for (const double tolerance : tolerances) {
        if (cheapest(series, tolerance) != nullptr)
            lines.push_back(fmt::format("cheapest that meets {:g} %: {}", 100 * tolerance,
                                        cheapest_in_words(series, tolerance)));
        else
            missed += fmt::format("{}{:g} %", missed.empty() ? "" : " or ", 100 * tolerance);
    }
    if (missed.empty()) return;
    const SeriesRow* best = nullptr;
    for (const SeriesRow& row : series.rows)
        if (row.error && (!best || *row.error < *best->error)) best = &row;
    if (best == nullptr || std::isinf(series.uncertainty))
        lines.push_back("none is known to meet " + missed);
    else
        lines.push_back(fmt::format("none is known to meet {}; closest: {}, to {}", missed,
                                    setting_in_words(series, *best),
                                    share_in_words(*best->error + series.uncertainty)));
}

}  // namespace

std::string title_of(const Series& series)
{
    const std::string integrator(results::name_of(series.integrator));
    if (series.varied == Varied::time_step) return "time step, " + integrator;
    if (series.is_static) return "contact stiffness";
    return fmt::format("contact stiffness, {}, at {}", integrator,
                       words::step_in_words(series.rows.front().time_step));
}

std::string setting_in_words(const Series& series, const SeriesRow& row)
{
    if (series.varied == Varied::time_step) return words::step_in_words(row.time_step);
    return fmt::format("x {:g}", row.setting.stiffness_factor);
}

std::string value_in_words(const std::optional<double>& value, const std::string& unit)
{
    if (!value) return "-";
    return fmt::format("{:.5g}{}{}", *value, unit.empty() ? "" : " ", unit);
}

std::string share_in_words(const std::optional<double>& share)
{
    return share ? fmt::format("{:.3g} %", 100 * *share) : "-";
}

std::string error_of(const Series& series, const SeriesRow& row)
{
    const bool is_reference = series.reference && !series.order && row.value && !row.difference;
    return is_reference ? "reference" : share_in_words(row.error);
}

std::string remark_of(const SeriesRow& row)
{
    if (!row.failure.empty()) return "failed: " + row.failure;
    if (row.collapse)
        return fmt::format("collapsed at {:.4g} s, block '{}'", row.collapse->time, row.collapse->block);
    return {};
}

std::optional<double> change_per_doubling(const Series& series)
{
    std::optional<double> change;
    for (std::size_t i = 0; i + 1 < series.rows.size(); ++i) {
        const SeriesRow &soft = series.rows[i], &stiff = series.rows[i + 1];
        if (!soft.difference || !stiff.value) continue;
        const double doublings = std::log2(stiff.setting.stiffness_factor / soft.setting.stiffness_factor);
        change = *soft.value == 0 ? 0 : *soft.difference * series.scale / std::abs(*soft.value) / doublings;
        if (soft.setting.stiffness_factor >= 1) break;
    }
    return change;
}

std::vector<std::string> verdict(const QuantityStudy& study, const Series& series)
{
    std::vector<std::string> lines{order_in_words(study, series)};
    if (series.reference && series.varied == Varied::time_step) {
        add_cheapest(series, lines);
    } else if (series.reference) {
        lines.push_back(sensitivity_in_words(series));
        for (const double tolerance : tolerances)
            lines.push_back(fmt::format("within {:g} % of the {}: {}", 100 * tolerance,
                                        series.order ? "rigid limit" : "stiffest", all_within(series, tolerance)));
    }
    lines.insert(lines.end(), series.notes.begin(), series.notes.end());
    return lines;
}

}  // namespace voussoir::app::studies::converge
