// Whether blocks stand, against closed forms; forces nearest to a given one, against their definition.
#include "libdda/limit/balance.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "libdda/contact/face_points.h"
#include "libdda/limit/friction_set.h"
#include "libdda/limit/limit_factor.h"
#include "tests/libdda/limit/limit_problems.h"

namespace voussoir::limit
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

LimitProblem under(LimitProblem problem, double factor)
{
    for (LimitBlock& block : problem.blocks) block.dead += factor * block.live;
    return problem;
}

class RandomForces
{
 public:
    Vector3d operator()() { return {normal_(random_), normal_(random_), normal_(random_)}; }

 private:
    std::mt19937_64 random_{1};
    std::normal_distribution<double> normal_;
};

FrictionSet set_of(int n)
{
    const Vector3d normal = Vector3d(1, n % 3 - 1, 0.5).normalized();
    if (n % 4 == 0) return {normal, 0.6, 0, 0};
    if (n % 4 == 1) return {normal, 0, 0.5, 0.3};
    if (n % 4 == 2) return {normal, 0.8, 0.5, 0.3};
    return {normal, 0, 0, 0};
}

bool contains(const FrictionSet& set, const Vector3d& force, double slack)
{
    const double pressing = force.dot(set.normal);
    const double shear = (force - pressing * set.normal).norm();
    return pressing >= -set.tension - slack && shear <= set.cohesion + set.friction * pressing + slack;
}

}  // namespace

TEST(NearestForce, IsOfTheSetAndNoneOfItIsNearer)
{
    RandomForces random;
    for (int n = 0; n < 400; ++n) {
        const FrictionSet set = set_of(n);
        const Vector3d given = random();
        const Vector3d nearest = nearest_force(set, given).force;
        ASSERT_TRUE(contains(set, nearest, 1e-12)) << n;
        for (int k = 0; k < 40; ++k) {
            const Vector3d other = nearest_force(set, given + random()).force;
            ASSERT_TRUE(contains(set, other, 1e-12));
            // A plane through the nearest force has the set on its other side.
            ASSERT_LE((given - nearest).dot(other - nearest), 1e-12) << n;
        }
    }
}

TEST(NearestForce, FollowsTheGivenOne)
{
    constexpr double small = 1e-6;
    RandomForces random;
    for (int n = 0; n < 400; ++n) {
        const FrictionSet set = set_of(n);
        const Vector3d given = random(), way = random();
        const NearestForce nearest = nearest_force(set, given);
        const Vector3d moved =
            (nearest_force(set, given + small * way).force - nearest_force(set, given - small * way).force) /
            (2 * small);
        ASSERT_LT((moved - nearest.derivative * way).norm(), 1e-5) << n;
        ASSERT_LT((nearest.derivative - nearest.derivative.transpose()).norm(), 1e-14);
        const Eigen::Vector3d own = Eigen::SelfAdjointEigenSolver<Matrix3d>(nearest.derivative).eigenvalues();
        ASSERT_GE(own.minCoeff(), -1e-12);
        ASSERT_LE(own.maxCoeff(), 1 + 1e-12);
    }
}

TEST(NearestForce, OfABarIsItsBoundsAlongAndAcross)
{
    const BarSet bar{Vector3d(1, 2, -1).normalized(), 2, 0.5, 0.7};
    RandomForces random;
    for (int n = 0; n < 200; ++n) {
        const Vector3d given = 2 * random(), across = given - given.dot(bar.axis) * bar.axis;
        const NearestForce nearest = nearest_force(bar, given);
        const Vector3d kept_across = std::min(1.0, bar.shear / across.norm()) * across;
        const double kept_along = std::clamp(given.dot(bar.axis), -bar.compression, bar.tension);
        ASSERT_LT((nearest.force - kept_along * bar.axis - kept_across).norm(), 1e-12);
        const Vector3d way = 1e-6 * random();
        const Vector3d moved = nearest_force(bar, given + way).force - nearest_force(bar, given - way).force;
        ASSERT_LT((moved - 2 * nearest.derivative * way).norm(), 1e-5 * way.norm());
    }
}

// It slides at mu and topples at width / height, whatever the direction in which it is pushed.
TEST(Balance, BlockSlidesOrTopples)
{
    for (const bool planar : {true, false})
        for (const double friction : {0.1, 0.3, 0.5}) {
            const double exact = std::min(friction, width / height);
            const LimitProblem problem = block_on_base(friction, planar);
            EXPECT_EQ(balance_of(under(problem, 0.999 * exact)).standing, Standing::balanced);
            EXPECT_EQ(balance_of(under(problem, 1.001 * exact)).standing, Standing::mechanism);
            EXPECT_NEAR(limit_factor(problem).value_or(0), exact, 1e-4 * exact);
        }
    for (const double angle : {0.0, 0.3, 1.1, 2.5}) {
        const LimitProblem problem = block_on_base(0.2, false, {std::cos(angle), std::sin(angle), 0});
        EXPECT_NEAR(limit_factor(problem).value_or(0), 0.2, 2e-5);
    }
}

