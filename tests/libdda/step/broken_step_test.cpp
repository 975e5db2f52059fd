// The energy audit must notice a step that is computed wrongly: each part of a step is broken in turn.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/libdda/step_by_hand.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

/// The scene of a few blocks that rock, slide and knock. @param in_model what else it has
template <class K>
EnergyLedger run_with(
    const Mistake<K>& mistake, const std::function<void(Model&)>& in_model = [](Model&) {})
{
    FewBlocks scene(K::kinematics, {});
    scene.model.joints[0].relaxation_time = 1e-4;
    in_model(scene.model);
    const State anew = initial_state(scene.model);
    scene.state.boundary_reactions = anew.boundary_reactions;
    scene.state.branch_strains = anew.branch_strains;
    Stage stage = shaking(0.3, 1e-3);
    stage.control.force_tolerance = 1e-8;
    return step_by_hand<K>(scene.model, stage, 300, mistake, scene.state);
}

template <class K>
class BrokenStep : public ::testing::Test
{
 protected:
    /// Above what a run warns of, and far above what a sound step leaves.
    static void expect_noticed(
        const char* name, const Mistake<K>& mistake, const std::function<void(Model&)>& in_model = [](Model&) {})
    {
        const EnergyLedger energy = run_with<K>(mistake, in_model);
        std::printf("%-40s residual %.1e\n", name, energy.relative_residual());
        EXPECT_GT(energy.relative_residual(), residual_worth_a_warning) << name;
    }
};
using All =
    ::testing::Types<step::SpatialDeformable, step::SpatialRigid, step::PlanarDeformable, step::PlanarRigid>;
TYPED_TEST_SUITE(BrokenStep, All);

}  // namespace

TYPED_TEST(BrokenStep, ThatIsNotBrokenLeavesNothing)
{
    EXPECT_LT(run_with<TypeParam>({}).relative_residual(), 1e-6);
}

TYPED_TEST(BrokenStep, WithoutWeight)
{
    this->expect_noticed("weight dropped", {.in_equations = [](step::StepProblem<TypeParam>& system) {
                             for (step::BlockStep<TypeParam>& block : system.blocks) block.steady.setZero();
                         }});
}

/// The moment that contacts exert does not reach the spin: a rotation update that loses it.
TYPED_TEST(BrokenStep, WithoutTheMomentOfContactForces)
{
    Eigen::VectorXd whole;
    this->expect_noticed(
        "moments of contacts dropped",
        {.in_forces =
             [&](step::StepProblem<TypeParam>& system) {
                 constexpr int n = TypeParam::unknowns, dimension = TypeParam::dimension;
                 whole = system.contact_force;
                 for (std::size_t row = 0; row < system.block_of_row.size(); ++row)
                     system.contact_force.segment(n * row + dimension, n - dimension).setZero();
             },
         .in_the_book = [&](step::StepProblem<TypeParam>& system) { system.contact_force = whole; }});
}

TYPED_TEST(BrokenStep, WithHalfTheFrictionWork)
{
    this->expect_noticed("friction work halved", {.in_the_book = [](step::StepProblem<TypeParam>& system) {
                             for (step::PointStep<TypeParam::dimension>& point : system.contacts.points)
                                 point.shear *= 0.5;
                         }});
}

TYPED_TEST(BrokenStep, WithoutTheForceOfDashpots)
{
    this->expect_noticed("dashpots not booked", {.in_the_book = [](step::StepProblem<TypeParam>& system) {
                             for (step::PointStep<TypeParam::dimension>& point : system.contacts.points)
                                 point.normal = point.elastic_normal;
                         }});
}

TYPED_TEST(BrokenStep, WithASpinThatGainsMomentum)
{
    this->expect_noticed("spin gained",
                         {.in_update = [](const step::StepProblem<TypeParam>& system, State& state) {
                             constexpr int n = TypeParam::unknowns, dimension = TypeParam::dimension;
                             // Along the spin: of a block that its joints hold, the gains of one sense are
                             // reversed in the next step, and add up to nothing.
                             for (std::size_t b = 0; b < system.blocks.size(); ++b) {
                                 double& spin = state.velocities[b * n + dimension + TypeParam::deformable];
                                 spin += std::copysign(0.05, spin);
                             }
                         }});
}

TYPED_TEST(BrokenStep, ThatMovesBlocksFartherThanItsForces)
{
    this->expect_noticed("centroids moved too far",
                         {.in_update = [](const step::StepProblem<TypeParam>& system, State& state) {
                             const int size = coordinates_per_block(TypeParam::kinematics);
                             for (const int b : system.block_of_row)
                                 state.coordinates[b * size + TypeParam::dimension - 1] += 1e-5;
                         }});
}

