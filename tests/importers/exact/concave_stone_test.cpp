// Concave stones as the engine sees them: one block of glued parts that moves like the solid it is.
#include <gtest/gtest.h>

#include <cmath>

#include "importers/exact/certify.h"
#include "libdda/analysis/joint_resultants.h"
#include "tests/importers/concave_shapes.h"
#include "tests/libdda/scenes.h"

namespace voussoir::importers
{
namespace
{

using namespace testing;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Block block_of(const mesh::PolygonSurface& surface)
{
    const exact::Certificate certificate = exact::certify(surface);
    EXPECT_EQ(certificate.reason, "");
    return make_block(surface.name, 0, 0, certificate.parts, certificate.moments);
}

/// Second moments of a box about a point, m5.
Matrix3d box_second(const Vector3d& lower, const Vector3d& upper, const Vector3d& about)
{
    const Vector3d size = upper - lower, arm = (lower + upper) / 2 - about;
    const double volume = size.prod();
    Matrix3d second = volume * arm * arm.transpose();
    for (int k = 0; k < 3; ++k) second(k, k) += volume * size[k] * size[k] / 12;
    return second;
}

TEST(ConcaveStone, HasTheInertiaOfTheSolid)
{
    const Block l = block_of(l_shape());
    const Vector3d centroid((2 * 1.0 + 1 * 0.5) / 3, (2 * 0.5 + 1 * 1.5) / 3, 0.5);
    EXPECT_LT((l.moments.centroid - centroid).norm(), 1e-10);
    const Matrix3d l_second =
        box_second({0, 0, 0}, {2, 1, 1}, centroid) + box_second({0, 1, 0}, {1, 2, 1}, centroid);
    EXPECT_LT((l.moments.second - l_second).norm(), 1e-10);

    const Block u = block_of(u_shape());
    const Vector3d middle(1.5, (6 * 1.0 - 1.5 * 1.25) / 4.5, 0.5);
    EXPECT_LT((u.moments.centroid - middle).norm(), 1e-10);
    const Matrix3d u_second =
        box_second({0, 0, 0}, {3, 2, 1}, middle) - box_second({1, 0.5, 0}, {2, 2, 1}, middle);
    EXPECT_LT((u.moments.second - u_second).norm(), 1e-10);

    // Ring sector: six triangles of each radius from the centre, less the hole; the depth integrates apart.
    const Block ring = block_of(ring_sector_with_hole());
    double area = 0, first = 0, xx = 0, yy = 0;
    const double step = std::numbers::pi / 18;
    for (const double radius : {3., 2.})
        for (int i = 0; i < 6; ++i) {
            const double sign = radius > 2.5 ? 1 : -1, a = (i - 3) * step, b = a + step;
            const Eigen::Vector2d p(radius * std::cos(a), radius * std::sin(a)),
                q(radius * std::cos(b), radius * std::sin(b));
            const double t = sign * 0.5 * radius * radius * std::sin(step);
            area += t;
            first += t * (p.x() + q.x()) / 3;
            xx += t * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x()) / 6;
            yy += t * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y()) / 6;
        }
    area -= 0.16;
    first -= 0.16 * 2.5;
    xx -= 0.16 * (2.5 * 2.5 + 0.16 / 12);
    yy -= 0.16 * 0.16 / 12;
    const double x = first / area;
    EXPECT_LT((ring.moments.centroid - Vector3d(x, 0, 0.5)).norm(), 1e-10);
    EXPECT_NEAR(ring.moments.second(0, 0), xx - area * x * x, 1e-10);
    EXPECT_NEAR(ring.moments.second(1, 1), yy, 1e-10);
    EXPECT_NEAR(ring.moments.second(2, 2), area / 12, 1e-10);
    EXPECT_NEAR(ring.moments.second(0, 1), 0, 1e-10);
}

class ConcaveStones : public ::testing::TestWithParam<Kinematics>
{
};

