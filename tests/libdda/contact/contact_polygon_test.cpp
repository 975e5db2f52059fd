// What touches what: clipped polygons, tributary areas, crossing edges.
#include "libdda/contact/narrow_phase.h"

#include <gtest/gtest.h>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Two boxes centred on their centroids, put where asked.
struct Pair {
    Model model = make_model(Kinematics::spatial_deformable, stone(), dry(30));
    State state;

    Pair(const Vector3d& size_a, const Vector3d& size_b)
    {
        add_box(model, "a", -0.5 * size_a, 0.5 * size_a);
        add_box(model, "b", -0.5 * size_b, 0.5 * size_b);
        state = initial_state(model);
    }
    void put(int block, const Vector3d& centre, const Matrix3d& rotation = Matrix3d::Identity())
    {
        set_pose(model, state, block, centre, rotation);
    }
    std::optional<contact::ContactPolygon> contact(double margin = 1e-2) const
    {
        const std::vector<contact::PlacedPart> parts = placed(model, state);
        return contact::contact_polygon(parts[0], parts[1], margin, {});
    }
};

double area_of(const contact::ContactPolygon& polygon)
{
    double area = 0;
    for (const contact::PolygonPoint& p : polygon.points) area += p.area;
    return area;
}

Vector3d centre_of(const contact::ContactPolygon& polygon)
{
    Vector3d sum = Vector3d::Zero();
    for (const contact::PolygonPoint& p : polygon.points) sum += p.area * p.position;
    return sum / area_of(polygon);
}

}  // namespace

// Area and centroid of a polygon in the plane by the shoelace formula, in its own two coordinates.
TEST(TributaryAreas, KeepAreaAndFirstMomentOfRandomConvexPolygons)
{
    Random random(7);
    for (int trial = 0; trial < 200; ++trial) {
        const int n = 3 + trial % 6;
        std::vector<double> angles(n);
        for (double& angle : angles) angle = random.between(0, 2 * std::numbers::pi);
        std::sort(angles.begin(), angles.end());
        const double a = random.between(0.1, 3), b = random.between(0.1, 3);
        std::vector<Eigen::Vector2d> flat;
        for (const double angle : angles) flat.emplace_back(a * std::cos(angle), b * std::sin(angle));
        double area = 0;
        Eigen::Vector2d moment(0, 0);
        for (int i = 0; i < n; ++i) {
            const Eigen::Vector2d &p = flat[i], &q = flat[(i + 1) % n];
            const double cross = p.x() * q.y() - p.y() * q.x();
            area += cross / 2;
            moment += cross / 6 * (p + q);
        }
        const Matrix3d frame = random.rotation();
        const Vector3d origin = random.vector(10);
        std::vector<contact::PolygonPoint> points(n);
        for (int i = 0; i < n; ++i) points[i].position = origin + frame.leftCols<2>() * flat[i];
        const double sign = trial % 2 ? 1 : -1;  // seen from either side
        contact::assign_tributary_areas(points, sign * frame.col(2));

        double sum = 0;
        Vector3d first = Vector3d::Zero();
        for (const contact::PolygonPoint& p : points) {
            EXPECT_GE(p.area, 0);
            sum += p.area;
            first += p.area * (p.position - origin);
        }
        EXPECT_NEAR(sum, area, 1e-13 * a * b);
        EXPECT_LT((first - frame.leftCols<2>() * moment).norm(), 1e-12 * a * b * (a + b));
    }
}

// A regular polygon shares its area equally.
// What clipping within a tolerance leaves of two faces that meet along an edge: as wide as the tolerance, and it
// may cross itself. Its area centroid lay anywhere, and it counted as a whole face.
TEST(TributaryAreas, OfASliverThatCrossesItselfAreThoseOfASliver)
{
    const double width = 1e-4;
    for (const double tilt : {0.9, 0.99, 0.999, 1.0, 1.001, 1.01}) {
        std::vector<contact::PolygonPoint> points(5);
        points[0].position = {0, 0, 0};
        points[1].position = {1, 0, 0};
        points[2].position = {1, width, 0};
        points[3].position = {1 - 1e-4, -tilt * width, 0};
        points[4].position = {0, -width, 0};
        contact::assign_tributary_areas(points, Vector3d::UnitZ());
        double area = 0;
        for (const contact::PolygonPoint& point : points) area += point.area;
        EXPECT_LT(area, 2 * width) << tilt;
    }
}

