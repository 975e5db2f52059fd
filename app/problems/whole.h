// A whole run by the fast iteration beside the same run by the plain one.
#pragma once

#include <vector>

#include "app/case/case.h"
#include "libdda/model/report.h"

namespace voussoir::app::problems
{

/// What a run came to.
struct WholeRun {
    RunReport report;
    double seconds = 0;   // of CPU
    double parting = -1;  // s of the run's time, of the first impact or the first step that was cut; < 0: none
    // Centroids (blocks x 3) [m] after each nominal step in time before that, the start of motion first.
    std::vector<std::vector<double>> centroids;
};

/// Both runs and how they differ.
struct WholeComparison {
    WholeRun fast, plain;
    int frames = 0;         // nominal steps that were compared
    double difference = 0;  // largest, of a centroid, in units of tolerance x g h^2 / 2 x (steps so far)^(3/2)
    double by_steps = 0;    // the same in units of tolerance x g h^2 / 2 x steps so far
    double input = 0, dissipated = 0;  // shares by which the energies differ at the end
    bool one_outcome = false;
    /// At most ten units before the first impact or cut; then one outcome and energies within 5 %.
    bool passes() const;
};

/// Both begin their motion alike: static stages are the fast iteration's in both runs. What a step leaves
/// unbalanced stays as a velocity, tolerance x g h, and those of many steps add up as a random walk does: ways
/// differ by the power 3/2 of their number.
WholeComparison compare_whole(const Case& the_case);

}  // namespace voussoir::app::problems
