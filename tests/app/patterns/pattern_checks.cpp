#include "tests/app/patterns/pattern_checks.h"

#include <cmath>

namespace voussoir::app::patterns_test
{
namespace
{

using Eigen::Vector3d;

Vector3d centroid_in(const Model& model, const State& state, std::size_t block)
{
    const std::size_t per_block = state.coordinates.size() / model.blocks.size();
    const double* x = state.coordinates.data() + per_block * block;
    return is_planar(model.kinematics) ? Vector3d(x[0], 0, x[1]) : Vector3d(x[0], x[1], x[2]);
}

double largest_move(const Model& model, const State& from, const State& to)
{
    double largest = 0;
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        largest = std::max(largest, (centroid_in(model, to, b) - centroid_in(model, from, b)).norm());
    return largest;
}

/// Vertical force of held blocks on the others, by their contacts [N].
double ground_force(const Model& model, const State& state)
{
    std::set<int> held;
    for (const Foundation& foundation : model.foundations) held.insert(foundation.block);
    double force = 0;
    for (const ContactPatch& patch : state.contacts.patches) {
        const bool a = held.count(patch.block_a) > 0, b = held.count(patch.block_b) > 0;
        if (a == b) continue;
        for (int p = 0; p < patch.point_count; ++p) {
            const ContactPoint& point = state.contacts.points[patch.first_point + p];
            const Vector3d on_a = point.normal_force * patch.normal - point.shear_force;
            force += b ? on_a.z() : -on_a.z();
        }
    }
    return force;
}

double free_weight(const Model& model)
{
    std::set<int> held;
    for (const Foundation& foundation : model.foundations) held.insert(foundation.block);
    double mass = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (held.count(b) == 0) mass += model.mass(b);
    return 9.80665 * mass;
}

}  // namespace

importers::assembly::Assembly assembly_of(const Model& model)
{
    std::vector<importers::assembly::AssemblyStone> stones;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const Block& block = model.blocks[b];
        importers::assembly::AssemblyStone stone{block.name, {}, block.moments.volume, 0, false};
        for (const ConvexPolyhedron& part : block.parts)
            stone.parts.push_back(translated(part, block.moments.centroid));
        for (const Foundation& foundation : model.foundations)
            stone.foundation = stone.foundation || foundation.block == static_cast<int>(b);
        stones.push_back(std::move(stone));
    }
    return importers::assembly::examine_assembly(std::move(stones), {}, {0, true, 0, {}});
}

double joint_area(const importers::assembly::Assembly& assembly, const std::string& a, const std::string& b)
{
    for (const importers::assembly::StoneContact& contact : assembly.contacts) {
        const std::string &one = assembly.stones[contact.a].name, &other = assembly.stones[contact.b].name;
        if ((one == a && other == b) || (one == b && other == a)) return contact.area;
    }
    return 0;
}

void expect_sound(const importers::assembly::Assembly& assembly)
{
    EXPECT_TRUE(assembly.overlaps.empty());
    EXPECT_TRUE(assembly.floating.empty());
    for (const int stone : assembly.unsupported) ADD_FAILURE() << assembly.stones[stone].name << " has no support";
    for (const auto& sliver : assembly.slivers) ADD_FAILURE() << assembly.stones[sliver.stone].name << ": sliver";
    for (const auto& gap : assembly.gaps)
        ADD_FAILURE() << assembly.stones[gap.a].name << ", " << assembly.stones[gap.b].name << ": gap of "
                      << gap.width;
    for (const auto& overlap : assembly.overlaps)
        ADD_FAILURE() << assembly.stones[overlap.a].name << ", " << assembly.stones[overlap.b].name
                      << ": overlap of " << overlap.depth;
}

void expect_symmetric(const Model& model, int axis, double tolerance)
{
    for (const Block& block : model.blocks) {
        Vector3d wanted = block.moments.centroid + model.origin;
        wanted[axis] = -wanted[axis];
        bool found = false;
        for (const Block& other : model.blocks)
            found = found || ((other.moments.centroid + model.origin - wanted).norm() < tolerance &&
                              std::abs(other.moments.volume - block.moments.volume) < tolerance);
        EXPECT_TRUE(found) << block.name << " has no twin across axis " << axis;
    }
}

Rest run_to_rest(const Case& the_case)
{
    State state = initial_state(the_case.model);
    const State start = state;
    State settled = state;
    RunObserver observer;
    Rest rest;
    observer.every = 1e9;
    bool is_settled = false;
    observer.frame = [&](const State& now, const RunReport&) {
        if (is_settled || now.step == 0) return;
        settled = now;
        is_settled = true;
        rest.settlement = largest_move(the_case.model, start, now);
        rest.reaction_error = std::abs(ground_force(the_case.model, now) / free_weight(the_case.model) - 1);
    };
    rest.report = run(the_case.model, the_case.stages, state, observer);
    rest.drift = largest_move(the_case.model, settled, state);
    return rest;
}

void expect_rest(const Case& the_case)
{
    const Rest rest = run_to_rest(the_case);
    EXPECT_EQ(rest.report.outcome, Outcome::completed) << ::testing::PrintToString(rest.report.diagnosis);
    EXPECT_LT(rest.drift, 1e-6);
    EXPECT_LT(rest.reaction_error, 1e-6);
    EXPECT_LT(rest.settlement, 0.01);
    EXPECT_GT(rest.settlement, 0);
}

}  // namespace voussoir::app::patterns_test