TEST(TributaryAreas, OfASquareAreQuarters)
{
    std::vector<contact::PolygonPoint> points(4);
    const Vector3d corners[4] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (int i = 0; i < 4; ++i) points[i].position = corners[i];
    contact::assign_tributary_areas(points, Vector3d::UnitZ());
    for (const contact::PolygonPoint& p : points) EXPECT_NEAR(p.area, 1, 1e-15);
}

TEST(FaceContact, ShiftedBoxTouchesWhereTheFacesOverlap)
{
    Pair pair({2, 2, 1}, {1, 1, 1});
    for (const double shift : {0.0, 0.4, 0.9, 1.4}) {
        pair.put(1, {shift, 0.2, 1 - 1e-4});
        const auto contact = pair.contact();
        ASSERT_TRUE(contact);
        const double width = std::min(1.0, 1 - (shift - 0.5));
        EXPECT_NEAR(area_of(*contact), width, 1e-12);
        EXPECT_LT((centre_of(*contact) - Vector3d(shift - 0.5 + width / 2, 0.2, 0.5 - 1e-4)).norm(), 1e-12);
        EXPECT_FALSE(contact->second_is_reference);
        EXPECT_LT((contact->normal - Vector3d::UnitZ()).norm(), 1e-14);
        for (const contact::PolygonPoint& p : contact->points) EXPECT_NEAR(p.gap, -1e-4, 1e-13);
    }
}

// Two unit squares turned by 45 degrees share a regular octagon of area 2 (sqrt 2 - 1).
TEST(FaceContact, TurnedBoxTouchesInAnOctagon)
{
    Pair pair({1, 1, 1}, {1, 1, 1});
    pair.put(1, {0, 0, 1}, turned(45 * degrees, Vector3d::UnitZ()));
    const auto contact = pair.contact();
    ASSERT_TRUE(contact);
    ASSERT_EQ(contact->points.size(), 8U);
    for (const contact::PolygonPoint& p : contact->points)
        EXPECT_NEAR(p.area, 2 * (std::numbers::sqrt2 - 1) / 8, 1e-12);
}

TEST(FaceContact, TiltedBoxHasAGapThatFollowsItsFace)
{
    Pair pair({4, 4, 1}, {1, 1, 1});
    const double tilt = 0.01;
    const Matrix3d turn = turned(tilt, Vector3d::UnitY());
    pair.put(1, {0, 0, 1 + 1e-3}, turn);
    const auto contact = pair.contact(0.1);
    ASSERT_TRUE(contact);
    ASSERT_EQ(contact->points.size(), 4U);
    for (const contact::PolygonPoint& p : contact->points) {
        const double x = p.position.x() > 0 ? 0.5 : -0.5;
        EXPECT_NEAR(p.gap, 0.5 + 1e-3 - 0.5 * std::cos(tilt) - x * std::sin(tilt), 1e-13);
    }
}

TEST(FaceContact, BoxOnItsVertexTouchesWithThatVertex)
{
    Pair pair({4, 4, 1}, {1, 1, 1});
    const Vector3d diagonal = Vector3d(1, 1, 1).normalized();
    const Matrix3d down = Eigen::Quaterniond::FromTwoVectors(diagonal, -Vector3d::UnitZ()).toRotationMatrix() *
                          turned(0.1, diagonal);
    pair.put(1, {0.3, 0.1, 0.5 + std::sqrt(3) / 2 - 1e-3}, down);
    const auto contact = pair.contact();
    ASSERT_TRUE(contact);
    EXPECT_FALSE(contact->edge_edge);
    EXPECT_LT((contact->normal - Vector3d::UnitZ()).norm(), 1e-12);
    const auto lowest = std::min_element(contact->points.begin(), contact->points.end(),
                                         [](const auto& p, const auto& q) { return p.gap < q.gap; });
    EXPECT_NEAR(lowest->gap, -1e-3, 1e-12);
    EXPECT_LT((lowest->position - Vector3d(0.3, 0.1, 0.5 - 1e-3)).norm(), 1e-12);
    for (const contact::PolygonPoint& p : contact->points) EXPECT_TRUE(&p == &*lowest || p.gap > 0.3);
}