/// Dashpots on a face of a free block, and all of them damped.
void damp_blocks(Model& model)
{
    model.materials[0].rayleigh = {2, 1e-4};
    if (is_deformable(model.kinematics)) model.boundaries.push_back({"face", {{1, 0, 0}}, RestSupport::none});
}

TYPED_TEST(BrokenStep, WithDampedBlocksThatIsNotBrokenLeavesNothing)
{
    const EnergyLedger energy = run_with<TypeParam>({}, damp_blocks);
    EXPECT_LT(energy.relative_residual(), 1e-6);
    EXPECT_GT(energy.damping_material, 0);
    EXPECT_EQ(energy.boundary_work != 0, TypeParam::deformable);
}

/// Halves forces of one kind, or all of a matrix that couples blocks.
template <class K>
void halve(step::StepProblem<K>& system, typename step::AppliedForce<K>::Kind kind)
{
    for (step::AppliedForce<K>& force : system.others.applied.own) {
        if (force.kind != kind) continue;
        force.constant *= 0.5;
        force.resistance *= 0.5;
        if (force.coupling >= 0)
            system.others.applied.couplings[static_cast<std::size_t>(force.coupling)].matrix *= 0.5;
    }
}

TYPED_TEST(BrokenStep, WithHalfTheDampingByMass)
{
    using Kind = typename step::AppliedForce<TypeParam>::Kind;
    this->expect_noticed(
        "damping by mass halved",
        {.in_the_book = [](step::StepProblem<TypeParam>& system) { halve(system, Kind::damping); }}, damp_blocks);
}

/// What is booked of blocks' own deformation is not what their elastic force does.
TYPED_TEST(BrokenStep, WithHalfTheDampingByStiffness)
{
    if (!TypeParam::deformable) return;
    this->expect_noticed("damping by stiffness halved",
                         {.in_the_book =
                              [](step::StepProblem<TypeParam>& system) {
                                  for (step::InternalForce<TypeParam>& internal : system.internal)
                                      internal.damped *= 0.5;
                              }},
                         [](Model& model) {
                             model.materials[0].rayleigh = {2, 3e-3};
                         });
}

TYPED_TEST(BrokenStep, WithHalfTheForceOfTheBoundary)
{
    if (!TypeParam::deformable) return;
    using Kind = typename step::AppliedForce<TypeParam>::Kind;
    this->expect_noticed(
        "force of the boundary halved",
        {.in_the_book = [](step::StepProblem<TypeParam>& system) { halve(system, Kind::boundary); }}, damp_blocks);
}

/// Memory of strain, sides that are tied and a side that a column of ground presses on, of blocks that move
/// anyhow.
void tie_and_remember(Model& model)
{
    if (!is_deformable(model.kinematics)) return;
    model.materials[0].branches = hysteretic_branches(0.1, 5, 200);
    model.side_ties.push_back({{1, 0, 0}, {2, 0, 0}, 2e8, 1e8});
    model.boundaries.push_back({"side", {{1, 0, 1}}, RestSupport::none, {4}});
}

TYPED_TEST(BrokenStep, WithTiesAndMemoryThatIsNotBrokenLeavesNothing)
{
    const EnergyLedger energy = run_with<TypeParam>({}, tie_and_remember);
    EXPECT_LT(energy.relative_residual(), 1e-6);
    EXPECT_EQ(energy.damping_material > 0, TypeParam::deformable);
    EXPECT_EQ(energy.boundary_work != 0, TypeParam::deformable);
}

TYPED_TEST(BrokenStep, WithATieThatPullsOneSideAlone)
{
    if (!TypeParam::deformable) return;
    this->expect_noticed("tie of one side",
                         {.in_equations =
                              [](step::StepProblem<TypeParam>& system) {
                                  using Kind = typename step::AppliedForce<TypeParam>::Kind;
                                  bool first = true;
                                  for (auto& force : system.others.applied.own) {
                                      if (force.kind != Kind::tie) continue;
                                      if (!first) force.constant.setZero();
                                      first = false;
                                  }
                              }},
                         tie_and_remember);
}

TYPED_TEST(BrokenStep, WithHalfTheMemory)
{
    if (!TypeParam::deformable) return;
    this->expect_noticed("branches' strain halved",
                         {.in_update =
                              [](const step::StepProblem<TypeParam>&, State& state) {
                                  for (double& strain : state.branch_strains) strain *= 0.5;
                              }},
                         tie_and_remember);
}

TYPED_TEST(BrokenStep, WithHalfTheForceOfTheFreeField)
{
    if (!TypeParam::deformable) return;
    using Kind = typename step::AppliedForce<TypeParam>::Kind;
    this->expect_noticed(
        "force of the free field halved",
        {.in_the_book = [](step::StepProblem<TypeParam>& system) { halve(system, Kind::boundary); }},
        tie_and_remember);
}

}  // namespace voussoir::testing
