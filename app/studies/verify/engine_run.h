// Runs the engine on a scene and measures what came out against a reference.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/studies/scenes/sliding_scenes.h"
#include "app/studies/verify/benchmark.h"

namespace voussoir::app::studies::verify
{

/// Where a block was: displacement and velocity of its centroid since the motion began.
struct History {
    std::vector<double> times;                   // s
    std::vector<Eigen::Vector3d> displacements;  // m
    std::vector<Eigen::Vector3d> velocities;     // m/s; may be empty in a reference
};

struct EngineRun {
    History history;      // of the scene's block, at every accepted step
    VerifyResult result;  // counts and times; `failure` says why the history ends early
};

/// Brings the scene to rest under its weight, then moves it. CPU time covers both stages.
EngineRun run_engine(const scenes::SlidingScene& scene, const scenes::SceneSetting& setting);

/// max |u - u_ref| / max |u_ref| over all times; both histories at the same times.
double worst_error(const History& ours, const History& reference);

/// What is compared between unknowns: where the block is at the end [m].
std::vector<double> answer_of(const History& history);

/// Displacement against time, the reference beside it, along each axis on which it moves.
plots::Diagram picture_of(const History& ours, const History& reference);

/// The papers' measure: the largest |(|u_ref| - |u|) / |u_ref|| from `from` [s] on.
double worst_relative(const History& ours, const History& reference, double from);

/// Adds one more run of the same benchmark: the worst error counts, times and steps add up; the first picture
/// stays.
void add_run(VerifyResult& total, const VerifyResult& one);

}  // namespace voussoir::app::studies::verify