TEST(EdgeContact, CrossingEdgesTouchInOnePoint)
{
    Pair pair({4, 1, 1}, {1, 4, 1});  // bars along x and y, each on edge
    const double depth = 2e-3, height = std::numbers::sqrt2 - depth;
    pair.put(0, {0, 0, 0}, turned(45 * degrees, Vector3d::UnitX()));
    pair.put(1, {0.7, 0.2, height}, turned(45 * degrees, Vector3d::UnitY()));
    const auto contact = pair.contact();
    ASSERT_TRUE(contact);
    EXPECT_TRUE(contact->edge_edge);
    ASSERT_EQ(contact->points.size(), 1U);
    const double up = contact->second_is_reference ? -1 : 1;  // from the reference body to the incident one
    EXPECT_LT((contact->normal - Vector3d(0, 0, up)).norm(), 1e-12);
    EXPECT_NEAR(contact->points[0].gap, -depth, 1e-12);
    EXPECT_NEAR(contact->points[0].position.x(), 0.7, 1e-12);
    EXPECT_NEAR(contact->points[0].position.y(), 0, 1e-12);
    EXPECT_GT(contact->points[0].area, 0);
    pair.put(1, {0.7, 0.2, height + depth + 0.02}, turned(45 * degrees, Vector3d::UnitY()));
    EXPECT_FALSE(pair.contact());
}

TEST(FaceContact, EndsWhereTheBoxSlidesOff)
{
    Pair pair({2, 2, 1}, {1, 1, 1});
    double last = 1;
    for (const double overhang : {0.5, 0.9, 0.99, 0.9999}) {
        pair.put(1, {0.5 + overhang, 0, 1});
        const auto contact = pair.contact();
        ASSERT_TRUE(contact) << overhang;
        EXPECT_NEAR(area_of(*contact), 1 - overhang, 1e-5);
        EXPECT_LT(area_of(*contact), last);
        last = area_of(*contact);
    }
    pair.put(1, {1.52, 0, 1});
    EXPECT_FALSE(pair.contact());
}

TEST(FaceContact, DiagonalNeighboursDoNotTouch)
{
    Pair pair({1, 1, 1}, {1, 1, 1});
    for (const double gap : {0.0, 1e-9, -1e-9, 1e-7}) {
        pair.put(1, {1 + gap, 0, 1 + gap});
        EXPECT_FALSE(pair.contact()) << gap;
        pair.put(1, {1 + gap, 1 + gap, 1 + gap});
        EXPECT_FALSE(pair.contact()) << gap;
    }
}

// A box pressed 10 um into a floor slides onto the next, flush block. What the next block's side could push with
// (depth x area) stays nothing beside what its top carries.
TEST(FaceContact, TheSideOfAFlushFloorIsNotTouched)
{
    Pair pair({4, 4, 2}, {1, 1, 0.3});
    const double depth = 1e-5;
    double worst = 0;
    int on_top = 0;
    for (double overlap = -1e-3; overlap < 0.5; overlap = overlap < 2e-3 ? overlap + 1.7e-6 : overlap * 1.1) {
        pair.put(1, {-2 - 0.5 + overlap, 0, 1 + 0.15 - depth});
        const auto contact = pair.contact();
        if (!contact) continue;
        double push = 0;
        for (const contact::PolygonPoint& p : contact->points) push += p.area * std::max(-p.gap, 0.0);
        if (std::abs(contact->normal.z()) > 0.99)
            ++on_top;
        else
            worst = std::max(worst, push);
    }
    EXPECT_GT(on_top, 100);
    EXPECT_LT(worst, 1e-4 * depth * 1);
}

// Where the scene stands in space is no property of a contact.
/// A box whose bottom is bent along x = 0 by `bend` [rad] on either side: two faces that look down.
ConvexPolyhedron box_with_bent_bottom(double bend)
{
    const double drop = 0.5 * std::tan(bend);
    const std::vector<Vector3d> vertices{{-0.5, -0.5, -0.5 + drop},
                                         {0, -0.5, -0.5},
                                         {0.5, -0.5, -0.5 + drop},
                                         {-0.5, 0.5, -0.5 + drop},
                                         {0, 0.5, -0.5},
                                         {0.5, 0.5, -0.5 + drop},
                                         {-0.5, -0.5, 0.5},
                                         {0.5, -0.5, 0.5},
                                         {-0.5, 0.5, 0.5},
                                         {0.5, 0.5, 0.5}};
    return make_convex_polyhedron(
        vertices,
        {{0, 3, 4, 1}, {1, 4, 5, 2}, {6, 7, 9, 8}, {0, 1, 2, 7, 6}, {3, 8, 9, 5, 4}, {0, 6, 8, 3}, {2, 5, 9, 7}});
}

