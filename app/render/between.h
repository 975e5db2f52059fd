// What is seen between two stored frames.
#pragma once

#include "app/results/results_reader.h"

namespace voussoir::app::render
{

/// The frame at `time`, from the two about it: places, speeds, stresses and joints linear in time, turns along the
/// shortest way at an even rate. Contacts and the stage are those of `before`.
/// @param before, after of one run, before.time <= time <= after.time [s]
results::RecordedFrame between(Kinematics kinematics, const results::RecordedFrame& before,
                               const results::RecordedFrame& after, double time);

}  // namespace voussoir::app::render
