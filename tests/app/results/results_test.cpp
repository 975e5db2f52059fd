// What goes into results.h5 comes out, and what a scene does not have is not in it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/results/energy_terms.h"
#include "app/results/results_reader.h"
#include "app/results/results_writer.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{
namespace
{

std::filesystem::path write_run(const Case& the_case, const std::filesystem::path& folder, int frames = 3)
{
    ResultsWriter writer(the_case, folder);
    RunReport report;
    State state;
    for (int i = 0; i < frames; ++i) {
        state = synthetic::swaying(the_case, 0.5 * i);
        report.steps = state.step;
        report.energy.friction = 10.0 * i;
        report.energy.gravity_work = 25.0 * i;
        writer.history(state, {}, report);
        writer.frame(state, report);
    }
    writer.finish(state, report, {2.5, 4.5});
    return writer.results_file();
}

std::string bytes_of(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

/// Vertices of the first part or outline, in space.
std::vector<Eigen::Vector3d> levers_of(const Block& block)
{
    if (block.outlines.empty()) return block.parts[0].vertices;
    std::vector<Eigen::Vector3d> levers;
    for (const Eigen::Vector2d& lever : block.outlines[0].vertices) levers.push_back(to_space(lever));
    return levers;
}

class AllKinematics : public testing::TestWithParam<Kinematics>
{
};

TEST_P(AllKinematics, FramesComeBackBitForBit)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(GetParam());
    const ResultsReader reader(write_run(the_case, folder.path()));
    ASSERT_EQ(reader.times, (std::vector<double>{0, 0.5, 1}));
    for (std::size_t i = 0; i < 3; ++i) {
        const State state = synthetic::swaying(the_case, reader.times[i]);
        const RecordedFrame frame = reader.frame(i);
        EXPECT_EQ(frame.state.coordinates, state.coordinates);
        EXPECT_EQ(frame.state.velocities, state.velocities);
        EXPECT_EQ(frame.step, state.step);
        EXPECT_EQ(frame.stage, state.stage);
        EXPECT_NEAR(frame.ground.x(), 0.05 * reader.times[i], 1e-15);
    }
}

// What has settled before the motion is no displacement of it, and what the ground does neither.
TEST_P(AllKinematics, DisplacementsCountSinceTheMotionBeganAndFromTheFoot)
{
    const TemporaryFolder folder;
    Case the_case = synthetic::arch(GetParam());
    the_case.stages.resize(2);
    the_case.stages[0].type = StageType::static_equilibrium;
    the_case.stages[1].type = StageType::dynamic;
    const auto at = [&](double time, int stage) {
        State state = synthetic::swaying(the_case, time);
        state.stage = stage;
        state.time = stage == 0 ? 0 : time - 1;
        return state;
    };
    const std::vector<State> states = {at(0, 0), at(1, 0), at(1.5, 1), at(3, 1)};
    {
        ResultsWriter writer(the_case, folder.path());
        for (const State& state : states) writer.frame(state, {});
        writer.finish(states.back(), {}, {2.5, 4.5});
    }
    const ResultsReader reader(folder.path() / "results.h5");
    const auto settled = [&](int block, const State& now, const State& from) {
        const auto place = [&](const State& state) { return pose_of(GetParam(), state, block).centroid; };
        const Eigen::Vector3d ground(0.05, 0, 0);  // m/s
        return Eigen::Vector3d(place(now) - place(from) - (now.step - from.step) * 2e-3 * ground);
    };
    const auto faces =
        Hdf5File::open(folder.path() / "results.h5").read_rows<float>("/frames/face_displacement", 0, 4);
    const std::size_t count = reader.model.mesh.face_block.size();
    for (std::size_t i = 0; i < 4; ++i) {
        const RecordedFrame frame = reader.frame(i);
        EXPECT_EQ(frame.in_motion, i > 1);
        for (int block = 0; block < static_cast<int>(reader.model.block_names.size()); ++block) {
            const Eigen::Vector3d wanted = settled(block, states[i], states[i < 2 ? 0 : 1]);
            EXPECT_LT((moved(reader.model, frame, block) - wanted).norm(), 1e-12) << i << " " << block;
        }
        for (std::size_t face = 0; face < count; ++face)
            EXPECT_NEAR(faces[i * count + face],
                        moved(reader.model, frame, reader.model.mesh.face_block[face]).norm(), 1e-7);
    }
    EXPECT_EQ(counted_from(reader.model), "since the motion began, relative to the supports");
}

TEST_P(AllKinematics, ContactsComeBackBitForBit)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(GetParam());
    const ResultsReader reader(write_run(the_case, folder.path()));
    const auto expected = joint_resultants(the_case.model, synthetic::swaying(the_case, 1));
    const auto found = reader.frame(2).contacts;
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_EQ(found.size(), 16U);
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].block_a, expected[i].block_a);
        EXPECT_EQ(found[i].block_b, expected[i].block_b);
        EXPECT_EQ(found[i].force, expected[i].force);
        EXPECT_EQ(found[i].moment, expected[i].moment);
        EXPECT_EQ(found[i].centre, expected[i].centre);
        EXPECT_EQ(found[i].normal_force, expected[i].normal_force);
        EXPECT_EQ(found[i].closed_area, expected[i].closed_area);
    }
}

