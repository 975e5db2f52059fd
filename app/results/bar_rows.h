// What results.h5 holds of bars once per frame. Nothing in a scene without.
#pragma once

#include <vector>

#include "app/results/growing_rows.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::app::results
{

/// Adds the dataset of bars.
void add_bar_datasets(const Model& model, std::vector<GrowingDataset>& datasets);

/// Adds its row of one frame.
void add_bar_rows(const Model& model, const State& state, std::vector<Rows>& rows);

}  // namespace voussoir::app::results
