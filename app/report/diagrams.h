// The diagrams of a report, as data for the helper program that draws.
#pragma once

#include <vector>

#include "app/plots/diagram.h"
#include "app/report/run_record.h"

namespace voussoir::app::report
{

struct NamedFigure {
    plots::Figure figure;
    std::string section;  // title of the one it belongs to
    std::string caption;
};

/// Motion and spectrum, histories, openings and slips, base shear against drift, energies, steps: those of which
/// the run has something.
std::vector<NamedFigure> diagrams_of(const RunRecord& record);

}  // namespace voussoir::app::report
