// The references of the rocking, knocking and waving benchmarks, each against a limit that is known otherwise.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/studies/verify/mode_chart_points.h"
#include "app/studies/verify/references/kinetic_damping.h"
#include "app/studies/verify/references/layered_site.h"
#include "app/studies/verify/references/mode_chart.h"
#include "app/studies/verify/references/newmark_rebound.h"
#include "app/studies/verify/references/rebound.h"
#include "app/studies/verify/references/rocking.h"
#include "app/studies/verify/references/shear_wave.h"
#include "app/studies/verify/references/smooth_ode.h"

namespace voussoir::reference
{

using Eigen::VectorXd;
constexpr double pi = std::numbers::pi;

TEST(SmoothOde, FindsTheZerosOfACosine)
{
    app::studies::verify::references::OdePoint point;
    point.y = VectorXd{{1, 0}};
    const app::studies::verify::references::Derivative f = [](double, const VectorXd& y) {
        return VectorXd{{y[1], -y[0]}};
    };
    ASSERT_TRUE(app::studies::verify::references::integrate(
        f, 10, 1e-12, [](double, const VectorXd& y) { return y[0]; }, point));
    EXPECT_NEAR(point.time, pi / 2, 1e-10);
    ASSERT_FALSE(app::studies::verify::references::integrate(f, 10, 1e-12, {}, point));
    EXPECT_NEAR(point.y[0], std::cos(10.0), 1e-10);
}

// Both thresholds as another program found them: docs/numerics.md 4.
TEST(Rocking, ThresholdsOfTheFullAndTheLinearEquation)
{
    app::studies::verify::references::RockingBlock block{0.2, 0.6, 9.81, 0, 1, false};
    const double full = app::studies::verify::references::overturning_threshold(block);
    block.linear = true;
    const double linear = app::studies::verify::references::overturning_threshold(block);
    std::printf("thresholds: full %.6f, linearised %.6f m/s2\n", full, linear);
    EXPECT_NEAR(full, 5.638, 5e-4);
    EXPECT_NEAR(linear, 5.4405, 5e-5);
}

// Linear, under gravity only: theta = alpha - (alpha - theta0) cosh(p t) until the first impact.
TEST(Rocking, LinearBlockFallsBackLikeACosh)
{
    app::studies::verify::references::RockingBlock block{0.2, 0.6, 9.81, 5, 1, true};
    const double alpha = app::studies::verify::references::slenderness(block),
                 p = std::sqrt(0.75 * 9.81 / std::hypot(0.2, 0.6));
    const double impact = *app::studies::verify::references::first_impact(block);
    std::vector<double> times;
    for (int i = 0; i < 40; ++i) times.push_back(0.5 + (impact - 0.5) * i / 40);
    const std::vector<double> angles = app::studies::verify::references::rocking_angles(block, times);
    // Two points fix A and B of -theta = alpha + A e^(pt) + B e^(-pt).
    const double x = alpha + angles[0], y = alpha + angles[1], d = times[1] - times[0];
    const double a = (y - x * std::exp(-p * d)) / (2 * std::sinh(p * d)), b = x - a;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double t = times[i] - times[0];
        EXPECT_NEAR(angles[i], -alpha + a * std::exp(p * t) + b * std::exp(-p * t), 1e-8);
    }
}

TEST(Rocking, ImpactsTakeHousnersShare)
{
    const app::studies::verify::references::RockingBlock block{0.2, 0.6, 9.81, 5.43, 1, false};
    std::vector<double> times;
    for (int i = 0; i < 50000; ++i) times.push_back(i * 1e-4);
    const std::vector<double> angles = app::studies::verify::references::rocking_angles(block, times);
    std::vector<double> apexes;
    for (std::size_t i = 1; i + 1 < angles.size(); ++i)
        if (times[i] > 0.5 && std::abs(angles[i]) > std::abs(angles[i - 1]) &&
            std::abs(angles[i]) >= std::abs(angles[i + 1]))
            apexes.push_back(std::abs(angles[i]));
    ASSERT_GE(apexes.size(), 3u);
    EXPECT_NEAR(app::studies::verify::references::housner_restitution(block), 0.85, 1e-12);
    EXPECT_NEAR(app::studies::verify::references::restitution_between(block, apexes[0], apexes[1]), 0.85, 1e-5);
    EXPECT_NEAR(app::studies::verify::references::restitution_between(block, apexes[1], apexes[2]), 0.85, 1e-5);
}

