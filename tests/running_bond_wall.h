// A running-bond wall in which nothing may move: what tests/bench and tests/peers measure.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "libdda/model/model.h"

namespace voussoir
{

/// Blocks of 0.5 x 0.5 x 0.25 m, half ones at the ends of every other course, on a held base (block 0); 2000
/// kg/m3, 10 GPa, friction 0.6. 8 courses of 12 are 100 blocks, 16 of 31 are 504.
inline Model running_bond_wall(Kinematics kinematics, int courses, int blocks)
{
    constexpr double length = 0.5, height = 0.25, thickness = 0.5;  // m
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = std::atan(0.6);
    Model model = make_model(kinematics, {"stone", 2000, 1e10, 0.2}, joint);
    const auto add = [&](const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
        const std::string name = "b" + std::to_string(model.blocks.size());
        model.blocks.push_back(make_block(name, 0, 0, {make_box(lower, upper)}));
    };
    add({-1, 0, -0.5}, {blocks * length + 1, thickness, 0});
    Foundation foundation;
    foundation.block = 0;
    model.foundations.push_back(foundation);
    for (int course = 0; course < courses; ++course) {
        const bool staggered = course % 2 != 0;
        for (int i = 0; i < blocks + staggered; ++i) {
            const double from = (i - 0.5 * staggered) * length;
            add({std::max(0.0, from), 0, course * height},
                {std::min(blocks * length, from + length), thickness, (course + 1) * height});
        }
    }
    return model;
}

}  // namespace voussoir
