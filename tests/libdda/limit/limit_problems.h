// Rigid blocks whose limits have closed forms.
#pragma once

#include <cmath>

#include "libdda/limit/limit_problem.h"

namespace voussoir::limit
{

constexpr double width = 0.4, height = 1.2, depth = 0.6;  // m, of the block on its base

/// A block of 1 N on a held base, with four contact points in space and two in the plane. @param live [N]
inline LimitProblem block_on_base(double friction, bool planar,
                                  const Eigen::Vector3d& live = Eigen::Vector3d::UnitX())
{
    LimitProblem problem;
    problem.planar = planar;
    problem.blocks.resize(2);
    problem.blocks[0].hold();
    problem.blocks[1] = {{}, false, {0, 0, height / 2}, {0, 0, -1}, live};
    for (const double x : {-width / 2, width / 2})
        for (const double y : {-depth / 2, depth / 2}) {
            if (planar && y > 0) continue;
            problem.contacts.push_back({1, 0, {x, planar ? 0 : y, 0}, {0, 0, 1}, friction});
        }
    return problem;
}

/// A wedge-shaped stone between two held ones whose joints lean by `lean` from the vertical: 1 N down, pushed up.
inline LimitProblem stone_in_a_cleft(double friction, double lean)
{
    LimitProblem problem;
    problem.planar = true;
    problem.blocks.resize(3);
    problem.blocks[0].hold();
    problem.blocks[1].hold();
    problem.blocks[2] = {{}, false, {0, 0, 0}, {0, 0, -1}, {0, 0, 1}};
    for (const double side : {-1.0, 1.0})
        problem.contacts.push_back(
            {2, side < 0 ? 0 : 1, {side, 0, 0}, {-side * std::cos(lean), 0, std::sin(lean)}, friction});
    return problem;
}

}  // namespace voussoir::limit
