// What a planar run writes: nothing of the third dimension.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/results/results_reader.h"
#include "app/results/results_writer.h"
#include "app/results/state_file.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{
namespace
{

/// Three frames of a planar arch of 15 voussoirs and two abutments.
std::filesystem::path write_arch(const TemporaryFolder& folder, const Case& the_case)
{
    ResultsWriter writer(the_case, folder.path());
    State state;
    for (const double time : {0.0, 0.5, 1.0}) {
        state = synthetic::swaying(the_case, time);
        writer.history(state, {}, {});
        writer.frame(state, {});
    }
    writer.finish(state, {}, {0, 0});
    return writer.results_file();
}

class PlanarResults : public testing::TestWithParam<Kinematics>
{
 protected:
    PlanarResults() : the_case(synthetic::arch(GetParam())), path(write_arch(folder, the_case)) {}
    const TemporaryFolder folder;
    const Case the_case;
    const std::filesystem::path path;
};

TEST_P(PlanarResults, EveryVectorHasTwoComponents)
{
    const Hdf5File file = Hdf5File::open(path);
    const std::uint64_t n = 17, vertices = 17 * 4, contacts = 3 * 16, joints = 16;
    EXPECT_EQ(file.extents("/model/origin"), (Extents{2}));
    EXPECT_EQ(file.extents("/model/centroid"), (Extents{n, 2}));
    EXPECT_EQ(file.extents("/model/second_moments"), (Extents{n, 2, 2}));
    EXPECT_EQ(file.extents("/model/mesh/levers"), (Extents{vertices, 2}));
    EXPECT_EQ(file.extents("/model/mesh/face_block"), (Extents{n}));
    EXPECT_EQ(file.extents("/model/foundations/held"), (Extents{2, 3}));
    EXPECT_EQ(file.extents("/frames/positions"), (Extents{3, vertices, 2}));
    EXPECT_EQ(file.extents("/frames/ground_displacement"), (Extents{3, 2}));
    for (const char* vector : {"force", "centre", "normal", "pressure_centre"})
        EXPECT_EQ(file.extents(std::string("/frames/contacts/") + vector), (Extents{contacts, 2})) << vector;
    EXPECT_EQ(file.extents("/frames/contacts/moment"), (Extents{contacts}));
    EXPECT_EQ(file.extents("/joints/centre"), (Extents{joints, 2}));
    EXPECT_EQ(file.extents("/joints/normal"), (Extents{joints, 2}));
    EXPECT_EQ(file.extents("/frames/joints/opening"), (Extents{3, joints}));
    const std::uint64_t unknowns = is_deformable(GetParam()) ? 6 : 3;
    EXPECT_EQ(file.extents("/frames/coordinates"), (Extents{3, n, unknowns}));
    EXPECT_EQ(file.extents("/frames/velocities"), (Extents{3, n, unknowns}));
}

TEST_P(PlanarResults, TheSceneIsDescribed)
{
    const Hdf5File file = Hdf5File::open(path);
    EXPECT_EQ(file.text_attribute("/", "kinematics"), name_of(GetParam()));
    EXPECT_EQ(file.number_attribute("/", "thickness_m"), 2);
    EXPECT_EQ(ResultsReader(path).model.kinematics, GetParam());
    EXPECT_EQ(ResultsReader(path).model.thickness, 2);
    const nlohmann::json summary = nlohmann::json::parse(std::ifstream(folder.path() / "summary.json"));
    EXPECT_EQ(summary["thickness_m"], 2);
    EXPECT_EQ(summary["state_bytes_per_block"], is_deformable(GetParam()) ? 96 : 48);
    EXPECT_EQ(summary["left_out"][0], "the third dimension (the scene is planar)");
    EXPECT_EQ(summary.contains("plane"), is_deformable(GetParam()));
    if (!is_deformable(GetParam())) return;
    EXPECT_EQ(summary["plane"], "strain");
    EXPECT_EQ(file.text_attribute("/", "plane"), "strain");
}

TEST_P(PlanarResults, HistoriesHaveNoY)
{
    std::ifstream stream(folder.path() / "histories.csv");
    std::string header;
    std::getline(stream, header);
    EXPECT_EQ(header,
              "time [s],crown ux [m],crown uz [m],crown vx [m/s],crown vz [m/s],ground ux [m],ground uz [m]");
}

TEST_P(PlanarResults, AStateComesBackAndIsSmallerThanTheSpatialOne)
{
    State state = synthetic::swaying(the_case, 1.2345678);
    state.planar_contacts.points[3].elastic_slip = {1e-9, -0.0};
    save_state(state, folder.path() / "planar");
    EXPECT_EQ(hash_of(load_state(folder.path() / "planar")), hash_of(state));
    const Kinematics spatial =
        is_deformable(GetParam()) ? Kinematics::spatial_deformable : Kinematics::spatial_rigid;
    save_state(synthetic::swaying(synthetic::arch(spatial), 1.2345678), folder.path() / "spatial");
    EXPECT_LT(2 * file_size(folder.path() / "planar"), file_size(folder.path() / "spatial"));
    EXPECT_LT(file_size(path), file_size(write_arch(TemporaryFolder(), synthetic::arch(spatial)))) << "results";
}

INSTANTIATE_TEST_SUITE_P(Kinematics, PlanarResults,
                         testing::Values(Kinematics::planar_deformable, Kinematics::planar_rigid));

TEST(PlanarStress, HasTheComponentsOfItsPlane)
{
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        const TemporaryFolder folder;
        Case the_case = synthetic::tower(Kinematics::planar_deformable);
        the_case.model.plane = plane;
        const std::filesystem::path path = write_arch(folder, the_case);
        std::vector<std::string> columns = {"xx", "zz", "xz"};
        if (plane == PlaneCondition::strain) columns.emplace_back("yy");
        EXPECT_EQ(Hdf5File::open(path).texts_attribute("/frames/stress", "columns"), columns);
        const Eigen::Matrix3d stress = stress_of(the_case.model, synthetic::swaying(the_case, 1), 3);
        EXPECT_EQ(ResultsReader(path).frame(2).stresses.at(3), stress);
        EXPECT_LT(stress(2, 2), -1e4) << "the made-up state presses the block";
        EXPECT_EQ(stress(1, 1) != 0, plane == PlaneCondition::strain);
    }
}

TEST(PlanarJoints, AMomentCountsFromXToZ)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::planar_rigid);
    const std::filesystem::path path = write_arch(folder, the_case);
    const State state = synthetic::swaying(the_case, 1);
    const std::vector<JointResultant> joints = joint_resultants(the_case.model, state);
    const Hdf5File file = Hdf5File::open(path);
    const std::vector<double> moments = file.read_rows<double>("/frames/contacts/moment", 32, 16);
    bool some = false;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        double moment = 0;  // r x f in the plane: x f_z - z f_x, of the points of the patch
        const ContactPatchIn<2>& patch = state.planar_contacts.patches[i];
        for (int p = patch.first_point; p < patch.first_point + patch.point_count; ++p) {
            const ContactPointIn<2>& point = state.planar_contacts.points[p];
            const Eigen::Vector2d arm = point.position - from_space<2>(joints[i].centre);
            const Eigen::Vector2d force = point.normal_force * patch.normal;
            moment += arm.x() * force.y() - arm.y() * force.x();
        }
        EXPECT_NEAR(moments[i], moment, 1e-6);
        some = some || std::abs(moment) > 1e3;
    }
    EXPECT_TRUE(some);
}

}  // namespace
}  // namespace voussoir::app::results
