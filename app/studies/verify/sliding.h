// What the benchmarks of sliding blocks share: run the engine, run the reference at the same times, compare.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "app/studies/verify/engine_run.h"
#include "app/studies/verify/references/sliding.h"

namespace voussoir::app::studies::verify
{

/// Times the documented default contact stiffness, in the diagrams of sliding blocks.
inline const std::vector<double> stiffness_factors{1e-4, 1e-3, 1e-2, 1e-1, 1, 10, 100};

/// Displacement of the block [m] as a function of time since the motion began [s].
using ClosedForm = std::function<Eigen::Vector3d(double)>;

/// @param paper_from the papers' measure |(|u_ref| - |u|) / |u_ref|| is taken from this time on [s]
VerifyResult compare_sliding(const scenes::SlidingScene& scene, const scenes::SceneSetting& setting,
                             double paper_from, const ClosedForm& closed_form);

/// @param base displacement of the base [m], added to that of the block relative to it
VerifyResult compare_sliding(const scenes::SlidingScene& scene, const scenes::SceneSetting& setting,
                             double paper_from, const references::SlidingProblem& problem,
                             const ClosedForm& base = {});

/// The reference at the times of a run: of the base, plus of the block on it in x and y.
History reference_history(const references::SlidingProblem& problem, const std::vector<double>& times,
                          const ClosedForm& base = {});

}  // namespace voussoir::app::studies::verify
