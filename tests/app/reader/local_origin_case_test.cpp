// Scenes far from the origin of coordinates: the answer that they have at it, in the user's coordinates, or a
// refusal.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "libdda/model/state.h"
#include "libdda/run/run.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector3d;

/// A slab that slides down an incline, all of it x east and x south of the origin.
std::string incline(double x, double size = 1)
{
    const auto box = [&](const char* name, const Vector3d& lower, const Vector3d& upper) {
        return fmt::format(
            "  - box: {{name: {}, lower: [{:.17g}, {:.17g}, {}], upper: [{:.17g}, {:.17g}, {}], "
            "rotate: {{axis: y, angle: 30 deg, about: [{:.17g}, {:.17g}, 0]}}}}\n",
            name, size * lower.x() + x, size * lower.y() - x, size * lower.z(), size * upper.x() + x,
            size * upper.y() - x, size * upper.z(), x, -x);
    };
    return "materials: {stone: {density: 2000 kg/m3, young: 10 GPa, poisson: 0.2}}\n"
           "joints: {dry: {friction: 10 deg}}\nblocks:\n" +
           box("plane", {-2, -2, -1}, {10, 2, 0}) + "    group: foundation\n" +
           box("slab", {-0.5, -0.5, 0}, {0.5, 0.5, 0.125}) +
           "foundation: {blocks: foundation}\n"
           "stages: [{name: sliding, type: dynamic, duration: 0.05 s, time_step: 1 ms}]\n";
}

/// Where the slab is at the end, user's coordinates [m].
Vector3d end_of(const std::string& text)
{
    const Case the_case = read(text);
    State state = initial_state(the_case.model);
    EXPECT_EQ(run(the_case.model, the_case.stages, state, {}).outcome, Outcome::completed);
    return pose_of(the_case.model.kinematics, state, 1).centroid + the_case.model.origin;
}

}  // namespace

TEST(LocalOrigin, AMillionKilometresAwayStonesMoveAsAtTheOrigin)
{
    const Vector3d here = end_of(incline(0));
    EXPECT_GT(here.x(), 3e-3);
    for (const double x : {1e6, 1e9}) {
        const Vector3d there = end_of(incline(x));
        EXPECT_LT((there - Vector3d(x, -x, 0) - here).cwiseAbs().maxCoeff(), 4e-16 * x) << x;
    }
}

TEST(LocalOrigin, IsThatOfTheUserForScenesNearIt)
{
    for (const double x : {0.0, 100.0, 9e3}) {
        const Case the_case = read(incline(x));
        EXPECT_EQ(the_case.model.origin, Vector3d::Zero());
        EXPECT_EQ(the_case.model.fit_tolerance, 0);
    }
}

TEST(LocalOrigin, StonesThatCoordinatesRoundAreRefused)
{
    EXPECT_EQ(faults_of(incline(1e9)), "no fault");
    EXPECT_NE(
        faults_of(incline(1e9, 0.05)).find("slab: 1e+09 m from the origin of coordinates, where they are rounded"),
        std::string::npos);
    EXPECT_NE(faults_of(incline(1e12)).find("count the coordinates from a place nearer to the structure"),
              std::string::npos);
}

// It was run, and gave up at its first step: about the middle of a stone longer than the way to the sun nothing is
// small.
TEST(LocalOrigin, StonesBesideOneSoLongThatItsCornersAreRoundedAreRefused)
{
    std::string text = incline(0);
    const auto as_long_as = [&](const char* length) {
        return std::string(text).replace(text.find("[10, 2, 0]"), 10, length);
    };
    EXPECT_EQ(faults_of(as_long_as("[1e9, 2, 0]")), "no fault");
    EXPECT_NE(faults_of(as_long_as("[1e12, 2, 0]"))
                  .find("plane: 8.66e+11 m long, so that its corners are rounded by up to"),
              std::string::npos);
}

// A resting stone was told to gain energy, or to fall.
TEST(LocalOrigin, StonesWhoseStressesAreRoundingAreRefused)
{
    std::string text = incline(0);
    text.replace(text.find("10 GPa"), 6, "1e16 Pa");
    text.replace(text.find("2000 kg/m3"), 10, "1 kg/m3");
    EXPECT_NE(faults_of(text).find("with a modulus of 1e+16 Pa stresses are rounded by"), std::string::npos);
    EXPECT_EQ(faults_of("kinematics: spatial_rigid\n" + text), "no fault");
}

}  // namespace voussoir::app::reader
