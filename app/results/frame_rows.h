// What results.h5 holds once per frame.
#pragma once

#include "app/results/growing_rows.h"
#include "app/results/surface_mesh.h"
#include "libdda/analysis/ground.h"
#include "libdda/analysis/joint_openings.h"
#include "libdda/model/report.h"

namespace voussoir::app::results
{

/// The datasets under /frames.
std::vector<GrowingDataset> frame_datasets(const Model& model, const SurfaceMesh& mesh,
                                           const std::vector<WatchedJoint>& joints);

/// What displacements count from.
struct Rest {
    Foot foot;
    std::vector<double> coordinates;  // State::coordinates of the last frame before the first motion; may be empty
    bool is_over = false;             // that motion has begun
};

/// The rows of one frame. @param joints of the start of the run; @param first_contact rows that the tables of
/// contacts have already; raised by those of this frame
std::vector<Rows> frame_rows(const Model& model, const SurfaceMesh& mesh, const std::vector<WatchedJoint>& joints,
                             const Rest& rest, const State& state, const RunReport& report,
                             std::int64_t& first_contact);

}  // namespace voussoir::app::results