// Pushed by twice its friction it leaves along the edge of the cone: at the angle of friction from the base.
TEST(Balance, MechanismSlidesOpenByTheAngleOfFriction)
{
    constexpr double friction = 0.2;
    const Balance balance = balance_of(under(block_on_base(friction, false), 0.3));
    ASSERT_EQ(balance.standing, Standing::mechanism);
    const Vector3d v = balance.velocities[1].centroid;
    EXPECT_NEAR(v.z() / v.x(), friction, 1e-3);
    EXPECT_NEAR(v.y() / v.x(), 0, 1e-6);
    EXPECT_LT(balance.velocities[1].spin.norm() * height, 1e-3 * v.norm());
    EXPECT_EQ(balance.velocities[0].centroid, Vector3d::Zero()) << "it is held";
    // The load (0.3, -1) along (1, 0.2) / norm, over its own: what friction leaves of it.
    EXPECT_NEAR(balance.acceleration, (0.3 - friction) / (1 + friction * friction), 0.01);
}

// A block in the air falls with the acceleration of its load.
TEST(Balance, BlockInTheAirFalls)
{
    LimitProblem problem = block_on_base(0.5, false);
    problem.contacts.clear();
    const Balance balance = balance_of(problem);
    ASSERT_EQ(balance.standing, Standing::mechanism);
    EXPECT_NEAR(balance.acceleration, 1, 1e-6);
    EXPECT_LT(balance.velocities[1].centroid.normalized().z(), -0.999);
}

// Hung from a ceiling by a bonded joint or by a rod: it falls when its weight exceeds what they bear.
TEST(Balance, BlockHangsByWhatHoldsIt)
{
    for (const bool planar : {true, false})
        for (const double bears : {0.99, 1.01}) {
            LimitProblem bonded = block_on_base(0.5, planar);
            const auto count = static_cast<double>(bonded.contacts.size());
            for (LimitContact& contact : bonded.contacts) {
                contact.normal = {0, 0, -1};
                contact.tension = bears / count;
                contact.cohesion = 2 * bears / count;
            }
            const Standing expected = bears > 1 ? Standing::balanced : Standing::mechanism;
            EXPECT_EQ(balance_of(bonded).standing, expected) << planar << bears;
            LimitProblem hung = block_on_base(0.5, planar);
            hung.contacts.clear();
            hung.bars.push_back({1, 0, {0, 0, height}, {0, 0, 3}, {0, 0, 1}, bears, 0, 0});
            EXPECT_EQ(balance_of(hung).standing, expected) << planar << bears;
            hung.bars[0].axis = {0, 0, -1};  // a strut from below
            hung.bars[0].end_a = {0, 0, 0};
            hung.bars[0].tension = 0;
            hung.bars[0].compression = bears;
            EXPECT_EQ(balance_of(hung).standing, expected) << planar << bears;
        }
}

// Cohesion of a bonded bed adds to friction: sliding at mu + c A / W.
TEST(Balance, CohesionHoldsASlidingBlock)
{
    constexpr double friction = 0.1, cohesion = 0.05;
    for (const bool planar : {true, false}) {
        LimitProblem problem = block_on_base(friction, planar);
        const auto count = static_cast<double>(problem.contacts.size());
        for (LimitContact& contact : problem.contacts) {
            contact.cohesion = cohesion / count;
            contact.tension = 0.1 / count;
        }
        EXPECT_NEAR(limit_factor(problem).value_or(0), friction + cohesion, 1e-4);
    }
}

/// A square of 1 N with these points, turned about its normal by two stones of no weight, 1 N each, through strong
/// rods.
LimitProblem turned_square(const std::vector<LimitContact>& points)
{
    constexpr double lever = 1, friction = 0.5;
    LimitProblem problem;
    problem.blocks.resize(4);
    problem.blocks[0].hold();
    problem.blocks[1] = {{}, false, {0, 0, 0}, {0, 0, -1}, {0, 0, 0}};
    problem.contacts = points;
    for (LimitContact& point : problem.contacts) {
        point.block_a = 1;
        point.normal = {0, 0, 1};
        point.friction = friction;
    }
    for (const int i : {2, 3}) {
        const double side = i == 2 ? 1 : -1;
        const Vector3d at(0, side * lever, 0), from(-side, side * lever, 0);
        LimitBlock& pusher = problem.blocks[static_cast<std::size_t>(i)];
        pusher = {{false, true, true}, true, from, {0, 0, 0}, {side, 0, 0}};
        problem.bars.push_back({i, 1, from, at, {side, 0, 0}, 1e3, 1e3, 0});
    }
    return problem;
}