TEST_P(AllKinematics, JointsComeBackInEveryFrame)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(GetParam());
    const ResultsReader reader(write_run(the_case, folder.path()));
    const std::vector<WatchedJoint> joints = joints_at_start(the_case.model, initial_state(the_case.model));
    ASSERT_EQ(joints.size(), 16U);
    ASSERT_EQ(reader.model.joints.size(), 16U);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        EXPECT_EQ(reader.model.joints[i].block_a, joints[i].block_a);
        EXPECT_EQ(reader.model.joints[i].block_b, joints[i].block_b);
        EXPECT_EQ(reader.model.joints[i].area, joints[i].area);
        EXPECT_EQ(reader.model.joints[i].facing_area, joints[i].facing_area);
        EXPECT_EQ(reader.model.joints[i].centre, joints[i].centre);
        EXPECT_EQ(reader.model.joints[i].normal, joints[i].normal);
    }
    for (std::size_t frame = 0; frame < 3; ++frame) {
        const State state = synthetic::swaying(the_case, reader.times[frame]);
        const auto expected = joints_now(the_case.model, joints, state, joint_resultants(the_case.model, state));
        const auto found = reader.frame(frame).joints;
        ASSERT_EQ(found.size(), 16U);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto single = [](double value) { return static_cast<double>(static_cast<float>(value)); };
            constexpr double rounding = 1e-9;  // m, of single precision
            EXPECT_NEAR(found[i].motion.opening, expected[i].motion.opening, rounding);
            EXPECT_NEAR(found[i].motion.mean_opening, expected[i].motion.mean_opening, rounding);
            EXPECT_NEAR(found[i].motion.slip, expected[i].motion.slip, rounding);
            EXPECT_NEAR(found[i].motion.largest_slip, expected[i].motion.largest_slip, rounding);
            EXPECT_EQ(found[i].normal_force, single(expected[i].normal_force));
            EXPECT_EQ(found[i].shear_force, single(expected[i].shear_force));
            EXPECT_EQ(found[i].eccentricity, single(expected[i].eccentricity));
            EXPECT_EQ(found[i].area_in_use, single(expected[i].area_in_use));
        }
    }
}

TEST_P(AllKinematics, BondsThatAreLostAreToldOnlyWhereThereAreAny)
{
    const TemporaryFolder dry_folder, folder;
    const Hdf5File dry = Hdf5File::open(write_run(synthetic::arch(GetParam()), dry_folder.path()));
    EXPECT_FALSE(dry.has("/joints/bonded"));
    EXPECT_FALSE(dry.has("/frames/joints/broken"));
    Case mortared = synthetic::arch(GetParam());
    mortared.model.joints[0].tensile_strength = 1e5;
    const ResultsReader reader(write_run(mortared, folder.path()));
    for (const WatchedJoint& joint : reader.model.joints) EXPECT_TRUE(joint.bonded);
    for (const JointNow& joint : reader.frame(0).joints) EXPECT_FALSE(joint.broken);
    for (const JointNow& joint : reader.frame(2).joints)
        EXPECT_TRUE(joint.broken) << "the made-up contacts are dry";
}