TEST_P(ConcaveStones, FallAndTurnLikeTheSolidWithoutContactsInside)
{
    for (const mesh::PolygonSurface& surface : {l_shape(), u_shape(), ring_sector_with_hole()}) {
        SCOPED_TRACE(surface.name);
        Model model = make_model(GetParam(), testing::stone(), testing::dry(30));
        model.blocks.push_back(block_of(surface));
        State state = initial_state(model);
        const Vector3d start = testing::centroid(model, state, 0), spin(0, 0, 2);  // about a principal axis
        testing::set_velocity(model, state, 0, {1, 0, 0}, spin);
        Stage stage = testing::dynamic_stage(0.2, 1e-3);
        stage.control.integrator = Integrator::energy_decaying;
        stage.control.dissipation = 0;
        int contacts = 0;
        RunObserver observer;
        observer.step = [&](const State& now, const StepReport&, const RunReport&) {
            contacts += static_cast<int>(now.contacts.points.size());
        };
        run(model, {stage}, state, observer);
        EXPECT_EQ(contacts, 0);
        const Vector3d expected = start + Vector3d(0.2, 0, -0.5 * testing::gravity * 0.04);
        EXPECT_LT((testing::centroid(model, state, 0) - expected).norm(), 1e-9);
        const Matrix3d map = pose_of(model.kinematics, state, 0).map;
        const double turned = std::atan2(map(1, 0) - map(0, 1), map(0, 0) + map(1, 1));
        EXPECT_NEAR(turned, 0.4, is_deformable(GetParam()) ? 1e-5 : 1e-6);
    }
}

TEST_P(ConcaveStones, RestOnTheirPartsTogether)
{
    Model model = make_model(GetParam(), testing::stone(), testing::dry(30));
    testing::hold(model, testing::add_box(model, "floor", {-5, -5, -1}, {5, 5, 0}));
    mesh::PolygonSurface bridge = u_shape();  // upside down: it stands on its two legs
    for (Vector3d& v : bridge.vertices) v = Vector3d(v.x(), v.z() - 0.5, 2 - v.y());
    model.blocks.push_back(block_of(bridge));
    State state = initial_state(model);
    const Vector3d start = testing::centroid(model, state, 1);
    const RunReport report = testing::run_quietly(model, {testing::static_stage(1e-2)}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    double weight = 0;
    for (const JointResultant& joint : joint_resultants(model, state)) weight += std::abs(joint.normal_force);
    EXPECT_NEAR(weight, model.mass(1) * testing::gravity, 1e-5 * model.mass(1) * testing::gravity);
    EXPECT_LT((testing::centroid(model, state, 1) - start).head<2>().norm(), 1e-9);
    EXPECT_LT(std::abs((testing::centroid(model, state, 1) - start).z()), 1e-4);
}

/// A box pressed against the flat back of a glued stone and pulled along it, over the joint between two parts: it
/// must slide as over one face.
TEST_P(ConcaveStones, DoNotCatchWhatSlidesOverTheirInnerJoints)
{
    std::vector<double> ends;
    for (const bool glued : {true, false}) {
        Model model = make_model(GetParam(), testing::stone(), testing::dry(20));
        if (glued) {
            mesh::PolygonSurface u = u_shape();  // its back, 3 x 1 m, is the floor at z = 0; the notch is below
            for (Vector3d& v : u.vertices) v = Vector3d(v.x(), v.z(), -v.y());
            model.blocks.push_back(block_of(u));
            EXPECT_GT(model.blocks[0].parts.size(), 2U);
        } else {
            testing::add_box(model, "floor", {0, 0, -2}, {3, 1, 0});
        }
        testing::hold(model, 0);
        testing::add_box(model, "slider", {0.1, 0.3, 0}, {0.5, 0.7, 0.2});
        State state = initial_state(model);
        const RunReport report =
            testing::run_quietly(model, {testing::dynamic_stage(1.2, 1e-3, testing::inclined_gravity(35))}, state);
        EXPECT_EQ(report.outcome, Outcome::completed);
        ends.push_back(testing::centroid(model, state, 1).x());
    }
    EXPECT_GT(ends[0], 2.0) << "it slid over two joints";
    EXPECT_NEAR(ends[0], ends[1], 1e-4 * ends[1]);
}

INSTANTIATE_TEST_SUITE_P(Each, ConcaveStones, testing::spatial_kinematics(), testing::test_name);

}  // namespace
}  // namespace voussoir::importers