// A cube that hardly deforms is a mass on a spring: depth from its energy, height as dropped.
TEST(Rebound, OfAStiffCubeIsThatOfAMassOnASpring)
{
    const app::studies::verify::references::DroppedCube cube{2, 2000, 3e14, 0.15, 1.2e9, 3, 9.81};
    const app::studies::verify::references::Rebound rebound =
        app::studies::verify::references::first_rebound(cube);
    const double mass = 16000, d0 = mass * 9.81 / cube.stiffness;
    EXPECT_NEAR(rebound.penetration, d0 + std::sqrt(d0 * d0 + 2 * d0 * 3), 1e-4 * rebound.penetration);
    EXPECT_NEAR(rebound.height, 3, 1e-3);
    EXPECT_NEAR(app::studies::verify::references::settled_penetration(cube), 1.308e-4, 1e-8);
}

// A stiff cube loses by the integrator only: exp(-pi omega h / 2) of the height is left for small omega h; and for
// small steps the scheme finds the exact rebound.
TEST(Rebound, OfThePapersScheme)
{
    const app::studies::verify::references::DroppedCube stiff{2, 2000, 3e14, 0.15, 1.2e9, 3, 9.81},
        soft{2, 2000, 3e9, 0.15, 1.2e9, 3, 9.81};
    const double omega = std::sqrt(1.2e9 / 16000);
    EXPECT_NEAR(app::studies::verify::references::newmark_loss(stiff, 2e-4), 1 - std::exp(-pi * omega * 2e-4 / 2),
                0.01);
    EXPECT_NEAR(app::studies::verify::references::newmark_loss(soft, 1e-5),
                1 - app::studies::verify::references::first_rebound(soft).height / 3, 0.02);
}

// In every point of the chart exactly the mode of the chart keeps all its own conditions.
TEST(ModeChart, ModesKeepTheConditionsOfRigidBodies)
{
    int counts[4] = {};
    for (const app::studies::verify::ChartCase& point :
         app::studies::verify::chart_points(app::studies::verify::ChartKind::pseudo_static, 400, 7)) {
        const auto& [psi, delta, phi] = point.chart;
        const app::studies::verify::references::Mode expected =
            app::studies::verify::references::mode_of(point.chart);
        ++counts[static_cast<int>(expected)];
        for (const app::studies::verify::references::Mode mode :
             {app::studies::verify::references::Mode::sliding, app::studies::verify::references::Mode::toppling,
              app::studies::verify::references::Mode::both}) {
            double slip = 0, turn = 0;
            app::studies::verify::references::first_accelerations(point.chart, mode, slip, turn);
            const double s = std::sin(delta), c = std::cos(delta), normal = std::cos(psi) + s * turn;
            const double shear = std::sin(psi) - slip - c * turn;
            bool holds = normal > 0 && (mode == app::studies::verify::references::Mode::toppling || slip > 0) &&
                         (mode == app::studies::verify::references::Mode::sliding || turn > 0);
            if (mode == app::studies::verify::references::Mode::toppling)
                holds = holds && shear <= normal * std::tan(phi);
            if (mode == app::studies::verify::references::Mode::sliding)
                holds = holds && shear * c <= normal * s;  // friction passes inside the base
            EXPECT_EQ(holds, mode == expected) << app::studies::verify::references::name_of(mode) << " at psi "
                                               << psi << " delta " << delta << " phi " << phi;
        }
    }
    for (const int count : counts) EXPECT_GT(count, 10);
}

TEST(ModeChart, BoundariesMeetWherePsiIsDelta)
{
    for (const double angle : {0.2, 0.5, 0.9})
        EXPECT_NEAR(app::studies::verify::references::dynamic_friction_angle(angle, angle), angle, 1e-12);
}