std::uint32_t incident_face(double bend, double tilt, std::optional<std::uint32_t> last)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    add_box(model, "floor", {-2, -2, -1}, {2, 2, 0});
    model.blocks.push_back(make_block("bent", 0, 0, {box_with_bent_bottom(bend)}));
    State state = initial_state(model);
    set_pose(model, state, 1, {0, 0, 0.5}, Eigen::AngleAxisd(tilt, Vector3d::UnitY()).toRotationMatrix());
    const std::vector<contact::PlacedPart> parts = placed(model, state);
    std::optional<contact::LastContact> history;
    if (last) history = contact::LastContact{false, false, 5, *last};  // reference: the floor's top
    const std::optional<contact::ContactPolygon> found =
        contact::contact_polygon(parts[0], parts[1], 1e-2, history);
    EXPECT_TRUE(found && !found->second_is_reference);
    return found ? found->incident_feature : 99;
}

TEST(FaceContact, KeepsItsIncidentFaceWhileAnotherIsHardlyMoreOpposed)
{
    // Bent by 0.1 degrees and tilted to and fro by 0.02: without memory the faces take turns.
    const double bend = 0.1 * degrees, tilt = 0.02 * degrees;
    const std::uint32_t one = incident_face(bend, tilt, {}), other = incident_face(bend, -tilt, {});
    EXPECT_NE(one, other);
    for (const std::uint32_t face : {one, other}) {
        EXPECT_EQ(incident_face(bend, tilt, face), face);
        EXPECT_EQ(incident_face(bend, -tilt, face), face);
    }
    // Where a face has clearly turned away it is given up.
    EXPECT_EQ(incident_face(bend, 2 * degrees, other), one);
}

/// A springer with a ledge behind its joint, 10 degrees lower than the joint's plane goes on, and a voussoir whose
/// lower face [1 m x 1 m] touches that joint with its outer edge.
struct AtALedge {
    static constexpr double slope = 10 * degrees;
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    State state;

    AtALedge()
    {
        // The joint runs from x = -1 to the edge at 0, the ledge on to x = 1.
        const double rise = std::tan(slope);
        std::vector<Vector3d> vertices;
        for (const double y : {-0.5, 0.5})
            for (const auto& [x, z] :
                 std::vector<std::pair<double, double>>{{-1, -2}, {1, -2}, {1, -rise}, {0, 0}, {-1, 0}})
                vertices.emplace_back(x, y, z);
        model.blocks.push_back(make_block("springer", 0, 0,
                                          {make_convex_polyhedron(vertices, {{0, 1, 2, 3, 4},
                                                                             {5, 9, 8, 7, 6},
                                                                             {0, 5, 6, 1},
                                                                             {1, 6, 7, 2},
                                                                             {2, 7, 8, 3},
                                                                             {3, 8, 9, 4},
                                                                             {4, 9, 5, 0}})}));
        add_box(model, "voussoir", {-1, -0.5, 0}, {0, 0.5, 1});
        state = initial_state(model);
    }
    /// The voussoir turned about its outer edge, which stands `past` behind the springer's and `depth` too low.
    contact::ContactPolygon turned(double angle, double past, double depth)
    {
        const Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
        set_pose(model, state, 1, Vector3d(past, 0, -depth) + turn * Vector3d(-0.5, 0, 0.5), turn);
        const std::vector<contact::PlacedPart> parts = placed(model, state);
        const auto found = contact::contact_polygon(parts[0], parts[1], 1e-2, {});
        EXPECT_TRUE(found);
        return found.value_or(contact::ContactPolygon());
    }
};

double stiffness_below(const contact::ContactPolygon& polygon)
{
    double pressed = 0, deepest = 0;
    for (const contact::PolygonPoint& p : polygon.points) {
        pressed += p.area * std::max(-p.gap, 0.0);
        deepest = std::max(deepest, -p.gap);
    }
    return pressed / deepest;
}

