// Hysteretic damping: a block that stretches by itself loses its amplitude as the root of its own equation says.
#include "libdda/block/material_memory.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <numbers>

#include "libdda/block/kinematics_traits.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;
using std::numbers::pi;

class Memory : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Memory,
                         ::testing::Values(Kinematics::spatial_deformable, Kinematics::planar_deformable),
                         test_name);

// One free block of Poisson's ratio 0 and length L, whose stretch is an oscillator: V E q + rho V L^2/12 q'' = 0.
constexpr double length = 2, density = 2000, young = 2e6;
const double omega = std::sqrt(12 * young / density) / length;  // 1/s, at rest: 8.7 Hz

Model block_with(Kinematics kinematics, const std::vector<MaxwellBranch>& branches)
{
    BlockMaterial material{"ground", density, young, 0};
    material.branches = branches;
    Model model = make_model(kinematics, material, dry(30));
    add_box(model, "block", {-0.5, -0.5, -0.5 * length}, {0.5, 0.5, 0.5 * length});
    return model;
}

/// Rate of stretch over that at the start, by the equation itself: y' = A y of stretch, rate and the stretch of
/// each dashpot, solved by the eigenvectors of A.
class Exact
{
 public:
    explicit Exact(const std::vector<MaxwellBranch>& branches)
    {
        const auto count = static_cast<Eigen::Index>(branches.size());
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count + 2, count + 2);
        a(0, 1) = 1;
        a(1, 0) = -omega * omega;
        for (Eigen::Index k = 0; k < count; ++k) {
            const MaxwellBranch& branch = branches[static_cast<std::size_t>(k)];
            a(1, 0) -= omega * omega * branch.share;
            a(1, k + 2) = omega * omega * branch.share;
            a(k + 2, 0) = 1 / branch.time;
            a(k + 2, k + 2) = -1 / branch.time;
        }
        const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
        values_ = solver.eigenvalues();
        const Eigen::VectorXcd start = Eigen::VectorXcd::Unit(count + 2, 1);
        shares_ = solver.eigenvectors().row(1).transpose().cwiseProduct(
            Eigen::VectorXcd(solver.eigenvectors().partialPivLu().solve(start)));
    }
    double rate_at(double time) const { return (shares_.array() * (values_.array() * time).exp()).sum().real(); }
    /// The root that vibrates [1/s].
    std::complex<double> root() const
    {
        Eigen::Index at = 0;
        values_.imag().maxCoeff(&at);
        return values_[at];
    }

 private:
    Eigen::VectorXcd values_, shares_;
};

}  // namespace

// Six cycles, against the exact solution of the same equation.
TEST_P(Memory, DecaysAsItsEquationSays)
{
    for (const double ratio : {0.02, 0.05, 0.1}) {
        const std::vector<MaxwellBranch> branches = hysteretic_branches(ratio, 1, 40);
        const Exact exact(branches);
        const Model model = block_with(GetParam(), branches);
        State state = initial_state(model);
        const std::size_t zz = static_cast<std::size_t>(unknowns_per_block(GetParam())) - 1;
        const double start = 1e-4 * omega, cycle = 2 * pi / exact.root().imag();
        state.velocities[zz] = start;
        Stage stage = dynamic_stage(6 * cycle, cycle / 400, Vector3d::Zero());
        stage.control.dissipation = 0;
        double worst = 0;
        RunObserver observer;
        observer.step = [&](const State& now, const StepReport&, const RunReport&) {
            worst = std::max(worst, std::abs(now.velocities[zz] / start - exact.rate_at(now.stage_time)));
        };
        const RunReport report = run(model, {stage}, state, observer);
        EXPECT_LT(worst, 2e-3) << ratio;
        EXPECT_LT(report.energy.relative_residual(), 1e-8);
        EXPECT_NEAR(report.energy.algorithmic, 0, 1e-9 * report.energy.start_kinetic);
        EXPECT_GT(report.energy.damping_material, 0.5 * report.energy.start_kinetic);
    }
}