// Uniform and undamped: 1 / cos(2 pi f H / c); damped, the peak is close to 2 / (pi xi) at f = c / 4 H.
TEST(LayeredSite, UniformLayersAreOneLayer)
{
    const double infinite = INFINITY, c = 880;
    std::vector<app::studies::verify::references::SiteLayer> layers(15, {1, 2000, 2000 * c * c, infinite});
    for (const double f : {1.0, 5.0, 12.0, 20.0})
        EXPECT_NEAR(std::abs(app::studies::verify::references::amplification(layers, f, 0)),
                    std::abs(1 / std::cos(2 * pi * f * 15 / c)), 1e-9);
    const double natural = c / 60, xi = 0.02;
    EXPECT_NEAR(
        std::abs(app::studies::verify::references::amplification(layers, natural, 2 * xi / (2 * pi * natural))),
        2 / (pi * xi), 0.02 * 2 / (pi * xi));
    // A joint of finite stiffness in every metre is, for long waves, a softer modulus.
    for (app::studies::verify::references::SiteLayer& layer : layers)
        layer.joint_stiffness = 10 * layer.shear_modulus;
    const double slow = std::sqrt(
        app::studies::verify::references::jointed_shear_modulus(2000 * c * c, 10 * 2000 * c * c, 1) / 2000);
    EXPECT_NEAR(std::abs(app::studies::verify::references::amplification(layers, 2, 0)),
                std::abs(1 / std::cos(2 * pi * 2 * 15 / slow)), 1e-3);
}

TEST(LayeredSite, PeaksAndSpectra)
{
    std::vector<double> values, samples;
    for (int i = 0; i < 100; ++i) values.push_back(5 - std::pow(0.1 * i - 4.234, 2));
    const std::vector<app::studies::verify::references::Peak> peaks =
        app::studies::verify::references::peaks_of(values, 0, 0.1);
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_NEAR(peaks[0].frequency, 4.234, 1e-9);
    EXPECT_NEAR(peaks[0].value, 5, 1e-9);
    for (int i = 0; i < 2000; ++i) samples.push_back(std::exp(-std::pow((i * 1e-3 - 1) / 0.05, 2)));
    EXPECT_NEAR(std::abs(app::studies::verify::references::fourier(samples, 1e-3, 5)),
                std::sqrt(pi) * 0.05 * std::exp(-std::pow(pi * 5 * 0.05, 2)), 1e-9);
}

// At the free surface the wave doubles; back at the base it finds the prescribed motion.
TEST(ShearWave, DoublesAtTheSurface)
{
    const auto base = [](double t) { return t > 0 && t < 0.02 ? std::sin(100 * pi * t) : 0.0; };
    for (double t = 0; t < 0.2; t += 1.7e-3) {
        EXPECT_NEAR(app::studies::verify::references::shear_wave(base, 2000, 50, 0, t), base(t), 1e-12);
        if (t > 0.07) continue;
        EXPECT_NEAR(app::studies::verify::references::shear_wave(base, 2000, 50, 50, t), 2 * base(t - 0.025),
                    1e-12);
    }
    std::vector<double> trace;
    for (int i = 0; i < 400; ++i)
        trace.push_back(app::studies::verify::references::shear_wave(base, 2000, 50, 18.5, i * 1e-4 - 0.7e-4));
    EXPECT_NEAR(
        app::studies::verify::references::lag_of(
            trace, [&](double t) { return app::studies::verify::references::shear_wave(base, 2000, 50, 18.5, t); },
            1e-4),
        0.7e-4, 1e-6);
}

TEST(KineticDamping, ClosedFormsAgainstTheSums)
{
    double u = 0, v = 0;
    for (int n = 0; n < 500; ++n) {
        u += 0.01 * v + 0.5 * 2 * 1e-4;
        v = 0.97 * (v + 0.01 * 2);
    }
    EXPECT_NEAR(app::studies::verify::references::displacement_with_factor(2, 0.97, 0.01, 500), u, 1e-12 * u);
    EXPECT_NEAR(app::studies::verify::references::displacement_with_rate(2, 1e-4, 3), 9, 1e-3);
    EXPECT_NEAR(app::studies::verify::references::displacement_with_factor(2, std::exp(-0.5e-5), 1e-5, 100000),
                app::studies::verify::references::displacement_with_rate(2, 0.5, 1), 1e-5);
}

}  // namespace voussoir::reference
