// Rock cut by joint sets, through the helper program.
#include <cmath>
#include <numbers>

#include "importers/exact/joint_sets.h"
#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

constexpr double degree = std::numbers::pi / 180;

Case read_rock(const std::string& keys, const std::vector<std::string>& overrides = {})
{
    return reader::read(with(pattern_case("{rock: {" + keys + "}, groups: {foundation: {lowest: 0 %}}}"),
                             "  - {name: rest", "#  - {name: rest"),
                        overrides);
}

TEST(RockPattern, KhansSlopeOfParallelJointsHas28Blocks)
{
    const std::string keys =
        "outline: [[0, -10], [272, -10], [400, 260], [182.054, 260], [0, 0]], "
        "sets: [{dip: 35.2 deg, dip_direction: 270 deg, spacing: 10 m}]";
    const Case the_case = read_rock(keys);
    EXPECT_EQ(the_case.model.blocks.size(), 28U);
    const double area = 0.5 * (270 * (272 + 400) - 260 * 182.054);  // left of the right side, less the face
    EXPECT_NEAR(volume_in(the_case.model, ""), area, 1e-12 * area);
    // Persistent joints: 27 contacts, one of them from the toe to the top.
    const auto assembly = assembly_of(the_case.model);
    ASSERT_EQ(assembly.contacts.size(), 27U);
    EXPECT_TRUE(std::any_of(assembly.contacts.begin(), assembly.contacts.end(), [](const auto& contact) {
        return std::abs(contact.area - 260 / std::sin(35.2 * degree)) < 1e-6;
    }));
}

/// Horizontal joints every 40 m and joints parallel to the face every 10 m; 482 blocks in the paper.
TEST(RockPattern, KhansSlopeOfTwoSetsHas482Blocks)
{
    const double crest = 260 / std::tan(55 * degree);
    const std::string keys = "outline: [[0, 0], [918, 0], [918, 260], [" + std::to_string(crest) +
                             ", 260]], sets: [{dip: 0 deg, spacing: 40 m}, "
                             "{dip: 55 deg, dip_direction: 270 deg, spacing: 10 m}]";
    const Case the_case = read_rock(keys, {"kinematics=planar_rigid"});
    EXPECT_EQ(the_case.model.blocks.size(), 482U);
    const double area = 260 * (918 - 0.5 * std::stod(std::to_string(crest)));
    EXPECT_NEAR(volume_in(the_case.model, ""), area, 1e-12 * area);
}

TEST(RockPattern, PiecesOfRandomJointsAddUpToTheBody)
{
    importers::exact::RockRequest request;
    request.domain = {make_box({0, 0, 0}, {3, 2, 1})};
    for (const double azimuth : {0.3, 1.9, 4.0})
        request.sets.push_back({Eigen::Vector3d(std::sin(azimuth), std::cos(azimuth), 0.7).normalized(),
                                {0.1, 0.2, 0.3},
                                0.45,
                                0.3,
                                1});
    const auto cut = [&] { return importers::exact::cut_rock(request); };
    const importers::exact::CutRock rock = cut();
    EXPECT_EQ(rock.domain_volume, 6);
    EXPECT_EQ(rock.volume, 6) << "the sum is exact";
    double sum = 0;
    for (const auto& block : rock.blocks) sum += moments_of(block.parts).volume;
    EXPECT_NEAR(sum, 6, 6e-12);
    EXPECT_GT(rock.blocks.size(), 50U);
    EXPECT_EQ(cut().blocks.size(), rock.blocks.size());
    request.seed = 2;
    EXPECT_NE(cut().blocks[5].volume, rock.blocks[5].volume);
    // Joints that end at others make fewer blocks of the same body.
    request.seed = 1;
    for (auto& set : request.sets) set.persistence = 0.5;
    const importers::exact::CutRock some = cut();
    EXPECT_LT(some.blocks.size(), rock.blocks.size());
    EXPECT_GT(some.blocks.size(), 3U);
    EXPECT_EQ(some.volume, 6);
    request.smallest = 0.05;
    const importers::exact::CutRock large = cut();
    EXPECT_GT(large.removed, 0);
    double left = large.removed_volume;
    for (const auto& block : large.blocks) {
        EXPECT_GE(block.volume, 0.05);
        left += block.volume;
    }
    EXPECT_NEAR(left, 6, 1e-12);
}

