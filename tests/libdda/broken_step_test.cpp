// The energy audit must notice a step that is computed wrongly: each part of a step is broken in turn.
#include <gtest/gtest.h>

#include <functional>

#include "libdda/analysis/energies.h"
#include "libdda/step/energy_book.h"
#include "libdda/step/update.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

/// What may be done wrongly, at the place in the step where it would be.
template <class K>
struct Mistake {
    std::function<void(StepSystem<K>&)> in_equations = [](StepSystem<K>&) {};  // between assembly and solution
    std::function<void(StepSystem<K>&)> in_forces = [](StepSystem<K>&) {};     // between solution and update
    std::function<void(const StepSystem<K>&, State&)> in_update = [](const StepSystem<K>&, State&) {};
    std::function<void(StepSystem<K>&)> in_the_book = [](StepSystem<K>&) {};  // between update and audit
};

/// The step of libdda/step/advance.cpp without cutting and division, with a mistake in it.
template <class K>
EnergyLedger run_with(const Mistake<K>& mistake)
{
    FewBlocks scene(K::kinematics, {});
    scene.model.joints[0].relaxation_time = 1e-4;
    Stage stage = shaking(0.3, 1e-3);
    stage.control.force_tolerance = 1e-8;
    EnergyLedger energy = open_ledger(scene.model, scene.state);
    State& state = scene.state;
    StepSystem<K> system;
    std::vector<PlacedPartIn<K::dimension>> parts;
    ContactSetIn<K::dimension> contacts;
    const double h = stage.control.time_step;
    const std::vector<double> reach(scene.model.blocks.size(), 0.05);
    StepReport report;
    for (int step = 0; step < 300; ++step) {
        find_contacts(scene.model, state, reach, 1, parts, contacts,
                      step > 0 ? NewOverlap::forgiven : NewOverlap::presses);
        assemble_blocks(scene.model, stage, state, contacts, h, system);
        mistake.in_equations(system);
        EXPECT_TRUE(iterate_newton(scene.model, stage, contacts, system, report)) << "step " << step;
        energy.redetection += energy.contact - spring_energy(scene.model, contacts);
        mistake.in_forces(system);
        update_blocks(system, state);
        mistake.in_update(system, state);
        mistake.in_the_book(system);
        book_step(state, system, contacts, energy);
        update_contacts(stage, system, contacts, state, report);
        state.stage_time += h;
        damp_velocities(scene.model, stage, system, state, energy);
    }
    return energy;
}

template <class K>
class BrokenStep : public ::testing::Test
{
 protected:
    /// Above what a run warns of, and far above what a sound step leaves.
    static void expect_noticed(const char* name, const Mistake<K>& mistake)
    {
        const EnergyLedger energy = run_with<K>(mistake);
        std::printf("%-40s residual %.1e\n", name, energy.relative_residual());
        EXPECT_GT(energy.relative_residual(), residual_worth_a_warning) << name;
    }
};
using All = ::testing::Types<SpatialDeformable, SpatialRigid, PlanarDeformable, PlanarRigid>;
TYPED_TEST_SUITE(BrokenStep, All);

}  // namespace

TYPED_TEST(BrokenStep, that_is_not_broken_leaves_nothing)
{
    EXPECT_LT(run_with<TypeParam>({}).relative_residual(), 1e-6);
}

TYPED_TEST(BrokenStep, without_weight)
{
    this->expect_noticed("weight dropped", {.in_equations = [](StepSystem<TypeParam>& system) {
                             for (BlockStep<TypeParam>& block : system.blocks) block.steady.setZero();
                         }});
}

/// The moment that contacts exert does not reach the spin: a rotation update that loses it.
TYPED_TEST(BrokenStep, without_the_moment_of_contact_forces)
{
    Eigen::VectorXd whole;
    this->expect_noticed("moments of contacts dropped",
                         {.in_forces =
                              [&](StepSystem<TypeParam>& system) {
                                  constexpr int n = TypeParam::unknowns, dimension = TypeParam::dimension;
                                  whole = system.contact_force;
                                  for (std::size_t row = 0; row < system.block_of_row.size(); ++row)
                                      system.contact_force.segment(n * row + dimension, n - dimension).setZero();
                              },
                          .in_the_book = [&](StepSystem<TypeParam>& system) { system.contact_force = whole; }});
}

TYPED_TEST(BrokenStep, with_half_the_friction_work)
{
    this->expect_noticed("friction work halved", {.in_the_book = [](StepSystem<TypeParam>& system) {
                             for (PointStep<TypeParam::dimension>& point : system.contacts.points)
                                 point.shear *= 0.5;
                         }});
}

TYPED_TEST(BrokenStep, without_the_force_of_dashpots)
{
    this->expect_noticed("dashpots not booked", {.in_the_book = [](StepSystem<TypeParam>& system) {
                             for (PointStep<TypeParam::dimension>& point : system.contacts.points)
                                 point.normal = point.elastic_normal;
                         }});
}

TYPED_TEST(BrokenStep, with_a_spin_that_gains_momentum)
{
    this->expect_noticed("spin gained", {.in_update = [](const StepSystem<TypeParam>& system, State& state) {
                             constexpr int n = TypeParam::unknowns, dimension = TypeParam::dimension;
                             for (std::size_t b = 0; b < system.blocks.size(); ++b)
                                 state.velocities[b * n + dimension + TypeParam::deformable] += 0.05;
                         }});
}

TYPED_TEST(BrokenStep, that_moves_blocks_farther_than_its_forces)
{
    this->expect_noticed("centroids moved too far",
                         {.in_update = [](const StepSystem<TypeParam>& system, State& state) {
                             const int size = coordinates_per_block(TypeParam::kinematics);
                             for (const int b : system.block_of_row)
                                 state.coordinates[b * size + TypeParam::dimension - 1] += 1e-5;
                         }});
}

}  // namespace voussoir::testing
