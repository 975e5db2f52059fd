// Planar scenes: contact of outlines, closed forms, and the same answers as a spatial scene one block thick.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <memory>

#include "libdda/analysis/joint_resultants.h"
#include "libdda/contact/narrow_phase_planar.h"
#include "libdda/errors.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

double twice_area(const ConvexPolygon& polygon)
{
    double sum = 0;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vector2d &p = polygon.vertices[i], &q = polygon.vertices[(i + 1) % polygon.vertices.size()];
        sum += p.x() * q.y() - p.y() * q.x();
    }
    return sum;
}

/// Two rectangles, the upper one turned and moved.
std::optional<contact::ContactSegment> contact_of(const Vector2d& place, double angle, double margin = 0.1)
{
    Model model = make_model(Kinematics::planar_rigid, stone(), dry(30));
    add_box(model, "lower", {-2, 0, -1}, {2, 1, 0});
    add_box(model, "upper", {-0.5, 0, -0.25}, {0.5, 1, 0.25});
    State state = initial_state(model);
    set_pose(model, state, 1, to_space(place), to_space(Matrix2d(Eigen::Rotation2Dd(angle)), 1));
    std::vector<contact::PlacedOutline> parts;
    contact::place_parts(model, state, 1, parts);
    return contact::contact_polygon(parts[0], parts[1], margin, std::nullopt);
}

/// A running-bond wall one stone thick on a base that shakes sideways and up and down: all in one plane.
struct Wall {
    Model model;
    State state;
    RunReport report;

    Wall(Kinematics kinematics, PlaneCondition plane, double duration,
         Integrator integrator = StepControl().integrator)
        : model(running_bond(kinematics, 4, 3))
    {
        if (is_planar(kinematics)) set_thickness(model, 0.3);
        model.plane = plane;
        for (BlockMaterial& material : model.materials) material.young = 5e9;
        JointMaterial& joint = model.joints[0];  // stiff in any kinematics: it slides before it stretches
        joint.stiffness.value = 100;
        joint.face = FaceLaw::corners;  // inside a face the points of a segment are others
        state = initial_state(model);
        Stage stage = shaking(duration, 1e-3);
        stage.motions.erase(stage.motions.begin() + 1);  // across the plane
        stage.control.force_tolerance = 1e-8;
        stage.control.integrator = integrator;
        report = run_quietly(model, {static_stage(0.1), stage}, state);
    }
};

double largest_distance(const Wall& one, const Wall& other)
{
    double most = 0;
    for (int b = 0; b < static_cast<int>(one.model.blocks.size()); ++b) {
        const Pose p = pose_of(one.model.kinematics, one.state, b),
                   q = pose_of(other.model.kinematics, other.state, b);
        const Vector3d apart = p.centroid - q.centroid;
        most = std::max(most, std::hypot(apart.x(), apart.z()));
    }
    return most;
}

double largest_slide(const Wall& wall)
{
    double most = 0;
    for (const JointResultant& joint : joint_resultants(wall.model, wall.state)) most = std::max(most, joint.slip);
    return most;
}

}  // namespace

TEST(ConvexPolygon, IsTurnedTheRightWayRoundAndLosesCornersOnStraightLines)
{
    const ConvexPolygon square = make_convex_polygon({{0, 0}, {0, 1}, {0, 2}, {2, 2}, {2, 0}});
    EXPECT_EQ(square.vertices.size(), 4U);
    EXPECT_NEAR(twice_area(square), 8, 1e-15);
}

TEST(ConvexPolygon, RefusesWhatIsNone)
{
    EXPECT_THROW(make_convex_polygon({{0, 0}, {1, 0}}), InputError);
    EXPECT_THROW(make_convex_polygon({{0, 0}, {1, 0}, {2, 0}}), InputError);
    EXPECT_THROW(make_convex_polygon({{0, 0}, {2, 0}, {1, 0.5}, {1, 2}}), InputError);
    EXPECT_THROW(make_convex_polygon({{0, 0}, {1, 0}, {1, 1}, {0, std::nan("")}}), InputError);
    std::vector<Vector2d> star;  // convex at every corner, twice around
    for (int i = 0; i < 5; ++i)
        star.emplace_back(std::cos(4 * std::numbers::pi * i / 5), std::sin(4 * std::numbers::pi * i / 5));
    EXPECT_THROW(make_convex_polygon(star), InputError);
}