TEST_P(AllKinematics, TheMeshIsThatOfTheModel)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(GetParam());
    const ResultsReader reader(write_run(the_case, folder.path()));
    const SurfaceMesh mesh = surface_mesh_of(the_case.model);
    EXPECT_EQ(reader.model.mesh.levers, mesh.levers);
    EXPECT_EQ(reader.model.mesh.face_vertices, mesh.face_vertices);
    EXPECT_EQ(reader.model.mesh.vertex_block, mesh.vertex_block);
    EXPECT_EQ(reader.model.block_names.at(1), "voussoir_1");
    EXPECT_EQ(reader.model.foundations, (std::vector<std::int32_t>{0, 16}));
    // every edge of a closed surface is run once in each direction: 24 corners of faces a box; an outline has 4
    EXPECT_EQ(mesh.face_vertices.size(), is_planar(GetParam()) ? 17U * 4U : 17U * 24U);
}

TEST_P(AllKinematics, PositionsAreThoseOfTheVertices)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(GetParam());
    const Hdf5File file = Hdf5File::open(write_run(the_case, folder.path()));
    const State state = synthetic::swaying(the_case, 1);
    const std::vector<float> positions = file.read_rows<float>("/frames/positions", 2, 1);
    std::size_t row = 0;
    for (std::size_t b = 0; b < the_case.model.blocks.size(); ++b) {
        const Pose pose = pose_of(the_case.model.kinematics, state, static_cast<int>(b));
        for (const Eigen::Vector3d& lever : levers_of(the_case.model.blocks[b])) {
            const Eigen::Vector3d place = pose.centroid + pose.map * lever;
            for (const int axis : axes_of(GetParam())) EXPECT_NEAR(positions[row++], place[axis], 1e-6);
        }
    }
    EXPECT_EQ(row, positions.size());
}

TEST_P(AllKinematics, TwoRunsGiveTheSameBytes)
{
    const TemporaryFolder first, second;
    const Case the_case = synthetic::arch(GetParam());
    const std::string bytes = bytes_of(write_run(the_case, first.path()));
    EXPECT_TRUE(bytes == bytes_of(write_run(the_case, second.path())));
    EXPECT_GT(bytes.size(), 10000U);
}

// How many frames wait for one store depends on the clock. Enough of them that chunks begin among those that wait.
TEST_P(AllKinematics, BytesDoNotDependOnWhenFramesAreStored)
{
    const Case the_case = synthetic::arch(GetParam());
    const auto written = [&](int every) {
        const TemporaryFolder folder;
        ResultsWriter writer(the_case, folder.path());
        State state;
        for (int i = 0; i < 120; ++i) {
            state = synthetic::swaying(the_case, 0.01 * i);
            for (int line = 0; line < 20; ++line) writer.history(state, {}, {});
            writer.add_frame(state, {});
            if (i == 0 || (every > 0 && i % every == 0)) writer.save(state, {}, {});  // the summary lists its file
        }
        writer.finish(state, {}, {});
        return bytes_of(writer.results_file());
    };
    const std::string one_by_one = written(1);
    EXPECT_TRUE(written(7) == one_by_one);
    EXPECT_TRUE(written(0) == one_by_one) << "all but the first at the end";
}

TEST(Results, FramesThatWaitAreStoredWhenSaved)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    ResultsWriter writer(the_case, folder.path());
    const auto stored = [&] { return ResultsReader(folder / "results.h5").times.size(); };
    for (int i = 0; i < 3; ++i) writer.add_frame(synthetic::swaying(the_case, 0.5 * i), {});
    EXPECT_EQ(stored(), 0);
    writer.save(synthetic::swaying(the_case, 1), {}, {});
    EXPECT_EQ(stored(), 3);
    EXPECT_FALSE(writer.is_full());
    const State state = synthetic::swaying(the_case, 1);
    const std::size_t bytes = sizeof(double) * (state.coordinates.size() + state.velocities.size());
    for (std::size_t i = 0; !writer.is_full(); ++i) {
        ASSERT_LT(i * bytes, std::size_t{64} << 20) << "frames wait without end";
        writer.add_frame(state, {});
    }
    EXPECT_EQ(stored(), 3);
}

INSTANTIATE_TEST_SUITE_P(Kinematics, AllKinematics,
                         testing::Values(Kinematics::spatial_deformable, Kinematics::spatial_rigid,
                                         Kinematics::planar_deformable, Kinematics::planar_rigid));

