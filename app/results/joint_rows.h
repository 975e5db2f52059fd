// What results.h5 holds of the joints: once what they were at the start, for each frame what they do, at the end
// the most they have done.
#pragma once

#include <span>

#include "app/results/growing_rows.h"
#include "libdda/analysis/joints_now.h"

namespace voussoir::app::results
{

/// Writes /joints, of the start. Of a scene without joints there is none.
void write_joints(const Model& model, const std::vector<WatchedJoint>& joints, Hdf5File& file);

/// Adds the datasets under /frames/joints, a row of all joints for each frame.
void add_joint_datasets(const std::vector<WatchedJoint>& joints, std::vector<GrowingDataset>& datasets);

/// Adds their rows of one frame.
void add_joint_rows(const std::vector<WatchedJoint>& joints, const std::vector<JointNow>& now,
                    std::vector<Rows>& rows);

/// Writes the most that each joint has done, beside /summary. NaN: never.
void write_joint_peaks(std::span<const JointPeaks> peaks, Hdf5File& file);

}  // namespace voussoir::app::results