// Free vibration of what is damped alike at all frequencies loses sin(pi/2 g / (1 - g)) of its amplitude per
// radian, tan(pi g) twice the ratio: the same up to the square of the ratio, for it grows softer as it slows down.
TEST(MemoryOfABand, MakesVibrationsDecayAtTheRatioAskedFor)
{
    for (const double ratio : {0.01, 0.02, 0.05, 0.1}) {
        const std::complex<double> root = Exact(hysteretic_branches(ratio, 0.3, 300)).root();
        const double g = std::atan(2 * ratio) / pi, exact = std::sin(pi / 2 * g / (1 - g));
        EXPECT_NEAR(-root.real() / std::abs(root), exact, 0.01 * exact);
        EXPECT_NEAR(exact, ratio, 0.8 * ratio * ratio);
    }
}

// The step length does not change what is lost.
TEST_P(Memory, LosesAsMuchWhateverTheStep)
{
    const std::vector<MaxwellBranch> branches = hysteretic_branches(0.05, 1, 40);
    const auto kept = [&](int steps_to_cycle) {
        const Model model = block_with(GetParam(), branches);
        State state = initial_state(model);
        state.velocities[static_cast<std::size_t>(unknowns_per_block(GetParam())) - 1] = 1e-4 * omega;
        Stage stage = dynamic_stage(1, 2 * pi / omega / steps_to_cycle, Vector3d::Zero());
        stage.control.dissipation = 0;
        const RunReport report = run_quietly(model, {stage}, state);
        EXPECT_LT(report.energy.relative_residual(), 1e-7);
        return report.energy.damping_material / report.energy.start_kinetic;
    };
    const double fine = kept(800);
    EXPECT_NEAR(kept(100), fine, 1e-3);
    EXPECT_NEAR(kept(30), fine, 1e-2);
}

// At rest the dashpots have given way: a block that hangs is as long as its modulus at rest says, and stays so
// when motion begins; a blow of a load finds it stiffer.
TEST_P(Memory, ComesToRestOnItsModulusAtRest)
{
    const std::vector<MaxwellBranch> branches = hysteretic_branches(0.1, 1, 40);
    Model model = block_with(GetParam(), branches);
    hold(model, add_box(model, "floor", {-1, -1, -2}, {1, 1, -0.5 * length}));
    State state = initial_state(model);
    const RunReport rested = run_quietly(model, {static_stage(0.1)}, state);
    ASSERT_EQ(rested.outcome, Outcome::completed);
    Model plain = block_with(GetParam(), {});
    hold(plain, add_box(plain, "floor", {-1, -1, -2}, {1, 1, -0.5 * length}));
    State same = initial_state(plain);
    ASSERT_EQ(run_quietly(plain, {static_stage(0.1)}, same).outcome, Outcome::completed);
    const auto short_by = [&](const State& of) { return 1 - pose_of(GetParam(), of, 0).map(2, 2); };
    EXPECT_GT(short_by(same), 1e-3);
    EXPECT_NEAR(short_by(state), short_by(same), 1e-6 * short_by(same));
    EXPECT_NEAR(stress_of(model, state, 0)(2, 2), stress_of(plain, same, 0)(2, 2), 1.0);
    begin_stage(model, 0, state);
    const double before = short_by(state);
    run_quietly(model, {dynamic_stage(0.5, 1e-3)}, state);
    EXPECT_NEAR(short_by(state), before, 1e-5 * before);
}

// A spinning block is neither stretched nor slowed by what it remembers: strains of Green turn with it.
TEST_P(Memory, KnowsNoRotation)
{
    BlockMaterial material{"ground", density, 2e10, 0.2};
    material.branches = hysteretic_branches(0.1, 1, 100);
    Model model = make_model(GetParam(), material, dry(30));
    add_box(model, "cube", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    State state = initial_state(model);
    set_velocity(model, state, 0, Vector3d::Zero(), {0, 1, 0});
    const RunReport report = run_quietly(model, {dynamic_stage(2, 2e-3, Vector3d::Zero())}, state);
    EXPECT_NEAR(angular_velocity_of(model, state, 0).y(), 1, 1e-6);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

}  // namespace voussoir::testing