/// A box of 3 x 2 x 1 m, cut 0.1 m from its end: the slice is too small, and becomes part of its neighbour.
TEST(RockPattern, MergesBlocksThatAreTooSmallWithTheirNeighbours)
{
    const std::string keys =
        "outline: [[0, 0], [3, 0], [3, 1], [0, 1]], width: 2 m, "
        "sets: [{dip: 90 deg, spacing: 1 m, origin: [0.1, 0, 0]}, {dip: 0 deg, spacing: 0.5 m}], smallest: 0.7 m";
    const Case left_out = read_rock(keys), merged = read_rock(keys + ", small: merge");
    // Blocks of 1 m3 but for those at the ends, of 0.1 m3 and of 0.9 m3 in two layers.
    EXPECT_EQ(left_out.model.blocks.size(), 6U);
    EXPECT_NEAR(volume_in(left_out.model, ""), 6 - 0.2, 1e-12);
    ASSERT_EQ(merged.model.blocks.size(), 6U);
    EXPECT_NEAR(volume_in(merged.model, ""), 6, 1e-12);
    int of_two = 0;
    for (const Block& block : merged.model.blocks) {
        if (block.parts.size() != 2) continue;
        ++of_two;
        EXPECT_NEAR(block.moments.volume, 1.1, 1e-12);
    }
    EXPECT_EQ(of_two, 2);
    const auto assembly = assembly_of(merged.model);
    expect_sound(assembly);
    EXPECT_TRUE(std::any_of(merged.warnings.begin(), merged.warnings.end(), [](const std::string& line) {
        return line.find("2 blocks smaller than 0.343 m3 were merged with their neighbours, 0.2 m3 in all") !=
               std::string::npos;
    }));
}

/// However many are merged, they add up to the body, and none is too small.
TEST(RockPattern, MergedBlocksOfRandomJointsAddUpToTheBody)
{
    importers::exact::RockRequest request;
    request.domain = {make_box({0, 0, 0}, {3, 2, 1})};
    for (const double azimuth : {0.3, 1.9, 4.0})
        request.sets.push_back({Eigen::Vector3d(std::sin(azimuth), std::cos(azimuth), 0.7).normalized(),
                                {0.1, 0.2, 0.3},
                                0.45,
                                0.3,
                                1});
    request.smallest = 0.02;
    const importers::exact::CutRock removed = importers::exact::cut_rock(request);
    request.merge = true;
    const importers::exact::CutRock merged = importers::exact::cut_rock(request);
    EXPECT_EQ(merged.removed, 0);
    EXPECT_GT(merged.merged, 50);
    EXPECT_LE(merged.blocks.size(), removed.blocks.size() + static_cast<std::size_t>(removed.removed));
    double sum = 0;
    for (const auto& block : merged.blocks) {
        EXPECT_GE(block.volume, 0.02);
        const double own = moments_of(block.parts).volume;
        EXPECT_NEAR(own, block.volume, 1e-12);
        sum += own;
    }
    EXPECT_NEAR(sum, 6, 6e-12);
}

