// No model that passes the judgement before its first step may stop in its first static stage for its geometry,
// nor with a stiffness as remedy: a property of generated assemblies, drawn more or less badly.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "libdda/analysis/diagnosis.h"
#include "libdda/analysis/drawn_misfit.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

using Eigen::Vector3d;

namespace
{

constexpr int assemblies_of_a_kind = 60;

/// How badly stones are drawn: every plane of every stone is off by itself.
struct Draughtsman {
    Random random;
    double shift = 0;  // of a stone's smallest side, largest
    double tilt = 0;   // rad, largest

    explicit Draughtsman(unsigned seed) : random(seed)
    {
        shift = std::pow(10, random.between(-6, -1.2));
        tilt = random.between(0, 1) < 0.3 ? 0 : std::pow(10, random.between(-6, -1.5));
    }
    /// A plane n . x = d through a point, as drawn.
    Eigen::Vector4d plane(const Vector3d& normal, const Vector3d& point, double side)
    {
        const Vector3d n = (normal.normalized() + tilt * random.vector()).normalized();
        return {n.x(), n.y(), n.z(), n.dot(point) + shift * side * random.between(-1, 1)};
    }
};

/// The hexahedron between six planes, given in pairs: low and high along its three axes.
ConvexPolyhedron between_planes(const std::array<Eigen::Vector4d, 6>& planes)
{
    std::vector<Vector3d> corners;
    for (int k = 0; k < 8; ++k) {
        Eigen::Matrix3d normals;
        Vector3d offsets;
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector4d& plane = planes[2 * axis + (k >> axis & 1)];
            normals.row(axis) = plane.head<3>();
            offsets[axis] = plane[3];
        }
        corners.push_back(normals.partialPivLu().solve(offsets));
    }
    return make_convex_polyhedron(
        corners, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

/// A box as it was meant, drawn.
ConvexPolyhedron drawn_box(Draughtsman& hand, const Vector3d& lower, const Vector3d& upper)
{
    const double side = (upper - lower).minCoeff();
    std::array<Eigen::Vector4d, 6> planes;
    for (int axis = 0; axis < 3; ++axis) {
        planes[2 * axis] = hand.plane(Vector3d::Unit(axis), lower, side);
        planes[2 * axis + 1] = hand.plane(Vector3d::Unit(axis), upper, side);
    }
    return between_planes(planes);
}

void add(Model& model, std::vector<ConvexPolyhedron> parts)
{
    model.blocks.push_back(make_block("stone_" + std::to_string(model.blocks.size()), 0, 0, std::move(parts)));
}

Model on_ground(Kinematics kinematics)
{
    Model model = make_model(kinematics, stone(5e9), dry(35));
    hold(model, add_box(model, "ground", {-3, -3, -1}, {6, 3, 0}));
    return model;
}

/// Courses of stones of different heights and lengths, the joints broken.
Model wall(Kinematics kinematics, Draughtsman& hand)
{
    constexpr double end = 1.6;  // m, of every course
    Model model = on_ground(kinematics);
    double z = 0;
    for (int course = 0; course < 3; ++course) {
        const double height = hand.random.between(0.15, 0.4), length = hand.random.between(0.4, 0.8);
        double x = 0, first = course % 2 == 0 ? 1 : 0.6;
        while (x < end) {
            const double meant = x + first * length, right = meant > end - 0.3 * length ? end : meant;
            add(model, {drawn_box(hand, {x, 0, z}, {right, 0.4, z + height})});
            x = right;
            first = 1;
        }
        z += height;
    }
    return model;
}

/// Stones of any size on one another, a thin slab between some.
Model column(Kinematics kinematics, Draughtsman& hand)
{
    Model model = on_ground(kinematics);
    double z = 0;
    for (int drum = 0; drum < 5; ++drum) {
        const double height = hand.random.between(0, 1) < 0.3 ? 0.02 : hand.random.between(0.1, 0.8);
        const double half = hand.random.between(0.2, 0.4);
        add(model, {drawn_box(hand, {-half, -half, z}, {half, half, z + height})});
        z += height;
    }
    return model;
}

/// Half a ring of wedges on two springers that are held.
Model arch(Kinematics kinematics, Draughtsman& hand)
{
    Model model = make_model(kinematics, stone(5e9), dry(35));
    constexpr double radius = 2, thickness = 0.5;
    const int count = 5 + static_cast<int>(hand.random.between(0, 5));
    for (int i = -1; i <= count; ++i) {
        const double from = i * 180.0 / count * degrees, to = (i + 1) * 180.0 / count * degrees;
        const double middle = (from + to) / 2;
        const auto radial = [](double angle) { return Vector3d(-std::cos(angle), 0, std::sin(angle)); };
        const auto along = [](double angle) { return Vector3d(std::sin(angle), 0, std::cos(angle)); };
        const double side = std::min(thickness, radius * (to - from));
        add(model, {between_planes({hand.plane(radial(middle), radius * radial(middle), side),
                                    hand.plane(radial(middle), (radius + thickness) * radial(middle), side),
                                    hand.plane(along(from), radius * radial(from), side),
                                    hand.plane(along(to), radius * radial(to), side),
                                    hand.plane(Vector3d::UnitY(), {0, 0, 0}, side),
                                    hand.plane(Vector3d::UnitY(), {0, 0.6, 0}, side)})});
        if (i == -1 || i == count) hold(model, static_cast<int>(model.blocks.size()) - 1);
    }
    return model;
}

/// L-shaped stones of two glued parts, one on the other, with a stone in each notch. Their parts are slivers.
Model corner_stones(Kinematics kinematics, Draughtsman& hand)
{
    Model model = on_ground(kinematics);
    for (int tier = 0; tier < 2; ++tier) {
        const double z = 0.6 * tier, leg = hand.random.between(0.03, 0.3);
        ConvexPolyhedron upright = drawn_box(hand, {0, 0, z}, {leg, 0.5, z + 0.6});
        ConvexPolyhedron foot = drawn_box(hand, {leg, 0, z}, {1, 0.5, z + 0.2});
        for (ConvexPolyhedron* part : {&upright, &foot}) {
            part->glued.assign(part->faces.size(), false);
            for (int face = 0; face < static_cast<int>(part->faces.size()); ++face)
                part->glued[face] = face_normal(*part, face).x() * (part == &upright ? 1 : -1) > 0.5;
        }
        add(model, {upright, foot});
        add(model, {drawn_box(hand, {leg, 0, z + 0.2}, {1, 0.5, z + 0.6})});
    }
    return model;
}

using Maker = Model (*)(Kinematics, Draughtsman&);

bool is_accepted(const Model& model)
{
    return !start_diagnosis(drawn_overlaps(OverlapWatch(model))) &&
           too_soft_stones(model, {0, 0, -gravity}).empty();
}

RunReport brought_to_rest(const Model& model)
{
    const Stage stage = static_stage(1);
    State state = initial_state(model);
    return run_quietly(model, {stage}, state);
}

class AcceptedModels : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, AcceptedModels, spatial_kinematics(), test_name);

const std::pair<const char*, Maker> makers[] = {
    {"wall", wall}, {"column", column}, {"arch", arch}, {"corner", corner_stones}};

}  // namespace

