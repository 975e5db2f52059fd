#include "app/studies/converge/series.h"

namespace voussoir::app::studies::converge
{
namespace
{

/// What the error falls with: the time step, or the compliance of the joints.
double step_of(Varied varied, const SeriesRow& row)
{
    return varied == Varied::time_step ? row.time_step : 1 / row.setting.stiffness_factor;
}

}  // namespace

void judge(Series& series, const std::vector<std::optional<Sample>>& samples, double resolution,
           const std::function<double(const Sample&)>& value)
{
    std::vector<Sample> compared;
    std::vector<double> steps;
    std::vector<SeriesRow*> rows;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!samples[i]) continue;
        rows.push_back(&series.rows[i]);
        compared.push_back(*samples[i]);
        steps.push_back(step_of(series.varied, series.rows[i]));
        series.rows[i].value = value(*samples[i]);
    }
    if (rows.empty()) {
        series.no_order = "no run gave a value";
        return;
    }
    const Estimate found = estimate(compared, steps, resolution);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i]->error = found.errors[i];
        if (i < found.differences.size()) rows[i]->difference = found.differences[i];
    }
    series.order = found.order;
    series.no_order = found.no_order;
    series.reference = value(found.reference);
    series.uncertainty = found.uncertainty;
    series.scale = found.scale;
    series.vanishes = found.vanishes;
}

bool meets(const Series& series, const SeriesRow& row, double tolerance)
{
    return row.error && *row.error + series.uncertainty <= tolerance;
}

const SeriesRow* cheapest(const Series& series, double tolerance)
{
    const SeriesRow* best = nullptr;
    for (const SeriesRow& row : series.rows)
        if (meets(series, row, tolerance) && (!best || row.cost.cpu_to_compare() < best->cost.cpu_to_compare()))
            best = &row;
    return best;
}

}  // namespace voussoir::app::studies::converge
