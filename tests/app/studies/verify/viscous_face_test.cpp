// The closed forms of waves at the end of a model, held against what they must be in special cases.
#include "app/studies/verify/references/viscous_face.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace voussoir::app::studies::verify::references
{
namespace
{

const double speeds = 1 / std::sqrt(3.0);  // of Poisson's ratio 1/4

TEST(ViscousFace, LetsWavesAlongItsNormalThrough)
{
    EXPECT_NEAR(reflected_energy(0, speeds, true), 0, 1e-15);
    EXPECT_NEAR(reflected_energy(0, speeds, false), 0, 1e-15);
}

// All that dashpots do not take comes back: grazing waves find none of it taken.
TEST(ViscousFace, SendsGrazingWavesBack)
{
    EXPECT_NEAR(reflected_energy(std::numbers::pi / 2 - 1e-6, speeds, true), 1, 1e-4);
    EXPECT_NEAR(reflected_energy(std::numbers::pi / 2 - 1e-6, speeds, false), 1, 1e-4);
    for (double angle = 0.05; angle < 1.55; angle += 0.05)
        for (const bool pressure : {true, false}) {
            EXPECT_GE(reflected_energy(angle, speeds, pressure), 0);
            EXPECT_LE(reflected_energy(angle, speeds, pressure), 1);
        }
}

// By hand, for a solid in which P and S share one angle of 45 degrees (no such solid, but the formulas know none):
// stress of P along the normal 1 - 2 sin^2 = 0, across 2 sin cos = 1; dashpots cos = sin = 1/sqrt(2). The
// equations are -c p + (1 + c) s = -c, (1 + c) p + c s = 1 - c, c = 1/sqrt(2).
TEST(ViscousFace, AgreesWithTwoEquationsSolvedByHand)
{
    const double c = 1 / std::sqrt(2.0), determinant = -c * c - (1 + c) * (1 + c);
    const double p = (-c * c - (1 + c) * (1 - c)) / determinant, s = (-c * (1 - c) + c * (1 + c)) / determinant;
    EXPECT_NEAR(reflected_energy(std::numbers::pi / 4, 1, true), p * p + s * s, 1e-12);
}

TEST(LayerOnRock, IsThatOfARigidBaseWithoutImpedanceAndNothingWithoutContrast)
{
    for (const double layer : {0.1, 0.2, 0.3, 0.7}) {
        const double phase = 2 * std::numbers::pi * layer;
        EXPECT_NEAR(std::abs(surface_over_outcrop(layer, 0, 1, 1)), 1 / std::abs(std::cos(phase)), 1e-12);
        EXPECT_NEAR(std::abs(surface_over_outcrop(layer, 1, 1, 1)), 1, 1e-12);
    }
    EXPECT_NEAR(std::abs(surface_over_outcrop(0.25, 0.2, 1, 1)), 5, 1e-12);
}

}  // namespace
}  // namespace voussoir::app::studies::verify::references