/// A slope with a bench before its toe is concave: its blocks go on round the corner, as glued parts.
TEST(RockPattern, ConcaveBodiesGiveBlocksOfGluedParts)
{
    const std::string keys =
        "outline: [[-20, -10], [60, -10], [60, 20], [10, 20], [0, 0], [-20, 0]], width: 5 m, "
        "sets: [{dip: 0 deg, spacing: 8 m, origin: [0, 0, 4]}, "
        "{dip: 80 deg, dip_direction: 90 deg, spacing: 12 m}]";
    const Case the_case = read_rock(keys);
    const double volume = 5 * (80 * 10 + 20 * (60 - 5.0));
    EXPECT_NEAR(volume_in(the_case.model, ""), volume, 1e-12 * volume);
    std::size_t parts = 0;
    for (const Block& block : the_case.model.blocks) parts += block.parts.size();
    EXPECT_GT(parts, the_case.model.blocks.size());
    const auto assembly = assembly_of(the_case.model);
    EXPECT_TRUE(assembly.overlaps.empty());
    EXPECT_TRUE(assembly.unsupported.empty());
}

/// Two blocks on a plane of 20 degrees: what lies above stays if friction is steeper, and slides if not.
TEST(RockPattern, SlidesWhereFrictionSays)
{
    const std::string keys =
        "outline: [[0, 0], [30, 0], [30, 12], [2, 12]], "
        "sets: [{dip: 20 deg, dip_direction: 270 deg, spacing: 20 m, origin: [0, 0, 2]}]";
    const auto outcome = [&](const char* friction) {
        return run_to_rest(
                   read_rock(keys, {"kinematics=planar_rigid", std::string("joints.dry.friction=") + friction}))
            .report.outcome;
    };
    EXPECT_EQ(outcome("20.2 deg"), Outcome::completed);
    EXPECT_NE(outcome("19.8 deg"), Outcome::completed);
}

/// The wedge above the joint through the toe, of weight W and with a joint of length L at the angle b, has the
/// factor of safety (c L + W cos b tan phi) / (W sin b) = 1.3131 (the paper: 1.3092).
TEST(RockPattern, KhansSlopeHasItsFactorOfSafety)
{
    const double b = 35.2 * degree, cohesion = 0.1e6, friction = std::tan(40 * degree);
    const double weight = 26100 * 0.5 * 260 * (260 / std::tan(b) - 182.054), length = 260 / std::sin(b);
    const double safety = (cohesion * length + weight * std::cos(b) * friction) / (weight * std::sin(b));
    EXPECT_NEAR(safety, 1.3092, 0.005);
    const auto stands = [&](double factor) {
        const Case the_case =
            reader::read_case(std::filesystem::path(VOUSSOIR_CASES) / "slope_28.yaml",
                              {"joints.joint.friction=" + std::to_string(std::atan(friction / factor)) + " rad",
                               "joints.joint.cohesion=" + std::to_string(cohesion / factor) + " Pa"});
        return run_to_rest(the_case).report.outcome == Outcome::completed;
    };
    EXPECT_TRUE(stands(safety * 0.995));
    EXPECT_FALSE(stands(safety * 1.005));
}

/// A pyramid of 6 m on a square of 4 m, as listed corners and as a mesh: layers of 1 m, of which the volumes are
/// those of frusta.
TEST(RockPattern, CutsPolyhedraAndMeshes)
{
    const std::string sets = "sets: [{dip: 0 deg, spacing: 1 m}]}, groups: {foundation: {lowest: 0 %}}}";
    const std::string listed =
        "{rock: {parts: [{vertices: [[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0], [0, 0, 6]], faces: [[0, 3, "
        "2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]}], " +
        sets;
    const TemporaryFolder folder;
    folder.write("hill.obj",
                 "o hill\nv -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv 0 0 6\nf 1 4 3 2\nf 1 2 5\nf 2 3 5\nf 3 4 "
                 "5\nf 4 1 5\n");
    const auto read = [&](const std::string& entry) {
        return reader::read_case(folder.write("case.yaml", pattern_case(entry)), {});
    };
    for (const std::string& entry : {listed, "{rock: {mesh: hill.obj, " + sets}) {
        const Case the_case = read(entry);
        ASSERT_EQ(the_case.model.blocks.size(), 6U) << entry;
        std::vector<double> volumes;
        for (const Block& block : the_case.model.blocks) volumes.push_back(block.moments.volume);
        std::sort(volumes.begin(), volumes.end());
        for (int k = 0; k < 6; ++k) {
            const double top = 4.0 * k / 6, foot = 4.0 * (k + 1) / 6;
            EXPECT_NEAR(volumes[k], (top * top + top * foot + foot * foot) / 3, 32e-12);
        }
        EXPECT_NEAR(volume_in(the_case.model, ""), 32, 32e-12);
        expect_sound(assembly_of(the_case.model));
    }
    EXPECT_NE(reader::faults_of(pattern_case("{rock: {mesh: none.obj, " + sets)).find("no mesh file"),
              std::string::npos);
    EXPECT_NE(reader::faults_of(pattern_case("{rock: {" + sets)).find("no body"), std::string::npos);
    EXPECT_NE(reader::faults_of(pattern_case("{rock: {mesh: a.obj, outline: [[0, 0], [1, 0], [0, 1]], " + sets))
                  .find("more than one body"),
              std::string::npos);
}

