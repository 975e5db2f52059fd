// The acceleration of the ground as pictures show it: an arrow at each support that has a motion of its own.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "app/results/results_reader.h"

namespace voussoir::app::render
{

/// An acceleration along one axis of space.
struct ShakingAlong {
    int axis = 0;
    double start = 0;                         // s of the run
    std::vector<double> times, acceleration;  // s since then, ascending; m/s2
};

/// What the foundations do that follow the same motions.
struct GroundShaking {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // m, middle of these foundations at the start of the run
    std::vector<ShakingAlong> along;
    double largest = 0;  // m/s2, of all supports over the run

    /// Linear between samples, 0 outside of the motions. @param time s of the run @returns m/s2
    Eigen::Vector3d acceleration(double time) const;
};

/// One for each set of motions that some foundation follows.
/// @throws InputError when no foundation follows a motion, or the file is damaged
std::vector<GroundShaking> shaking_of(const std::filesystem::path& file, const results::RecordedModel& model);

}  // namespace voussoir::app::render
