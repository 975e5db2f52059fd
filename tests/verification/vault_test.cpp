// A cross vault of 184 stones from a survey whose file carries no unit: does it stand, whatever the unit?
// (VOUSSOIR_DATA; Block Research Group's model, not ours to ship.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "app/geometry/geometry.h"
#include "libdda/analysis/energies.h"
#include "libdda/analysis/run.h"

namespace voussoir
{
namespace
{

using Eigen::Vector3d;

struct VaultRun {
    bool stands = false;
    double largest_move = 0;  // shares of the span
};

/// Self-weight by static steps, then a while of free motion. Friction is a coefficient.
VaultRun run_vault(const ImportedMesh& mesh, double friction)
{
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = std::atan(friction);
    Model model = make_model(Kinematics::spatial_rigid, {"stone", 2000, 10e9, 0.2}, joint);
    double span = 0;
    for (const Stone& stone : mesh.stones) {
        model.blocks.push_back(make_block(stone.name, 0, 0, stone.parts, stone.moments));
        double lowest = 1e300;
        for (const ConvexPolyhedron& part : stone.parts)
            for (const Vector3d& x : part.vertices) {
                lowest = std::min(lowest, x.z());
                span = std::max(span, 2 * std::abs(x.x()));
            }
        if (lowest > 1e-3 * std::cbrt(stone.moments.volume)) continue;
        Foundation springer;
        springer.block = static_cast<int>(model.blocks.size()) - 1;
        model.foundations.push_back(springer);
    }
    EXPECT_EQ(model.foundations.size(), 4U) << "the springers at the four corners";
    // Steps as long against the time of a fall over the span at every size.
    const double unit_of_time = std::sqrt(span / 9.81);
    Stage rest;
    rest.name = "self-weight";
    rest.type = StageType::static_equilibrium;
    rest.control.time_step = 0.08 * unit_of_time;
    rest.max_static_steps = 100;
    Stage wait;
    wait.name = "wait";
    wait.duration = 1.0 * unit_of_time;
    wait.control.time_step = 4e-3 * unit_of_time;
    State state = initial_state(model);
    const State start = state;
    const RunReport report = run(model, {rest, wait}, state, {});
    VaultRun result;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        result.largest_move = std::max(
            result.largest_move,
            (pose_of(model.kinematics, state, b).centroid - pose_of(model.kinematics, start, b).centroid).norm() /
                span);
    const double weight_times_span = 2000 * 9.81 * 3.5e6 * std::pow(span / 350, 3) * span;
    const bool at_rest = kinetic_energy(model, state) < 1e-7 * weight_times_span;
    result.stands = report.outcome == Outcome::completed && at_rest && result.largest_move < 2e-3;
    return result;
}

TEST(CrossVault, StandsAtAnySizeWithFrictionAndFallsAtAnySizeWithout)
{
    setenv("VOUSSOIR_BIN_DIR", VOUSSOIR_BINARIES, 1);
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    const std::filesystem::path file = data / "meshes/masonry/crossvault.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    for (const double unit : {0.01, 0.1}) {
        SCOPED_TRACE(unit);
        const Geometry geometry = import_geometry({{.file = file, .metres_per_unit = unit}}, {});
        ASSERT_TRUE(geometry.meshes[0].accepted) << geometry.meshes[0].reason;
        ASSERT_EQ(geometry.meshes[0].stones.size(), 184U);
        for (const Overlap& overlap : geometry.overlaps) EXPECT_LT(overlap.share, 0.01) << overlap.stone_a;
        const VaultRun rough = run_vault(geometry.meshes[0], 0.6), smooth = run_vault(geometry.meshes[0], 0.05);
        EXPECT_TRUE(rough.stands) << "moved by " << rough.largest_move << " of the span";
        EXPECT_FALSE(smooth.stands) << "moved by " << smooth.largest_move << " of the span";
    }
}

}  // namespace
}  // namespace voussoir