/// A ridge with a step is concave: read from a mesh, its blocks go on round the corner as from an outline.
TEST(RockPattern, CutsConcaveMeshes)
{
    const std::string sets = "sets: [{dip: 90 deg, spacing: 1.5 m, origin: [0.7, 0, 0]}]";
    const TemporaryFolder folder;
    const std::string outline =
        "rock: {outline: [[0, 0], [4, 0], [4, 1], [2, 1], [2, 3], [0, 3]], width: 2 m, " + sets + "}";
    folder.write("ridge.obj",
                 "o ridge\nv 0 -1 0\nv 4 -1 0\nv 4 -1 1\nv 2 -1 1\nv 2 -1 3\nv 0 -1 3\nv 0 1 0\nv 4 1 0\nv 4 1 "
                 "1\nv 2 1 1\nv 2 1 3\nv 0 1 3\nf 1 2 3 4 5 6\nf 12 11 10 9 8 7\nf 1 7 8 2\nf 2 8 9 3\nf 3 9 10 "
                 "4\nf 4 10 11 5\nf 5 11 12 6\nf 6 12 7 1\n");
    const auto read = [&](const std::string& entry) {
        return reader::read_case(
                   folder.write("case.yaml", pattern_case("{" + entry + ", groups: {foundation: {lowest: 0 %}}}")),
                   {})
            .model;
    };
    const Model drawn = read(outline), cut = read("rock: {mesh: ridge.obj, " + sets + "}");
    EXPECT_EQ(drawn.blocks.size(), 4U);
    ASSERT_EQ(cut.blocks.size(), drawn.blocks.size());
    EXPECT_NEAR(volume_in(cut, ""), 2 * (4 * 1 + 2 * 2), 1e-11);
    std::vector<double> ours, theirs;
    for (std::size_t b = 0; b < 4; ++b) {
        ours.push_back(cut.blocks[b].moments.volume);
        theirs.push_back(drawn.blocks[b].moments.volume);
    }
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    for (std::size_t b = 0; b < 4; ++b) EXPECT_NEAR(ours[b], theirs[b], 1e-12);
}

TEST(RockPattern, SaysWhatIsWrong)
{
    const auto faults = [](const std::string& keys) {
        return reader::faults_of(pattern_case("rock: {" + keys + "}"));
    };
    const std::string crossed =
        faults("outline: [[0, 0], [10, 10], [10, 0], [0, 10]], sets: [{dip: 10 deg, spacing: 1 m}]");
    EXPECT_NE(crossed.find("it crosses itself; give the corners in order"), std::string::npos) << crossed;
    const std::string many = faults("outline: [[0, 0], [10, 0], [10, 10]], sets: [{dip: 10 deg, spacing: 1 um}]");
    EXPECT_NE(many.find("more than 100000 joints in a set"), std::string::npos) << many;
}

}  // namespace
}  // namespace voussoir::app::patterns_test
