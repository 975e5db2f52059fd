// The data of the interactive view: what the stones did, within what single precision and a 65535th tell; nothing
// in it ends the element that holds it.
#include "app/report/interactive_view.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/report/base64.h"
#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::report
{
namespace
{

/// The numbers that base64() wrote.
template <typename T>
std::vector<T> unpacked(const std::string& text)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, held = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6U | static_cast<unsigned>(digits.find(c));
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += static_cast<char>(bits >> held & 255U);
    }
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

TEST(KeptFrames, AreEvenWithTheFirstTheLastAndTheWantedOne)
{
    EXPECT_EQ(kept_frames(5, 10, 2), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(kept_frames(101, 5, 33), (std::vector<std::size_t>{0, 25, 33, 50, 75, 100}));
    EXPECT_EQ(kept_frames(101, 1, 0), (std::vector<std::size_t>{0, 100}));
    EXPECT_EQ(kept_frames(1, 5, 0), (std::vector<std::size_t>{0}));
    EXPECT_TRUE(kept_frames(0, 5, 0).empty());
}

TEST(Base64, IsReadBack)
{
    const std::vector<float> values = {0, -1.5F, 3.25e-7F, 1e30F, 7};
    EXPECT_EQ(unpacked<float>(base64({reinterpret_cast<const char*>(values.data()), 4 * values.size()})), values);
}

class ViewData : public CommandTest
{
 protected:
    /// Of two boxes of which the upper is thrown and turns. @param kinematics of the case
    RunRecord record_of(const std::string& kinematics,
                        const std::string& motion = "velocity: [0.5 m/s, 0, 2 m/s], spin: [0, 3 rad/s, 0]")
    {
        std::string text =
            with(two_boxes, "-0.5, -0.5, 0]", "-0.5, -1, 0]");  // as deep as the floor, for planar scenes
        text = with(text, "50 cm, 0.5, 1]", "50 cm, 1, 1]");
        text = with(text, "name: stone", "name: '</script><b>'");
        folder_.write("case.yaml", text + "kinematics: " + kinematics +
                                       "\ninitial_state: [{blocks: '</script><b>', " + motion + "}]\n");
        EXPECT_EQ(voussoir("run case.yaml -o results -q --set output.histories=null --set stages[0]=null"), 0)
            << output_;
        return RunRecord(folder_.path() / "results/results.h5");
    }
};

TEST_F(ViewData, HasTheMovesOfTheStones)
{
    for (const char* kinematics : {"spatial_rigid", "spatial_deformable"}) {
        const RunRecord record = record_of(kinematics);
        const nlohmann::json data = nlohmann::json::parse(view_data(record, 10));
        const std::size_t frames = record.results.times.size();
        ASSERT_EQ(data.at("times").size(), frames);
        const auto moves = unpacked<float>(data.at("moves").get<std::string>());
        ASSERT_EQ(moves.size(), frames * 2 * 6) << "two stones";
        const auto frame = record.results.frame(frames - 1);
        const Eigen::Vector3f last(moves.data() + (2 * frames - 1) * 6),
            turn(moves.data() + (2 * frames - 1) * 6 + 3);
        EXPECT_LT((last.cast<double>() - moved(record.results.model, frame, 1)).norm(), 1e-6);
        EXPECT_GT(last.norm(), 0.1F);
        const Pose pose = pose_of(record.results.model.kinematics, frame.state, 1);
        const Eigen::Vector3d vector = turn.cast<double>();
        const Eigen::Quaterniond quaternion(std::sqrt(1 - vector.squaredNorm()), vector.x(), vector.y(),
                                            vector.z());
        EXPECT_LT((quaternion.toRotationMatrix() - pose.map).norm(), 1e-5);
        EXPECT_GT(vector.norm(), 0.1);
        EXPECT_EQ(data.at("magnification"), 10);
    }
}

/// What the script reads of one number in a frame.
double read_back(const nlohmann::json& quantity, std::size_t index)
{
    const auto shares = unpacked<std::uint16_t>(quantity.at("shares").get<std::string>());
    const double lowest = quantity.at("lowest"), largest = quantity.at("largest");
    if (shares.at(index) == 65535) return std::numeric_limits<double>::quiet_NaN();
    return lowest + (largest - lowest) * shares[index] / 65534;
}

TEST_F(ViewData, HasTheOpeningsAsSharesOfTheirLargest)
{
    const RunRecord record = record_of("spatial_rigid");
    const nlohmann::json data = nlohmann::json::parse(view_data(record, 1));
    const nlohmann::json opening = data.at("of_joints").at("opening");
    const double largest = opening.at("largest");
    EXPECT_NEAR(largest, record.course.joint_opening[0].value, 1e-9);
    for (std::size_t i = 0; i < record.results.times.size(); ++i)
        EXPECT_NEAR(read_back(opening, i), record.results.frame(i).joints[0].motion.opening, 1e-5 * largest);
}

TEST_F(ViewData, HasTheUseOfFrictionAndNoneOfAJointThatDoesNotPress)
{
    std::size_t pressing = 0, open = 0;
    // Thrown up and sideways, or sliding on the floor.
    for (const RunRecord& record :
         {record_of("spatial_rigid"), record_of("spatial_rigid", "velocity: [0.5 m/s, 0, 0]")}) {
        const nlohmann::json friction = nlohmann::json::parse(view_data(record, 1)).at("of_joints").at("friction");
        for (std::size_t i = 0; i < record.results.times.size(); ++i) {
            const JointNow now = record.results.frame(i).joints[0];
            const double use = read_back(friction, i);
            EXPECT_EQ(std::isnan(use), !(now.area_in_use > 0)) << i;
            ++(std::isnan(use) ? open : pressing);
            if (std::isnan(use)) continue;
            const double bound = record.results.model.bounds[0].friction * now.normal_force;
            EXPECT_NEAR(use, std::min(1.0, now.shear_force / bound), 1e-4);
        }
    }
    EXPECT_GT(open, 0U);
    EXPECT_GT(pressing, 0U);
}

TEST_F(ViewData, HasSpeedsAndOfStonesThatDeformStressesAndStrains)
{
    const nlohmann::json rigid = nlohmann::json::parse(view_data(record_of("spatial_rigid"), 1));
    EXPECT_FALSE(rigid.at("of_stones").contains("stress"));
    const RunRecord record = record_of("spatial_deformable");
    const nlohmann::json of_stones = nlohmann::json::parse(view_data(record, 1)).at("of_stones");
    const std::size_t stones = record.results.model.block_names.size();
    for (std::size_t i = 0; i < record.results.times.size(); ++i) {
        const results::RecordedFrame frame = record.results.frame(i);
        const double speed = velocity_of(record.results.model.kinematics, frame.state, 1).norm();
        EXPECT_NEAR(read_back(of_stones.at("speed"), i * stones + 1), speed, 1e-4 * speed + 1e-4);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(frame.stresses[1]);
        const double range =
            of_stones.at("stress").at("largest").get<double>() - of_stones.at("stress").at("lowest").get<double>();
        EXPECT_GT(range, 0);
        EXPECT_NEAR(read_back(of_stones.at("stress"), i * stones + 1), -solver.eigenvalues()[0], 1e-4 * range);
    }
    EXPECT_GT(of_stones.at("strain").at("largest"), 0);
}

TEST_F(ViewData, DrawsOutlinesOfJointsThatAreThere)
{
    const RunRecord record = record_of("planar_rigid");
    const nlohmann::json data = nlohmann::json::parse(view_data(record, 1));
    const auto first = unpacked<std::uint32_t>(data.at("outline_first").get<std::string>());
    const auto vertices = unpacked<std::uint32_t>(data.at("vertex_block").get<std::string>());
    const auto outlines = unpacked<std::uint32_t>(data.at("outlines").get<std::string>());
    ASSERT_EQ(first.size(), 2U);
    EXPECT_EQ(first[1], outlines.size());
    EXPECT_GE(outlines.size(), 8U) << "four edges of a face at least";
    for (const std::uint32_t vertex : outlines) EXPECT_LT(vertex, vertices.size());
    EXPECT_EQ(vertices.size(), 16U) << "two boxes in space, though the scene is planar";
}

TEST_F(ViewData, NoNameEndsTheScript)
{
    const std::string data = view_data(record_of("spatial_rigid"), 1);
    EXPECT_EQ(data.find('<'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(data).at("names").at(1), "</script><b>") << "and it is read back as it was";
}

TEST(ViewPage, RunsThatScriptAloneAndSaysWhatReadersWithoutScriptsMiss)
{
    Document document;
    document.sections.push_back({"Interactive view", {}, {}, {}, {}, {}, true});
    document.view = {{"sha256-abc=", "/* three.js */ run()"}, "{\"names\":[]}"};
    const std::string page = to_html(document);
    EXPECT_NE(page.find("script-src 'sha256-abc='\">"), std::string::npos) << page.substr(0, 400);
    EXPECT_NE(page.find("<script>/* three.js */ run()</script>"), std::string::npos);
    EXPECT_NE(page.find("<div id=\"view\"><p"), std::string::npos);
    document.view.data.clear();
    EXPECT_EQ(to_html(document).find("script-src"), std::string::npos);
    EXPECT_EQ(to_html(document).find("<script"), std::string::npos);
}

}  // namespace
}  // namespace voussoir::app::report