// Beyond half the angle between joint and ledge the ledge is more opposed to the voussoir's face, but nothing of
// it lies under that: springs on next to nothing let the voussoir sink by centimetres.
TEST(FaceContact, OfAVoussoirThatTurnsOverALedgeStaysOnItsJoint)
{
    AtALedge scene;
    const double depth = 1e-4, whole = stiffness_below(scene.turned(2 * degrees, 1e-4, depth));
    EXPECT_GT(whole, 0.3);
    for (const double angle : {4.0, 5.0, 6.0, 8.0, 12.0, 20.0, 30.0})
        for (const double past : {0.0, 1e-5, 5e-5})
            EXPECT_GT(stiffness_below(scene.turned(angle * degrees, past, depth)), 0.5 * whole)
                << angle << " deg, " << past << " m";
}

TEST(FaceContact, GluedFacesAreNeverTouched)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    ConvexPolyhedron part = make_box({-0.5, -0.5, -1}, {0.5, 0.5, 0});
    part.glued.assign(part.faces.size(), false);
    for (int f = 0; f < static_cast<int>(part.faces.size()); ++f)
        part.glued[f] = std::abs(face_normal(part, f).x()) > 0.5;  // its sides belong to other parts of the stone
    model.blocks.push_back(make_block("part", 0, 0, {part}));
    // A box that stands on the next part and reaches over this one by less than it has sunk: were the glued side
    // touched, it would be pushed sideways. A little further on the top carries it.
    const auto contact = [&](double reach, double depth) {
        model.blocks.resize(1);
        add_box(model, "box", {0.5 - reach, -0.2, -depth}, {1, 0.2, 1});
        const State state = initial_state(model);
        const std::vector<contact::PlacedPart> parts = placed(model, state);
        return contact::contact_polygon(parts[0], parts[1], 1e-3, {});
    };
    EXPECT_FALSE(contact(1e-5, 1e-4));
    const std::optional<contact::ContactPolygon> top = contact(1e-3, 1e-4);
    ASSERT_TRUE(top);
    EXPECT_GT(std::abs(top->normal.z()), 0.99);
    ConvexPolyhedron core = part;  // all faces glued: the inside of a stone
    core.glued.assign(core.faces.size(), true);
    model.blocks[0] = make_block("core", 0, 0, {core});
    model.blocks[1].parts[0].glued.assign(model.blocks[1].parts[0].faces.size(), true);
    const State state = initial_state(model);
    const std::vector<contact::PlacedPart> parts = placed(model, state);
    EXPECT_FALSE(contact::contact_polygon(parts[0], parts[1], 1e-3, {}));
}

TEST(FaceContact, IsTheSameInEveryFrame)
{
    Random random(3);
    int touching = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Pair pair({1, 0.8, 0.6}, {0.7, 0.9, 0.5});
        const Vector3d centre = random.vector(0.9);
        const Matrix3d turn = random.rotation(), frame = random.rotation();
        const Vector3d offset = random.vector(5);
        pair.put(1, centre, turn);
        const auto here = pair.contact(0.05);
        pair.put(0, offset, frame);
        pair.put(1, frame * centre + offset, frame * turn);
        const auto there = pair.contact(0.05);
        ASSERT_EQ(here.has_value(), there.has_value());
        if (!here) continue;
        ++touching;
        EXPECT_EQ(here->edge_edge, there->edge_edge);
        EXPECT_EQ(here->reference_feature, there->reference_feature);
        EXPECT_LT((frame * here->normal - there->normal).norm(), 1e-12);
        ASSERT_EQ(here->points.size(), there->points.size());
        for (std::size_t i = 0; i < here->points.size(); ++i) {
            const contact::PolygonPoint &p = here->points[i], &q = there->points[i];
            EXPECT_LT((frame * p.position + offset - q.position).norm(), 1e-12);
            EXPECT_NEAR(p.gap, q.gap, 1e-12);
            EXPECT_NEAR(p.area, q.area, 1e-12);
            EXPECT_EQ(p.feature, q.feature);
        }
    }
    EXPECT_GT(touching, 100);
}

}  // namespace voussoir::testing