// Where stones are drawn so far off that they fall into place, gathering speed, a static stage says so. Which of
// those that are drawn one to two hundredths off do is up to rounding: another optimisation has other ones fall.
TEST_P(AcceptedModels, ComeToRestUnlessTheyAreDrawnFarOff)
{
    constexpr double far_off = 0.01;  // of a side, rad
    int refused = 0, falling = 0;
    for (const auto& [kind, make] : makers)
        for (int seed = 0; seed < assemblies_of_a_kind; ++seed) {
            Draughtsman hand(seed);
            Model model = make(GetParam(), hand);
            model.fit_tolerance = drawn_misfit(model).tolerance();
            if (!is_accepted(model)) {
                ++refused;
                continue;
            }
            const RunReport report = brought_to_rest(model);
            if (report.outcome == Outcome::completed) continue;
            // Or two of its faces take turns to touch, and nothing comes to rest.
            EXPECT_TRUE(report.outcome == Outcome::collapsed ||
                        report.diagnosis->kind == DiagnosisKind::no_equilibrium)
                << kind << " " << seed << ": " << *report.diagnosis;
            EXPECT_GT(std::max(hand.shift, hand.tilt), far_off)
                << kind << " " << seed << ": " << *report.diagnosis;
            ++falling;
        }
    std::printf("%d refused, %d fall into place\n", refused, falling);
    EXPECT_GT(refused, 0);
    EXPECT_LT(refused, assemblies_of_a_kind / 2);
    EXPECT_LT(falling, assemblies_of_a_kind / 4);
}

// Joints of any stiffness a user may give: where they are too soft the model is refused.
TEST_P(AcceptedModels, HaveJointsThatCarryThem)
{
    int accepted = 0, refused = 0;
    for (const auto& [kind, make] : makers)
        for (int seed = 0; seed < assemblies_of_a_kind; ++seed) {
            Draughtsman hand(seed);
            hand.shift = hand.tilt = 0;
            Model model = make(GetParam(), hand);
            model.joints[0].stiffness = {ContactStiffness::Kind::per_area,
                                         std::pow(10, hand.random.between(4.5, 8))};
            (is_accepted(model) ? accepted : refused)++;
            if (!is_accepted(model)) continue;
            const RunReport report = brought_to_rest(model);
            EXPECT_EQ(report.outcome, Outcome::completed)
                << kind << " " << seed << ", " << model.joints[0].stiffness.value
                << " Pa/m: " << *report.diagnosis;
        }
    EXPECT_GT(accepted, 20);
    EXPECT_GT(refused, 20);
}

}  // namespace voussoir::testing
