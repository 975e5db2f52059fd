// The thickness, and the push, at which a pattern ceases to stand, by linear programming, and what the engine says
// on both sides of it.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/studies/verify/limit_masonry.h"
#include "app/studies/verify/references/limit_analysis.h"
#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{

/// Rigid stones under their own weight alone.
inline const std::vector<std::string> under_own_weight{"kinematics=spatial_rigid", "stages[1]=null"};

/// Whether the static stage of an entry comes to rest.
inline bool stands(const std::string& entry, std::vector<std::string> overrides = {})
{
    overrides.insert(overrides.end(), under_own_weight.begin(), under_own_weight.end());
    return run_to_rest(read_pattern(entry, overrides)).report.outcome == Outcome::completed;
}

/// How far forces and moments on any free block are from balance, over the dead load and the size of the scene.
inline double imbalance(const studies::verify::references::LimitProblem& problem,
                        const studies::verify::references::LimitState& state)
{
    std::vector<Eigen::Vector3d> forces, moments(problem.blocks.size(), Eigen::Vector3d::Zero());
    double dead = 0, size = 0, worst = 0;
    forces.reserve(problem.blocks.size());
    for (const auto& block : problem.blocks) {
        forces.emplace_back(block.dead + state.factor * block.live);
        dead += block.dead.norm();
    }
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
        const auto& contact = problem.contacts[i];
        size = std::max(size, (contact.position - problem.contacts[0].position).norm());
        for (const auto& [block, sign] : {std::pair(contact.block_a, 1.0), std::pair(contact.block_b, -1.0)}) {
            const auto b = static_cast<std::size_t>(block);
            const Eigen::Vector3d force = sign * state.forces[i];
            forces[b] += force;
            moments[b] += (contact.position - problem.blocks[b].centroid).cross(force);
        }
    }
    for (std::size_t b = 0; b < problem.blocks.size(); ++b)
        if (!problem.blocks[b].held)
            worst = std::max({worst, forces[b].norm() / dead, moments[b].norm() / dead / size});
    return worst;
}

/// Whether stones stand by the linear program; what it finds must be an equilibrium.
inline bool bears_itself(const studies::verify::references::LimitProblem& problem)
{
    const auto limit = studies::verify::references::associated_limit(problem);
    if (limit.found) {
        EXPECT_LT(imbalance(problem, limit), 1e-7);
    }
    return limit.found;
}

/// Expects the engine to agree 0.4 % beside the least thickness of the linear program, which is found to 0.1 %.
/// @param entry of a thickness, or of another measure that makes it safer; @param falls, stands_at such measures
/// that certainly do; @param overrides of the case
inline void expect_limit_thickness(const std::function<std::string(double)>& entry, double falls, double stands_at,
                                   const std::vector<std::string>& overrides = {})
{
    using studies::verify::limit_problem;
    std::vector<std::string> at_rest = overrides;
    at_rest.insert(at_rest.end(), under_own_weight.begin(), under_own_weight.end());
    const auto by_program = [&](double thickness) {
        return bears_itself(limit_problem(read_pattern(entry(thickness), at_rest).model));
    };
    ASSERT_TRUE(by_program(stands_at));
    ASSERT_FALSE(by_program(falls));
    while (stands_at / falls > 1.001) {
        const double middle = (stands_at + falls) / 2;
        (by_program(middle) ? stands_at : falls) = middle;
    }
    EXPECT_TRUE(stands(entry(stands_at * 1.004), overrides)) << stands_at;
    EXPECT_FALSE(stands(entry(falls * 0.996), overrides)) << falls;
}

/// Under the weight and `share` of it along x.
inline std::vector<std::string> pushed(double share)
{
    return {"gravity={direction: [" + std::to_string(share) + ", 0, -1]}"};
}

/// Expects the engine to stand 0.5 % below and to fall 0.5 % above the push along x, over the weight, at which the
/// linear program says that stones overturn. @param friction at which nothing slides [deg]
inline void expect_limit_push(const std::string& entry, const char* friction = "joints.dry.friction=75 deg")
{
    std::vector<std::string> overrides = under_own_weight;
    overrides.emplace_back(friction);
    const auto problem = studies::verify::limit_problem(read_pattern(entry, overrides).model);
    const auto limit = studies::verify::references::associated_limit(problem);
    ASSERT_TRUE(limit.found);
    EXPECT_LT(imbalance(problem, limit), 1e-7);
    for (const auto& [share, stays] : {std::pair(0.995, true), std::pair(1.005, false)}) {
        std::vector<std::string> push = pushed(share * limit.factor);
        push.emplace_back(friction);
        EXPECT_EQ(stands(entry, push), stays) << share << " of " << limit.factor;
    }
}

}  // namespace voussoir::app::patterns_test
