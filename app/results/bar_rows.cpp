#include "app/results/bar_rows.h"

#include <string>
#include <utility>

#include "libdda/analysis/bar_forces.h"

namespace voussoir::app::results
{

namespace
{

std::vector<std::string> names_of_bar_columns()
{
    return {"tension_N", "shear_N", "elongation_m", "yielded_m", "is_out"};
}

}  // namespace

void add_bar_datasets(const Model& model, std::vector<GrowingDataset>& datasets)
{
    if (model.bars.empty()) return;
    const std::vector<std::string> columns = names_of_bar_columns();
    datasets.push_back({"/frames/bars", ElementType::float64, {model.bars.size(), columns.size()}, columns});
}

void add_bar_rows(const Model& model, const State& state, std::vector<Rows>& rows)
{
    if (model.bars.empty()) return;
    std::vector<double> values;
    for (const BarNow& now : bars_now(model, state))
        values.insert(values.end(), {now.axial, now.shear, now.elongation, now.yielded, now.is_out ? 1.0 : 0.0});
    rows.push_back({"/frames/bars", std::move(values)});
}

}  // namespace voussoir::app::results
