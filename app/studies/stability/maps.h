// The failure map as pictures: heat maps over stiffness and time step, and a table of the extreme scenes.
#pragma once

#include <vector>

#include "app/plots/diagram.h"
#include "app/studies/stability/runner.h"

namespace voussoir::app::studies::stability
{

/// A heat map for each scene over stiffness and time step of which a cell was run, then one table of all others.
/// @param scenes all scenes; @param results of the cells that were run
std::vector<plots::Figure> stability_figures(const std::vector<StabilityScene>& scenes,
                                             const std::vector<CellResult>& results);

/// "0.13 %", "no answer", or the outcome where there is no error.
std::string result_in_words(const CellResult& result);

}  // namespace voussoir::app::studies::stability
