// The references of what the program does when it is told nothing, each against a limit that is known otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/references/rocking_on_springs.h"
#include "app/studies/verify/references/slipping_joint.h"
#include "app/studies/verify/references/vibration.h"

namespace voussoir::app::studies::verify::references
{

namespace
{

using std::numbers::pi;

TEST(RodReference, OneElementIsAThirdOfItsMassOnItsSpringAndManyAreTheRod)
{
    EXPECT_NEAR(rod_frequency(1, 800, 20), std::sqrt(3.0) * 800 / 20 / (2 * pi), 1e-12);
    EXPECT_NEAR(rod_frequency(1000, 800, 20), 10, 1e-5);
    for (int n = 1; n < 8; ++n) EXPECT_GT(rod_frequency(n, 800, 20), rod_frequency(n + 1, 800, 20));
}

// The sum over the modes of a column on a base that moves by d sin(w t): participation 4 / (pi (2 n + 1)), the
// shape at the top +-1, mass-proportional damping the same rate for all.
TEST(LayerReference, IsTheSumOfItsModes)
{
    const double speed = 200, height = 20;
    for (const double rate : {0.3, 1.5})
        for (const double frequency : {1.0, 2.5, 6.0}) {
            const double omega = 2 * pi * frequency;
            double real = 0, imaginary = 0;
            for (int n = 0; n < 20000; ++n) {
                const double mode = (2 * n + 1) * pi * speed / (2 * height);
                const double share = 4 / (pi * (2 * n + 1)) * (n % 2 == 0 ? 1 : -1) * omega * omega;
                const double a = mode * mode - omega * omega, b = omega * rate;
                real += share * a / (a * a + b * b);
                imaginary -= share * b / (a * a + b * b);
            }
            EXPECT_NEAR(layer_amplitude(speed, height, rate, frequency), std::hypot(real, imaginary), 1e-6);
        }
}

// At resonance, with little damping, 4 / pi of an oscillator's 1 / (2 xi).
TEST(LayerReference, AtResonanceIsFourOverPiTimesAnOscillator)
{
    for (const double damping : {0.02, 0.05})
        EXPECT_NEAR(layer_amplitude(200, 20, 4 * pi * 2.5 * damping, 2.5) * 2 * damping, 4 / pi, 2e-3);
}

TEST(SlipReference, SharesAddUpAndEndWhereTheJointSticksOrIsGone)
{
    for (const double s : {0.05, 0.2, 0.5, 0.9}) {
        const SlipCoefficients of = slip_coefficients(s);
        EXPECT_NEAR(std::pow(of.transmitted, 2) + std::pow(of.reflected, 2) + std::pow(of.absorbed, 2), 1, 1e-12);
    }
    for (const double s : {1.0, 3.0}) {
        EXPECT_NEAR(slip_coefficients(s).transmitted, 1, 1e-12);
        EXPECT_NEAR(slip_coefficients(s).reflected, 0, 1e-7);
    }
    EXPECT_NEAR(slip_coefficients(1e-9).reflected, 1, 1e-8);
}

// What passes is the sine clipped at s, summed here as it stands.
TEST(SlipReference, IsTheClippedSine)
{
    for (const double s : {0.1, 0.4, 0.8}) {
        double passed = 0, returned = 0, all = 0;
        for (int i = 0; i < 100000; ++i) {
            const double v = std::sin(2 * pi * (i + 0.5) / 100000), through = std::clamp(v, -s, s);
            passed += through * through;
            returned += (v - through) * (v - through);
            all += v * v;
        }
        EXPECT_NEAR(slip_coefficients(s).transmitted, std::sqrt(passed / all), 1e-6);
        EXPECT_NEAR(slip_coefficients(s).reflected, std::sqrt(returned / all), 1e-6);
    }
}

class SpringReference : public ::testing::Test
{
 protected:
    const RockingBlock block_{0.1, 0.3, 9.81, 5.4, 1, false};
    const std::vector<double> times_{0.05, 0.1, 0.2, 0.3, 0.4, 0.45};

    static CornerSprings springs(double normal, double friction)
    {
        return {.mass = 300, .normal = normal, .shear = 0.5 * normal, .friction = friction};
    }
};

TEST_F(SpringReference, StiffSpringsAreARigidGround)
{
    const std::vector<double> rigid = rocking_angles(block_, times_);
    double before = INFINITY;
    for (const double normal : {1e8, 1e9, 1e10}) {
        const std::vector<double> soft = rocking_angles_on_springs(block_, springs(normal, 1.7), times_);
        const double apart = std::abs(soft.back() / rigid.back() - 1);
        EXPECT_LT(apart, 0.3 * before) << normal;
        before = apart;
    }
    EXPECT_LT(before, 2e-4);
}

// Before it lifts the block tilts by M / (2 k b^2), M the moment of inertia forces about its base; slowly loaded.
TEST_F(SpringReference, TiltsOnItsSpringsBeforeItLifts)
{
    RockingBlock slow = block_;
    slow.amplitude = 0.5;  // never lifts
    slow.frequency = 0.25;
    const double normal = 1e8;
    const std::vector<double> angle = rocking_angles_on_springs(slow, springs(normal, 1.7), {1.0});
    const double moment = 300 * slow.amplitude * slow.half_height;
    // Springs in shear let the block slide, which turns nothing; its weight leans with it.
    const double stiffness = 2 * normal * 0.01 - 300 * 9.81 * slow.half_height;
    EXPECT_NEAR(angle[0], -moment / stiffness, 0.01 * moment / stiffness);
}

}  // namespace

}  // namespace voussoir::app::studies::verify::references
