// Boundaries and dampings that are computed wrongly, but alike in the equations and in the engine's book: its
// balance closes, and the motion tells.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdda/motion_book.h"
#include "tests/libdda/step_by_hand.h"
#include "tests/libdda/whole_ground.h"

namespace voussoir::testing
{

namespace
{

using K = step::PlanarDeformable;
using System = step::StepProblem<K>;
using Kind = step::AppliedForce<K>::Kind;

/// What the engine's book has, and what is left over of the balance when the motion's terms stand in it.
struct Books {
    EnergyLedger engine;
    double by_motion;
};

/// What is done wrongly in a step, and otherwise: the book by the motion knows nothing of it.
struct Wrong {
    Mistake<K> in_step = {};
    std::function<void(Model&)> in_model = [](Model&) {};
    std::function<void(Stage&)> in_stage = [](Stage&) {};
    std::function<void(State&)> at_start = [](State&) {};
};

Books books_of(const Wrong& wrong)
{
    const Model model = ground_with_all();
    State state = rested(model);
    const Stage stage = shaken_with_all();
    MotionBook book(model, stage, state);
    const std::vector<double> reactions = state.boundary_reactions;
    Model engines = model;
    wrong.in_model(engines);
    Stage stage_of_engine = stage;
    wrong.in_stage(stage_of_engine);
    wrong.at_start(state);
    const int steps = static_cast<int>(std::lround(stage.duration / stage.control.time_step));
    const EnergyLedger energy =
        step_by_hand<K>(engines, stage_of_engine, steps, wrong.in_step, state, [&](const State& now) {
            State seen = now;
            seen.boundary_reactions = reactions;
            book.add_step(seen);
        });
    return {energy, book.ledger_with(energy).relative_residual()};
}

/// More than ten times what the motion leaves of sound steps, which is their quadrature, though the engine's own
/// balance closes. Some terms are hardly a hundredth of the largest one in this scene.
void expect_noticed(const char* name, const Wrong& wrong)
{
    static const double sound = books_of({}).by_motion;
    const Books books = books_of(wrong);
    std::printf("%-40s residual by the motion %.1e, by the engine's book %.1e\n", name, books.by_motion,
                books.engine.relative_residual());
    EXPECT_LT(books.engine.relative_residual(), 1e-6) << name;
    EXPECT_GT(books.by_motion, 10 * sound) << name;
}

/// Halves forces of one kind, those that another block has a part in or the others.
void halve(System& system, Kind kind, bool coupled)
{
    for (auto& force : system.others.applied.own) {
        if (force.kind != kind || coupled != (force.coupling >= 0)) continue;
        force.constant *= 0.5;
        force.resistance *= 0.5;
        system.blocks[static_cast<std::size_t>(force.block)].base -= force.resistance;
        if (force.coupling >= 0)
            system.others.applied.couplings[static_cast<std::size_t>(force.coupling)].matrix *= 0.5;
    }
}

}  // namespace

TEST(BrokenGround, ThatIsNotBrokenLeavesNothing)
{
    const Books books = books_of({});
    EXPECT_LT(books.engine.relative_residual(), 1e-6);
    EXPECT_LT(books.by_motion, 1e-3);
}

// Of the base, which no free field stands beside: force = constant - resistance D, (1 + end) / h times the
// dashpots.
TEST(BrokenGround, WithHalfTheDashpotsOfTheBase)
{
    const Stage stage = shaken_with_all();
    const double h = stage.control.time_step, end = stage.control.dissipation_used();
    expect_noticed("dashpots of the base halved",
                   {.in_step = {.in_equations = [&](System& system) {
                        for (auto& force : system.others.applied.own) {
                            if (force.kind != Kind::boundary || force.coupling >= 0) continue;
                            auto& block = system.blocks[static_cast<std::size_t>(force.block)];
                            force.resistance *= 0.5;
                            block.base -= force.resistance;
                            force.constant += h / (1 + end) * (force.resistance * block.velocity);
                        }
                    }}});
}

TEST(BrokenGround, WithHalfTheWave)
{
    expect_noticed("wave from below halved",
                   {.in_stage = [](Stage& stage) { stage.incoming_waves[0].share = 0.5; }});
}

TEST(BrokenGround, WithAWaveThatComesLate)
{
    expect_noticed("wave 10 ms late", {.in_stage = [](Stage& stage) {
                       for (IncomingWave& wave : stage.incoming_waves) {
                           wave.slowness = {0, 0, 0.01};
                           wave.origin = {0, 0, -1};
                       }
                   }});
}

TEST(BrokenGround, WithoutTheReactionsOfRest)
{
    expect_noticed("reactions of rest lost", {.at_start = [](State& state) {
                       std::fill(state.boundary_reactions.begin(), state.boundary_reactions.end(), 0.0);
                   }});
}

TEST(BrokenGround, WithHalfTheFreeField)
{
    expect_noticed("free field halved",
                   {.in_step = {.in_equations = [](System& system) { halve(system, Kind::boundary, true); }}});
}

TEST(BrokenGround, WithHalfTheDampingByMass)
{
    expect_noticed("damping by mass halved",
                   {.in_step = {.in_equations = [](System& system) { halve(system, Kind::damping, false); }}});
}

TEST(BrokenGround, WithHalfTheDampingByStiffness)
{
    expect_noticed("damping by stiffness halved", {.in_step = {.in_equations = [](System& system) {
                                                       for (auto& block : system.blocks) {
                                                           block.damping_blend *= 0.5;
                                                           block.elastic_blend -= block.damping_blend;
                                                       }
                                                   }}});
}

TEST(BrokenGround, WithHalfTheMemory)
{
    expect_noticed("memory halved", {.in_step = {.in_equations = [](System& system) {
                                         for (auto& block : system.blocks) {
                                             for (auto& branch : block.memory.branches) branch.share *= 0.5;
                                             block.memory.blend *= 0.5;
                                             block.memory.steady *= 0.5;
                                             block.elastic_blend -= block.memory.blend;
                                         }
                                     }}});
}

TEST(BrokenGround, WithHalfTheKineticDamping)
{
    expect_noticed("kinetic damping halved", {.in_stage = [](Stage& stage) { stage.damping.rate *= 0.5; }});
}

TEST(BrokenGround, WithHalfTheDashpotsOfJoints)
{
    expect_noticed("dashpots of joints halved",
                   {.in_model = [](Model& model) { model.joints[1].relaxation_time *= 0.5; }});
}

}  // namespace voussoir::testing