TEST(ConvexPolygon, MomentsAreThoseOfThePrism)
{
    const std::vector<Vector2d> outline{{1e5, 3}, {1e5 + 2, 3.5}, {1e5 + 1.5, 5}, {1e5 + 0.2, 4.4}};
    std::vector<Vector3d> vertices;
    for (const double y : {-0.35, 0.35})
        for (const Vector2d& p : outline) vertices.emplace_back(p.x(), y, p.y());
    std::vector<std::vector<int>> faces{{0, 1, 2, 3}, {7, 6, 5, 4}};
    for (int i = 0; i < 4; ++i) faces.push_back({(i + 1) % 4, i, 4 + i, 4 + (i + 1) % 4});
    const ConvexPolyhedron prism = make_convex_polyhedron(vertices, faces);
    double depth = 0;
    const ConvexPolygon found = outline_of(prism, depth);
    EXPECT_NEAR(depth, 0.7, 1e-15);
    const Moments plane = moments_of(std::vector<ConvexPolygon>{found}, depth), space = moments_of(prism);
    EXPECT_NEAR(plane.volume, space.volume, 1e-12);
    EXPECT_LT((plane.centroid - space.centroid).norm(), 1e-10);
    EXPECT_LT((from_space<2>(plane.second) - from_space<2>(space.second)).norm(), 1e-10);
    EXPECT_THROW(outline_of(make_convex_polyhedron({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}),
                            depth),
                 InputError);
}

TEST(SegmentContact, OfALevelBoxIsItsEdge)
{
    const auto contact = contact_of({0.3, 0.25 - 1e-4}, 0);
    ASSERT_TRUE(contact);
    EXPECT_FALSE(contact->second_is_reference);
    EXPECT_LT((contact->normal - Vector2d(0, 1)).norm(), 1e-15);
    ASSERT_EQ(contact->points.size(), 2U);
    for (const auto& end : contact->points) {
        EXPECT_NEAR(end.gap, -1e-4, 1e-12);
        EXPECT_NEAR(end.area, 0.5, 1e-12);
    }
}

TEST(SegmentContact, IsClippedWhereTheBoxJutsOut)
{
    const auto contact = contact_of({1.8, 0.25}, 0);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->points[0].area + contact->points[1].area, 0.7, 1e-12);
    EXPECT_NEAR(std::max(contact->points[0].position.x(), contact->points[1].position.x()), 2, 1e-12);
}

TEST(SegmentContact, OfATiltedBoxOpensAlongItsEdge)
{
    const double tilt = 0.02;
    const auto contact = contact_of({0, 0.25 * std::cos(tilt) + 0.5 * std::sin(tilt)}, tilt);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(std::min(contact->points[0].gap, contact->points[1].gap), 0, 1e-12);
    EXPECT_NEAR(std::max(contact->points[0].gap, contact->points[1].gap), std::sin(tilt), 1e-12);
}

TEST(SegmentContact, EndsBeyondTheMarginAndBesideTheEdge)
{
    EXPECT_FALSE(contact_of({0, 0.25 + 0.11}, 0));
    EXPECT_FALSE(contact_of({2.6, 0.25}, 0));
    EXPECT_FALSE(contact_of({2.5 + 1e-9, 0.25 + 1e-9}, 0));  // diagonal neighbours
}

// Two points of half the length are the four corners of the spatial block seen from the side: the same equations.
// Until the first slide has nearly ended; then rounding decides in which step a joint slides so little that it
// counts as sticking.
TEST(Planar, RigidWallMovesLikeTheSpatialOne)
{
    const Wall plane(Kinematics::planar_rigid, PlaneCondition::strain, 0.12);
    const Wall space(Kinematics::spatial_rigid, PlaneCondition::strain, 0.12);
    ASSERT_EQ(plane.report.outcome, Outcome::completed);
    ASSERT_EQ(space.report.outcome, Outcome::completed) << ::testing::PrintToString(space.report.diagnosis);
    const double apart = largest_distance(plane, space), slid = largest_slide(plane);
    std::printf("rigid wall, planar against spatial: %.1e m apart, %.1e m slid\n", apart, slid);
    EXPECT_GT(slid, 1e-4);
    EXPECT_LT(apart, 1e-6 * slid);
    EXPECT_NEAR(plane.report.energy.friction, space.report.energy.friction, 1e-6 * space.report.energy.friction);
    EXPECT_NEAR(plane.report.energy.kinetic, space.report.energy.kinetic, 1e-6 * space.report.energy.kinetic);
}

// A spatial wall one block thick is free to bulge: plane stress, up to its inertia across. Newmark damps what
// bulging sets ringing; undamped, the phase of it decides when which joint begins to slide, of one wall as between
// two.
TEST(Planar, DeformableWallInPlaneStressMovesLikeTheSpatialOne)
{
    const Wall stress(Kinematics::planar_deformable, PlaneCondition::stress, 0.3, Integrator::newmark);
    const Wall space(Kinematics::spatial_deformable, PlaneCondition::strain, 0.3, Integrator::newmark);
    const double apart = largest_distance(stress, space), slid = largest_slide(stress);
    std::printf("deformable wall, plane stress against spatial: %.1e m apart, %.1e m slid\n", apart, slid);
    EXPECT_GT(slid, 1e-4);
    EXPECT_LT(apart, 0.01 * slid);
}

