// A block on a base that moves, and the block on springs it is compared with: what the maps of sliding and rocking
// share.
#pragma once

#include <vector>

#include "app/studies/stability/cell.h"
#include "app/studies/stability/references/block_on_springs.h"
#include "libdda/model/kinematics.h"
#include "libdda/model/model.h"
#include "libdda/model/step_control.h"

namespace voussoir::app::studies::stability
{

/// The engine's scene: a box on a wide held base whose ground acceleration is one sine pulse along x.
struct OneBlock {
    Kinematics kinematics = Kinematics::spatial_rigid;
    double length = 1, width = 1, height = 1;  // m, along x, y, z
    double density = 2000, young = 1e10;       // kg/m3, Pa
    double friction = 0;                       // -
    double stiffness = 1e8;                    // N/m, per contact point
    double amplitude = 0, period = 1;          // m/s2, s
    double pulse_end = 1;                      // s
    double duration = 1;                       // s
    double start_lean = 0;                     // rad, on its +x edge; 0: it stands
    Integrator integrator = Integrator::energy_decaying;
    double step_error = 0;  // m; 0: steps of one length
};

/// What the engine and the reference found at the end of every accepted step.
struct OneBlockHistory {
    std::vector<double> times;                         // s
    std::vector<references::SpringBlockPoint> engine;  // x relative to the base
    std::vector<references::SpringBlockPoint> exact;   // empty when the run gave up
};

/// Runs the engine, from rest, and counts into `cell`; then the reference at the same times.
OneBlockHistory run_one_block(const OneBlock& scene, double time_step, CellRun& cell);

/// A flat stone of 200 kg under a full sine of ground acceleration that it cannot follow. @param stiffness [N/m]
OneBlock sliding_block(double stiffness);

/// Error: largest distance from the reference in lean / largest lean of the reference. The duration is until it
/// has nearly come back from its first swing; of a block that falls over, until it leans by 0.5 rad.
CellRun run_swing(OneBlock scene, double time_step);

/// Error: largest distance from the reference in x / largest displacement of the reference.
CellRun run_sliding(const OneBlock& scene, double time_step);

}  // namespace voussoir::app::studies::stability