TEST(Results, StressIsTheBlocksCauchyStress)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::tower(Kinematics::spatial_deformable);
    const ResultsReader reader(write_run(the_case, folder.path()));
    const Eigen::Matrix3d stress = stress_of(the_case.model, synthetic::swaying(the_case, 1), 3);
    const Eigen::Matrix3d found = reader.frame(2).stresses.at(3);
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) EXPECT_EQ(found(i, j), stress(i, j));
    EXPECT_LT(stress(2, 2), -1e4) << "the made-up state presses the block";
}

TEST(Results, ARigidSceneHasNoStressOrStrain)
{
    const TemporaryFolder folder;
    const std::filesystem::path path = write_run(synthetic::tower(Kinematics::spatial_rigid), folder.path());
    const Hdf5File file = Hdf5File::open(path);
    EXPECT_TRUE(file.has("/frames/coordinates"));
    EXPECT_EQ(file.extents("/frames/coordinates"), (Extents{3, 9, 7}));
    EXPECT_EQ(file.extents("/frames/velocities"), (Extents{3, 9, 6}));
    for (const char* name : {"/frames/stress", "/frames/face_least_stress", "/frames/face_greatest_stress"}) {
        EXPECT_FALSE(file.has(name)) << name;
    }
    const std::string bytes = bytes_of(path);  // no dataset of such a name anywhere: names stand as text
    const std::size_t frames = bytes.find("face_displacement");
    ASSERT_NE(frames, std::string::npos);
    EXPECT_EQ(bytes.find("face_least_stress"), std::string::npos);
}

TEST(Results, MotionsAreThereOnlyWithAMotion)
{
    const TemporaryFolder still, shaken;
    Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    EXPECT_FALSE(Hdf5File::open(write_run(the_case, still.path())).has("/motions"));

    const auto sine = std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(4.9, 2.5, 0, 0.4));
    the_case.stages[1].motions = {{0, 0, sine}, {0, 1, sine}};
    the_case.motions = {{"foundation x: sine", sine->residual_velocity(), sine->residual_displacement(), 4.9}};
    const Hdf5File file = Hdf5File::open(write_run(the_case, shaken.path()));
    EXPECT_EQ(file.read_texts("/motions/motion_1/followers"), (std::vector<std::string>{"ground x", "ground y"}));
    EXPECT_FALSE(file.has("/motions/motion_2")) << "one motion is stored once, however many follow it";
    const Extents size = file.extents("/motions/motion_1/samples");
    EXPECT_EQ(size, (Extents{1001, 4}));  // 2 s at 2 ms
    const std::vector<double> row = file.read_rows<double>("/motions/motion_1/samples", 100, 1);
    EXPECT_EQ(row,
              (std::vector<double>{0.2, sine->acceleration(0.2), sine->velocity(0.2), sine->displacement(0.2)}));
}

TEST(Results, EveryEnergyTermIsANamedColumn)
{
    const TemporaryFolder folder;
    const Hdf5File file = Hdf5File::open(write_run(synthetic::tower(Kinematics::spatial_rigid), folder.path()));
    const std::vector<std::string> names = file.texts_attribute("/frames/energy", "columns");
    const std::vector<double> last = file.read_rows<double>("/frames/energy", 2, 1);
    ASSERT_EQ(names.size(), last.size());
    ASSERT_EQ(names.size(), energy_terms({}).size());
    const auto value = [&](const std::string& name) {
        return last.at(std::find(names.begin(), names.end(), name) - names.begin());
    };
    EXPECT_EQ(value("friction_J"), 20);
    EXPECT_EQ(value("gravity_work_J"), 50);
    EXPECT_EQ(value("residual_J"), 30);
}

TEST(Results, TheCaseItselfIsInTheFile)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_deformable);
    const Hdf5File file = Hdf5File::open(write_run(the_case, folder.path()));
    EXPECT_EQ(file.read_text("/case/text"), the_case.text);
    EXPECT_EQ(file.read_texts("/case/overrides"), the_case.overrides);
    EXPECT_EQ(file.read_texts("/case/defaults"), the_case.defaults);
    EXPECT_EQ(file.text_attribute("/", "kinematics"), "spatial deformable");
    EXPECT_EQ(file.number_attribute("/", "unknowns_per_block"), 12);
    EXPECT_NE(file.read_text("/case/settings").find("\"time_step_s\": 0.002"), std::string::npos);
    const std::vector<double> mass = file.read<double>("/model/mass");
    EXPECT_DOUBLE_EQ(mass.at(3), the_case.model.mass(3));
}

}  // namespace
}  // namespace voussoir::app::results