// Pressed between two plates by its weight: e_zz = (1 - nu^2) s/E in plane strain, s/E in plane stress; the stress
// across is nu s in plane strain and 0 in plane stress.
TEST(Planar, PlaneStrainAndPlaneStressOfAPressedBlock)
{
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        Model model = make_model(Kinematics::planar_deformable, {"stone", 2500, 1e9, 0.3}, dry(0));
        model.plane = plane;
        hold(model, add_box(model, "base", {-2, 0, -1}, {2, 1, 0}));
        const int block = add_box(model, "block", {-0.5, 0, 0}, {0.5, 1, 0.4});
        State state = initial_state(model);
        ASSERT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
        const double s = 0.5 * 2500 * gravity * 0.4;  // mean pressure over the height
        const Eigen::Matrix3d stress = stress_of(model, state, block);
        const double strain = 1 - pose_of(model.kinematics, state, block).map(2, 2);
        const bool is_strain = plane == PlaneCondition::strain;
        EXPECT_NEAR(stress(2, 2), -s, 1e-4 * s);
        EXPECT_NEAR(stress(0, 0), 0, 1e-4 * s);
        EXPECT_NEAR(stress(1, 1), is_strain ? -0.3 * s : 0, 1e-4 * s);
        EXPECT_NEAR(strain, (is_strain ? 1 - 0.09 : 1) * s / 1e9, 1e-4 * s / 1e9);
    }
}

// A free turn in the plane is exact: no energy, momentum or shape is lost in 100 turns.
TEST(Planar, SpinIsExact)
{
    for (const Kinematics kinematics : {Kinematics::planar_rigid, Kinematics::planar_deformable}) {
        Model model = make_model(kinematics, {"stone", 2400, 4.5e9, 0.25}, dry(30));
        add_box(model, "block", {-0.5, 0, -0.15}, {0.5, 1, 0.15});
        State state = initial_state(model);
        set_velocity(model, state, 0, {0.1, 0, 0.2}, {0, 2, 0});
        const double momentum = angular_momentum(model, state, 0).y(), energy = kinetic_energy(model, state);
        const double duration = 100 * std::numbers::pi;
        run_quietly(model, {dynamic_stage(duration, 5e-3, Vector3d::Zero())}, state);
        EXPECT_NEAR(angular_momentum(model, state, 0).y(), momentum, 1e-9 * momentum);
        EXPECT_NEAR(kinetic_energy(model, state) + strain_energy(model, state), energy, 1e-6 * energy);
        const double volume = pose_in<2>(kinematics, state, 0).map.determinant() - 1;
        // Plane strain: (1 + nu)(1 - 2 nu)/E rho w^2 (Lx^2 + Lz^2)/12 is the change of area.
        const double strain = 1.25 * 0.5 / 4.5e9 * 2400 * 4 * (1 + 0.09) / 12;
        EXPECT_LT(std::abs(volume), kinematics == Kinematics::planar_rigid ? 1e-12 : 2 * strain);
    }
}

// What a planar scene does not pay: numbers of the state, entries of the factor, bytes of a contact point.
TEST(Planar, CostsLessThanTheSpatialScene)
{
    const Wall plane(Kinematics::planar_rigid, PlaneCondition::strain, 0.01);
    const Wall space(Kinematics::spatial_rigid, PlaneCondition::strain, 0.01);
    std::printf(
        "wall, planar and spatial rigid: %lld and %lld factor entries, %zu and %zu contact points of %zu and "
        "%zu bytes\n",
        static_cast<long long>(plane.report.factor_entries), static_cast<long long>(space.report.factor_entries),
        plane.state.planar_contacts.points.size(), space.state.contacts.points.size(), sizeof(ContactPointIn<2>),
        sizeof(ContactPointIn<3>));
    EXPECT_EQ(4 * plane.report.factor_entries, space.report.factor_entries);
    EXPECT_EQ(2 * plane.state.velocities.size(), space.state.velocities.size());
    EXPECT_EQ(2 * plane.state.planar_contacts.points.size(), space.state.contacts.points.size());
    EXPECT_TRUE(plane.state.contacts.points.empty());
    EXPECT_TRUE(plane.model.blocks[0].parts.empty());
    EXPECT_LT(sizeof(ContactPointIn<2>), sizeof(ContactPointIn<3>));
}

}  // namespace voussoir::testing
