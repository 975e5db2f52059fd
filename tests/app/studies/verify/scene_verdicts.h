// What the engine says at rest of structures whose limit is known to limit analysis.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/verify/limit_scenes.h"
#include "libdda/limit/balance.h"
#include "libdda/limit/limit_analysis.h"
#include "libdda/limit/limit_factor.h"
#include "libdda/run/run.h"

namespace voussoir::app::studies::verify
{

constexpr std::uint64_t limit_scene_seed = 1;
constexpr double verdict_gravity = 9.81;  // m/s2

/// What became of all scenes.
struct VerdictCounts {
    int scenes = 0, left_out = 0;            // without a limit under a push
    int sharp = 0, open = 0;                 // scenes with one limit; verdicts that friction leaves open
    int verdicts = 0, undecided = 0;         // of all
    std::int64_t standing = 0, falling = 0;  // iterations, of verdicts that friction does not leave open
    int stood = 0, fell = 0;                 // such verdicts
};

inline limit::LimitProblem pushed_problem(const limit::LimitProblem& problem, double factor)
{
    limit::LimitProblem pushed = problem;
    for (limit::LimitBlock& block : pushed.blocks) block.dead += factor * block.live;
    return pushed;
}

/// A static stage as a case file has it, with gravity that leans along +x by a share of itself.
inline RunReport rest_under(const Model& model, double factor)
{
    Stage stage;
    stage.name = "rest";
    stage.type = StageType::static_equilibrium;
    stage.gravity = {factor * verdict_gravity, 0, -verdict_gravity};
    stage.control.time_step = 1;
    State state = initial_state(model);
    return run(model, {stage}, state, {});
}

inline bool says_that_friction_leaves_it_open(const RunReport& report)
{
    return std::any_of(report.warnings.begin(), report.warnings.end(),
                       [](const Diagnosis& warning) { return warning.kind == DiagnosisKind::friction_open; });
}

/// Judges a scene at shares of its capacity: beyond it falls; below it stands where stones that slide without
/// opening stand as well; where they may not, it may do either and says so.
inline void judge_scene(std::uint64_t seed, int n, bool rigid, const std::vector<double>& shares,
                        VerdictCounts& counts)
{
    const LimitMasonry scene = limit_scene(seed, n, rigid);
    const Model model = limit_scene(seed, n, true).model;
    const limit::LimitProblem problem = limit_problem(model), faces = limit_problem(model, limit::FacePoints::all);
    const std::optional<double> capacity = limit::limit_factor(problem);
    ++counts.scenes;
    if (!capacity) {
        ++counts.left_out;
        return;
    }
    const auto slides = [&](double share) {
        return limit::standing_without_dilatancy(pushed_problem(faces, share * *capacity)) !=
               limit::Standing::balanced;
    };
    const bool sharp = !slides(0.998);
    counts.sharp += sharp;
    bool fell = false;
    for (const double share : shares) {
        const std::string what = std::to_string(n) + (rigid ? ", rigid: " : ", deformable: ") + scene.description +
                                 ", at " + std::to_string(share) + " of " + std::to_string(*capacity);
        const RunReport report = rest_under(scene.model, share * *capacity);
        ++counts.verdicts;
        const bool stands = report.outcome == Outcome::completed;
        // Where it begins to slide is known to some 0.3 %.
        const bool is_open = share < 1 && !sharp && slides(1.003 * share);
        if (is_open) {
            ++counts.open;
            counts.undecided += report.outcome == Outcome::undecided;
            EXPECT_TRUE((stands && !slides(share)) || report.outcome == Outcome::undecided ||
                        says_that_friction_leaves_it_open(report))
                << what;
            continue;
        }
        EXPECT_EQ(report.outcome, share < 1 ? Outcome::completed : Outcome::collapsed) << what;
        EXPECT_FALSE(stands && fell) << what << ": it fell under less";
        fell = fell || report.outcome == Outcome::collapsed;
        (stands ? counts.standing : counts.falling) += report.open_close_iterations;
        ++(stands ? counts.stood : counts.fell);
    }
}

}  // namespace voussoir::app::studies::verify
