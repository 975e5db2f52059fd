// Every boundary and every damping in one scene: the balance of the energy closes, each term is needed, and is
// what the motion says.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdda/motion_book.h"
#include "tests/libdda/whole_ground.h"

namespace voussoir::testing
{

namespace
{

void print(const EnergyLedger& e, const MotionBook& book)
{
    std::printf(
        "engine (by the motion): gravity %.2f (%.2f), boundary %.3f (%.3f), kinetic damping %.3f (%.3f), dashpots "
        "of "
        "joints %.4f (%.4f), material %.4f (%.4f: %.4f by mass, %.4f by stiffness, %.4f by memory), strain %.4f "
        "(%.4f); foundation %.1f, friction %.1f, integrator %.3f, kinetic %.1f J; residual %.1e (%.1e)\n",
        e.gravity_work, book.gravity_work, e.boundary_work, book.boundary_work, e.damping_kinetic,
        book.damping_kinetic, e.damping_contact, book.damping_contact, e.damping_material, book.material(),
        book.damping_mass, book.damping_stiffness, book.damping_memory, e.strain, book.strain, e.foundation_work,
        e.friction, e.algorithmic, e.kinetic, e.relative_residual(), book.ledger_with(e).relative_residual());
}

}  // namespace

TEST(WholeBalance, ClosesWithEveryBoundaryAndDamping)
{
    const Model model = ground_with_all();
    State state = rested(model);
    const Stage stage = shaken_with_all();
    MotionBook book(model, stage, state);
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) { book.add_step(now); };
    const RunReport report = run(model, {stage}, state, observer);
    ASSERT_EQ(report.outcome, Outcome::completed);
    const EnergyLedger& e = report.energy;
    print(e, book);
    EXPECT_LT(e.relative_residual(), 1e-6);
    // Each by itself, from its definition: what separates the two is how each takes the mean over a step.
    const auto expect_same = [](const char* name, double engine, double by_motion, double share) {
        EXPECT_NEAR(engine, by_motion, share * std::abs(by_motion)) << name;
    };
    expect_same("gravity", e.gravity_work, book.gravity_work, 1e-6);
    expect_same("boundary", e.boundary_work, book.boundary_work, 1e-3);
    expect_same("kinetic damping", e.damping_kinetic, book.damping_kinetic, 1e-6);
    expect_same("material damping", e.damping_material, book.material(), 1e-2);
    expect_same("dashpots of joints", e.damping_contact, book.damping_contact, 2e-2);
    expect_same("strain", e.strain, book.strain, 1e-3);
    expect_same("kinetic", e.kinetic, book.kinetic, 1e-9);
    EXPECT_LT(book.ledger_with(e).relative_residual(), 1e-3);
    // All of them are there, and half of any is missed.
    for (double EnergyLedger::*term :
         {&EnergyLedger::kinetic, &EnergyLedger::strain, &EnergyLedger::contact, &EnergyLedger::gravity_work,
          &EnergyLedger::foundation_work, &EnergyLedger::boundary_work, &EnergyLedger::friction,
          &EnergyLedger::damping_kinetic, &EnergyLedger::damping_contact, &EnergyLedger::damping_material}) {
        EXPECT_NE(e.*term, 0);
        EnergyLedger falsified = e;
        falsified.*term *= 0.5;
        EXPECT_GT(falsified.relative_residual(), 100 * e.relative_residual());
    }
}

}  // namespace voussoir::testing