// Even pressure turns about the centroid under mu W times its mean distance, 0.3826 of the side (0.3796 of the
// points of a face: a third of the area at the rim); pressure in the corners would bear 0.7071.
TEST(Balance, FaceTurnsUnderTheCoupleOfItsPressure)
{
    constexpr double side = 0.4, friction = 0.5;
    const double mean = (std::sqrt(2.0) + std::asinh(1.0)) / 6;
    std::vector<contact::PolygonPoint> face(4);
    for (int i = 0; i < 4; ++i) {
        const double x = i == 1 || i == 2 ? 1 : -1, y = i > 1 ? 1 : -1;
        face[static_cast<std::size_t>(i)].position = side / 2 * Vector3d(x, y, 0);
        face[static_cast<std::size_t>(i)].area = side * side / 4;
    }
    std::vector<LimitContact> corners, points;
    for (const contact::PolygonPoint& point : face) corners.push_back({0, 0, point.position});
    contact::add_inner_points(Vector3d::UnitZ(), face);
    for (const contact::PolygonPoint& point : face) {
        points.push_back({0, 0, point.position});
        points.back().stiffness = point.area / (side * side);
    }
    for (const bool all : {true, false}) {
        const LimitProblem problem = turned_square(all ? points : corners);
        const double limit = friction * side * (all ? mean : std::sqrt(0.5)) / 2;
        EXPECT_EQ(standing_without_dilatancy(under(problem, 0.98 * limit)), Standing::balanced) << all;
        EXPECT_EQ(standing_without_dilatancy(under(problem, 1.02 * limit)), Standing::mechanism) << all;
    }
}

// A stone between two that cannot give way: with dilatancy it is locked for good.
TEST(LimitFactor, IsNoneWhereStonesAreLocked)
{
    EXPECT_FALSE(limit_factor(stone_in_a_cleft(0.5, 0)));
    const double wide = std::atan(0.5) + 0.1;
    EXPECT_NEAR(limit_factor(stone_in_a_cleft(0.5, wide)).value_or(0), 1, 1e-4)
        << "nothing but its weight holds it";
    LimitProblem unsupported = block_on_base(0.5, true);
    unsupported.blocks[1].centroid.x() = 0.6 * width;
    EXPECT_FALSE(limit_factor(unsupported)) << "it does not stand at all";
    EXPECT_EQ(collapse_load(unsupported).outcome, UnderLoad::falls_before);
    EXPECT_EQ(collapse_load(stone_in_a_cleft(0.5, 0)).outcome, UnderLoad::bears_all);
}

// One block on one face: whether it opens while it slides decides nothing.
TEST(SlidingBracket, OfABlockOnItsBaseIsItsLimit)
{
    for (const bool planar : {false, true})
        for (const double friction : {0.1, 0.3}) {
            const LimitProblem problem = block_on_base(friction, planar);
            const std::optional<SlidingBracket> sliding = sliding_bracket(problem, friction);
            ASSERT_TRUE(sliding);
            EXPECT_EQ(sliding->slides_at, friction);
            EXPECT_NEAR(sliding->stands_at, 0.998 * friction, 1e-12);
            // Asked for twice its limit it is found all the same, by bisection.
            const std::optional<SlidingBracket> found = sliding_bracket(problem, 2 * friction);
            ASSERT_TRUE(found);
            EXPECT_NEAR(found->stands_at, friction, 0.005 * friction);
            EXPECT_NEAR(found->slides_at, friction, 0.005 * friction);
            EXPECT_LT(found->stands_at, found->slides_at);
        }
}

TEST(SlidingBracket, IsNotKnownOfBrittleJoints)
{
    LimitProblem bonded = block_on_base(0.3, true);
    for (LimitContact& contact : bonded.contacts) contact.cohesion = contact.tension = 0.1;
    EXPECT_FALSE(sliding_bracket(bonded, 0.3));
}

TEST(CollapseLoad, EndsWhereItsCallerThrows)
{
    struct Enough {
    };
    int asked = 0;
    const auto twice = [&] {
        if (++asked == 2) throw Enough();
    };
    EXPECT_THROW(collapse_load(block_on_base(0.3, true), twice), Enough);
}

}  // namespace voussoir::limit
