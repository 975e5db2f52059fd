// Ground with every boundary and every damping in it.
#pragma once

#include <utility>

#include "tests/libdda/ground_scenes.h"

namespace voussoir::testing
{

/// The grid of `ground_with_all`, in blocks, and one of them.
constexpr int columns_of_all = 4, rows_of_all = 6, edge_that_is_tied = columns_of_all * 4;

/// Its last blocks.
struct Loose {
    int slider, jumper, table;
};

/// A grid on a viscous base, its lower rows beside a free field, its upper ones tied across; a stone slides on it,
/// and another jumps on a base that moves.
inline Model ground_with_all()
{
    constexpr int columns = columns_of_all, rows = rows_of_all;
    Model model = grid(Kinematics::planar_deformable, columns, rows);
    model.materials[0].rayleigh = {2, 1e-4};
    model.materials[0].branches = hysteretic_branches(0.05, 5, 200);
    ViscousBoundary base = base_of(model, columns);
    ViscousBoundary flanks{"flanks", {}, RestSupport::normal, {}};
    for (const bool left : {true, false})
        for (int j = 0; j < rows / 2; ++j) {
            const int edge = columns * j + (left ? 0 : columns - 1);
            flanks.faces.push_back(face_of_box(model, edge, (left ? -1.0 : 1.0) * Eigen::Vector3d::UnitX()));
            const double x = left ? -5.0 : 4.0;
            const int block = add_box(model, "column", {x, -0.5, 1.0 * j}, {x + 1, 0.5, j + 1.0});
            model.tied_sides.push_back(block);
            flanks.free_field.push_back(block);
            if (j == 0) base.faces.push_back(face_of_box(model, block, -Eigen::Vector3d::UnitZ()));
        }
    model.boundaries = {base, flanks};
    for (int j = rows / 2; j < rows; ++j)
        model.side_ties.push_back({face_of_box(model, columns * (j + 1) - 1, Eigen::Vector3d::UnitX()),
                                   face_of_box(model, columns * j, -Eigen::Vector3d::UnitX()), 100 * ground.young,
                                   100 * ground.young});
    // Stones of group 1, whose joints are dry and have dashpots.
    model.groups.push_back("stones");
    JointMaterial joint = dry(20);
    joint.relaxation_time = 1e-4;
    joint.face = FaceLaw::corners;  // the book by the motion knows stones as they are drawn, not as they bend
    model.joints.push_back(joint);
    model.joint_of_groups = {0, 1, 1, 1};
    const double top = rows;
    for (const auto& [from, z] : {std::pair{-0.5, top}, {10.5, 0.0}})
        model.blocks[static_cast<std::size_t>(add_box(model, "stone", {from, -0.5, z}, {from + 1, 0.5, z + 0.4}))]
            .group = 1;
    const int table = add_box(model, "table", {8, -0.5, -1}, {14, 0.5, 0});
    model.blocks[static_cast<std::size_t>(table)].group = 1;
    hold(model, table);
    return model;
}

inline Loose loose_blocks(const Model& model)
{
    const int blocks = static_cast<int>(model.blocks.size());
    return {blocks - 3, blocks - 2, blocks - 1};
}

/// The scene at rest, its stones pushed, and a block beside ties, which stretches them and all about it.
inline State rested(const Model& model)
{
    State state = initial_state(model);
    EXPECT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
    begin_stage(model, 0, state);
    set_velocity(model, state, loose_blocks(model).slider, {1, 0, 0});
    set_velocity(model, state, edge_that_is_tied, {0.7, 0, 0});
    set_velocity(model, state, loose_blocks(model).jumper, {0, 0, 0.3});
    return state;
}

/// Waves from below, a table that moves, kinetic damping.
inline Stage shaken_with_all()
{
    Stage stage = dynamic_stage(0.12, 2e-4);
    stage.control.force_tolerance = 1e-9;
    stage.damping.rate = 0.5;
    stage.incoming_waves = {{0, 0, pulse(0.3, 0.1)}, {0, 2, pulse(0.1, 0.15)}};
    stage.motions = {{0, 0, pulse(0.5, 0.2)}};
    return stage;
}

}  // namespace voussoir::testing
