// Boundaries, tied sides, waves from below and Rayleigh damping in a case file; and what is said about faults.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

/// @param top lines at the top @param motion of the dynamic stage @param rest the static stage, or nothing
std::string ground(const std::string& top, const std::string& motion,
                   const std::string& rest = "  - {name: rest, type: static}\n", const std::string& soil = "")
{
    return "materials: {soil: {density: 2000 kg/m3, young: 200 MPa, poisson: 0.25" + soil +
           "}}\n"
           "joints: {bond: {friction: 30 deg, cohesion: 1 GPa, tensile_strength: 1 GPa}}\n"
           "blocks:\n"
           "  - {box: {name: low, lower: [0, 0, -2], upper: [3, 1, -1]}, group: soil}\n"
           "  - {box: {name: high, lower: [0, 0, -1], upper: [3, 1, 0]}, group: soil}\n" +
           top + "stages:\n" + rest + "  - {name: quake, type: dynamic, duration: 1 s" + motion + "}\n";
}

const std::string base = "boundaries: [{name: base, blocks: soil, side: bottom}]\n";

}  // namespace

TEST(BoundaryCase, TakesTheFarthestFacesOfASide)
{
    const Model model = read(ground("boundaries:\n"
                                    "  - {name: base, blocks: soil, side: bottom}\n"
                                    "  - {name: flank, blocks: soil, side: [1, 0, 0], at_rest: normal}\n",
                                    ""))
                            .model;
    ASSERT_EQ(model.boundaries.size(), 2u);
    EXPECT_EQ(model.boundaries[0].faces.size(), 1u);
    EXPECT_EQ(model.boundaries[0].faces[0].block, 0);
    EXPECT_EQ(model.boundaries[0].at_rest, RestSupport::full);
    const BlockFace& face = model.boundaries[0].faces[0];
    EXPECT_LT(face_normal(model.blocks[0].parts[0], face.face).z(), -0.99);
    EXPECT_EQ(model.boundaries[1].faces.size(), 2u);
    EXPECT_EQ(model.boundaries[1].at_rest, RestSupport::normal);
}

TEST(BoundaryCase, IsTheSameInAPlanarScene)
{
    const Model model = read(ground(base, ""), {"kinematics=planar_deformable"}).model;
    ASSERT_EQ(model.boundaries[0].faces.size(), 1u);
    const BlockFace& face = model.boundaries[0].faces[0];
    const auto& corners = model.blocks[face.block].outlines[0].vertices;
    EXPECT_LT(corners[face.face].y(), 0);
    EXPECT_LT(corners[(face.face + 1) % 4].y(), 0);
}

TEST(BoundaryCase, ReadsWavesAndTheirShare)
{
    const Case whole = read(ground(base,
                                   ", incoming_wave: {motion_is: upgoing, x: {ricker: {acceleration: 1 m/s2, "
                                   "frequency: 2 Hz}}}"));
    ASSERT_EQ(whole.stages[1].incoming_waves.size(), 1u);
    EXPECT_EQ(whole.stages[1].incoming_waves[0].share, 1);
    EXPECT_EQ(whole.stages[1].incoming_waves[0].component, 0);
    const Case half =
        read(ground(base,
                    ", incoming_wave: [{boundary: base, motion_is: outcrop, z: {ricker: {acceleration: 1 "
                    "m/s2, frequency: 2 Hz}}, passes: {speed: 500 m/s, direction: [2, 0, 0]}}]"));
    EXPECT_EQ(half.stages[1].incoming_waves[0].share, 0.5);
    EXPECT_EQ(half.stages[1].incoming_waves[0].component, 2);
    EXPECT_TRUE(half.stages[1].incoming_waves[0].slowness.isApprox(Eigen::Vector3d(1.0 / 500, 0, 0)));
    EXPECT_TRUE(half.stages[1].incoming_waves[0].origin.isApprox(Eigen::Vector3d(1.5, 0.5, -2)));  // its only face
}

TEST(BoundaryCase, ReadsTiedSides)
{
    EXPECT_EQ(read(ground(base + "tied_sides: soil\n", "")).model.tied_sides, (std::vector<int>{0, 1}));
    EXPECT_EQ(read(ground(base + "tied_sides: [soil]\n", "")).model.tied_sides, (std::vector<int>{0, 1}));
}

// The modulus that is given is that in the middle of the band; at rest the material is softer.
TEST(BoundaryCase, ReadsHystereticDamping)
{
    const Case the_case = read(
        ground(base, "", "  - {name: rest, type: static}\n", ", hysteretic: {ratio: 5 %, band: [1 Hz, 16 Hz]}"));
    const BlockMaterial& soil = the_case.model.materials[0];
    ASSERT_FALSE(soil.branches.empty());
    for (const double frequency : {1.0, 2.0, 4.0, 8.0, 16.0})
        EXPECT_NEAR(damping_ratio_of(soil.branches, 2 * std::numbers::pi * frequency), 0.05, 0.05 * 0.01);
    EXPECT_NEAR(soil.young * modulus_over_rest(soil.branches, 8 * std::numbers::pi).real(), 200e6, 1);
    EXPECT_LT(soil.young, 190e6);
}

// What the two numbers mean: the ratio asked for at both frequencies, and less between them.
TEST(BoundaryCase, ReadsRayleighDampingFromTwoFrequencies)
{
    const Case the_case = read(ground(base, "", "  - {name: rest, type: static}\n",
                                      ", rayleigh: {ratio: [0.05, 0.04], at: [1 Hz, 8 Hz]}"));
    const RayleighDamping damping = the_case.model.materials[0].rayleigh;
    const auto ratio = [&](double frequency) {
        const double omega = 2 * std::numbers::pi * frequency;
        return 0.5 * damping.of_mass / omega + 0.5 * damping.of_stiffness * omega;
    };
    EXPECT_NEAR(ratio(1), 0.05, 1e-12);
    EXPECT_NEAR(ratio(8), 0.04, 1e-12);
    EXPECT_LT(ratio(3), 0.04);
}

namespace
{

std::string soil(const std::string& more,
                 const std::string& layers =
                     "[{thickness: 6 m, shear_wave: 200 m/s, density: 1900 kg/m3, poisson: 0.3},"
                     " {thickness: 4 m, shear_wave: 400 m/s, density: 2000 kg/m3, poisson: 0.25}]")
{
    return "kinematics: planar_deformable\n"
           "materials: {stone: {density: 2000 kg/m3, young: 3 GPa, poisson: 0.2}}\n"
           "joints: {bond: {friction: 30 deg, cohesion: 1 GPa, tensile_strength: 1 GPa}}\n"
           "blocks:\n"
           "  - {soil: {width: 8 m, highest_frequency: 10 Hz, layers: " +
           layers + more + "}}\n" + "stages: [{name: rest, type: static}]\n";
}

}  // namespace

// 200 m/s at 10 Hz is a wave of 20 m: blocks of 2 m, three rows; 400 m/s: 4 m, one row. Columns of 2 m.
TEST(SoilCase, CutsLayersAsFineAsWavesNeed)
{
    const Case the_case = read(soil(""));
    const Model& model = the_case.model;
    ASSERT_EQ(model.blocks.size(), 16u);
    EXPECT_EQ(model.blocks[0].name, "soil_r1_c1");
    EXPECT_TRUE(model.blocks[0].moments.centroid.isApprox(Eigen::Vector3d(-3, 0, -1)));
    EXPECT_NEAR(model.blocks[0].moments.volume, 4, 1e-12);
    EXPECT_EQ(model.blocks[15].name, "soil_r4_c4");
    EXPECT_NEAR(model.blocks[15].moments.volume, 8, 1e-12);
    const BlockMaterial& deep = model.materials[model.blocks[15].material];
    EXPECT_NEAR(deep.young, 2 * 1.25 * 2000 * 400 * 400, 1);
    EXPECT_TRUE(has_default(the_case, "a tenth of the S wave of 200 m/s at 10 Hz is 2 m"));
}

TEST(SoilCase, HasColumnsBeside)
{
    const Model model = read(soil(", side_columns: 500 m") +
                             "tied_sides: soil_sides\n"
                             "boundaries: [{name: base, blocks: [soil, soil_sides], side: bottom}]\n")
                            .model;
    ASSERT_EQ(model.blocks.size(), 24u);
    EXPECT_EQ(model.tied_sides.size(), 8u);
    EXPECT_EQ(model.boundaries[0].faces.size(), 6u);  // four columns and two beside
}

/// Sides of a soil that columns two metres away are the free field of.
const std::string free_sides =
    "boundaries:\n"
    "  - {name: base, blocks: [soil, soil_sides], side: bottom}\n"
    "  - {name: left, blocks: soil, side: left, free_field: soil_sides}\n"
    "  - {name: right, blocks: soil, side: right, free_field: soil_sides}\n";

TEST(SoilCase, HasColumnsApartThatAreTheFreeFieldOfItsSides)
{
    const Model model =
        read(soil(", side_columns: 2 m, side_gap: 3 m") + "tied_sides: soil_sides\n" + free_sides).model;
    ASSERT_EQ(model.boundaries.size(), 3u);
    for (const std::size_t side : {1u, 2u}) {
        const ViscousBoundary& boundary = model.boundaries[side];
        EXPECT_EQ(boundary.at_rest, RestSupport::normal);
        ASSERT_EQ(boundary.faces.size(), 4u);
        ASSERT_EQ(boundary.free_field.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto &own = model.blocks[boundary.faces[i].block].moments.centroid,
                       &column = model.blocks[boundary.free_field[i]].moments.centroid;
            EXPECT_NEAR(column.z(), own.z(), 1e-9);
            EXPECT_NEAR(std::abs(column.x() - own.x()), 3 + 1 + 1, 1e-9);  // the gap and half of each block
        }
    }
    EXPECT_TRUE(model.boundaries[0].free_field.empty());
}

TEST(SoilCase, SaysWhatIsWrongWithAFreeField)
{
    const auto says = [](const std::string& text, const std::string& part) {
        const std::string faults = faults_of(text);
        EXPECT_NE(faults.find(part), std::string::npos) << faults;
    };
    const std::string columns = ", side_columns: 2 m, side_gap: 3 m";
    says(soil(columns) + free_sides, "name its group in tied_sides too");
    says(soil(", side_gap: 3 m"), "side_gap without side_columns");
    says(soil(columns) + "tied_sides: soil\nboundaries: [{blocks: soil, side: left, free_field: soil}]\n",
         "its own free field");
    says(soil(columns) +
             "tied_sides: [soil, soil_sides]\n"
             "boundaries: [{blocks: soil, side: left, free_field: sides}]\n",
         "soil_sides");
}

TEST(SoilCase, TiesOppositeSides)
{
    const Model model = read(soil("") +
                             "periodic_sides: {blocks: soil, sides: [left, right]}\n"
                             "boundaries: [{name: base, blocks: soil, side: bottom}]\n")
                            .model;
    ASSERT_EQ(model.side_ties.size(), 4u);
    for (const SideTie& tie : model.side_ties) {
        const Eigen::Vector3d apart =
            model.blocks[tie.b.block].moments.centroid - model.blocks[tie.a.block].moments.centroid;
        EXPECT_NEAR(apart.x(), 6, 1e-9);
        EXPECT_NEAR(apart.z(), 0, 1e-9);
        // As stiff as a bonded joint of two blocks 2 m wide.
        const double young = model.materials[model.blocks[tie.a.block].material].young;
        EXPECT_NEAR(tie.normal, 300 * young / 2, 1e-6 * young);
        EXPECT_NEAR(tie.shear, 0.5 * tie.normal, 1e-6 * young);
    }
}

TEST(SoilCase, SaysWhatIsWrongWithPeriodicSides)
{
    const auto says = [](const std::string& text, const std::string& part) {
        const std::string faults = faults_of(text);
        EXPECT_NE(faults.find(part), std::string::npos) << faults;
    };
    says(soil("") + "periodic_sides: {blocks: soil, sides: [left, bottom]}\n", "not opposite");
    says(soil("") + "periodic_sides: {blocks: soil, sides: [left]}\n", "not opposite");
    says(soil("") + "periodic_sides: {blocks: soil, sides: [left, far]}\n", "expected bottom, top, left");
    says(soil("") + "periodic_sides: {blocks: sol, sides: [left, right]}\n", "soil");
    says(ground("periodic_sides: {blocks: soil, sides: [left, right]}\n", ""), "use tied_sides");
}

TEST(SoilCase, SaysWhatIsWrong)
{
    const auto says = [](const std::string& text, const std::string& part) {
        const std::string faults = faults_of(text);
        EXPECT_NE(faults.find(part), std::string::npos) << faults;
    };
    says(soil(", depth: 3 m"), "a planar scene has a thickness");
    says(soil("", "[]"), "an empty list");
    says(soil("", "[{thickness: 6 m, shear_wave: 200 m/s, density: 1900 kg/m3}]"), "poisson");
    says(soil("", "[{thickness: 6 km, shear_wave: 1 m/s, density: 1900 kg/m3, poisson: 0.3}]"),
         "highest_frequency");
}

TEST(BoundaryCase, SaysWhatIsWrong)
{
    const auto says = [](const std::string& text, const std::string& part,
                         const std::vector<std::string>& overrides = {}) {
        const std::string faults = faults_of(text, overrides);
        EXPECT_NE(faults.find(part), std::string::npos) << faults;
    };
    const std::string wave = ", incoming_wave: {x: {ricker: {acceleration: 1 m/s2, frequency: 2 Hz}}";
    says(ground(base, wave + "}"), "motion_is");
    says(ground(base, wave + ", motion_is: within}"), "waves that go up and others that come back");
    says(ground(base, wave + ", motion_is: surface}"), "expected outcrop or upgoing");
    says(ground("", wave + ", motion_is: outcrop}"), "a wave without a boundary");
    const std::string passes = wave + ", motion_is: outcrop, passes: {speed: 500 m/s, direction: [1, 0, 0]";
    says(ground(base, passes + ", from: [2, 0, 0]}}"), "at [1.5, 0.5, -2] 0.001 s before its motion begins");
    says(ground(base, wave + ", motion_is: outcrop, passes: {speed: 0 m/s, direction: [1, 0, 0]}}"), "speed");
    says(ground(base, wave + ", motion_is: outcrop, passes: {speed: 500 m/s, direction: [0, 0, 0]}}"), "length 0");
    says(ground(base, wave + ", motion_is: outcrop, boundary: basis}"), "did you mean base");
    says(ground(base, ""), "rigid blocks, in which no wave runs", {"kinematics=spatial_rigid"});
    says(ground("boundaries: [{blocks: soil, side: below}]\n", ""), "expected bottom, top, left");
    says(ground("boundaries: [{blocks: soil, side: [1, 1, 1]}]\n", ""), "looks that way");
    says(ground(base + "foundation: {blocks: soil}\n", ""), "a foundation or a boundary");
    says(ground("boundaries: [{blocks: soil, side: bottom}, {blocks: soil, side: [0, 0, -1]}]\n", ""),
         "in another boundary");
    says(ground(base, "", ""), "dashpots carry no weight");
    says(ground(base, "", "  - {name: rest, type: static" + wave + "}}\n"), "it belongs to dynamic stages");
    const std::string rest = "  - {name: rest, type: static}\n";
    says(ground(base, "", rest, ", rayleigh: {ratio: 0.05, at: [8 Hz, 1 Hz]}"), "ascending order");
    says(ground(base, "", rest, ", rayleigh: {ratio: [0.05, 0.001], at: [1 Hz, 8 Hz]}"), "negative share");
    says(ground(base, "", rest, ", rayleigh: {ratio: 5}"), "must be");
    says(ground(base, "", rest, ", hysteretic: {ratio: 5, band: [1 Hz, 8 Hz]}"), "must be");
    says(ground(base, "", rest, ", hysteretic: {ratio: 0, band: [1 Hz, 8 Hz]}"), "must be");
    says(ground(base, "", rest, ", hysteretic: {ratio: 0.05}"), "band");
    says(ground(base, "", rest, ", hysteretic: {ratio: 0.05, band: [8 Hz, 1 Hz]}"),
         "the lower and the higher one");
    says(ground(base, "", rest, ", hysteretic: {ratio: 0.05, band: [8 Hz]}"), "the lower and the higher one");
    says(ground("", "", "", ", hysteretic: {ratio: 0.05, band: [1 Hz, 8 Hz]}"),
         "rigid blocks, which are not strained", {"kinematics=spatial_rigid"});
}

}  // namespace voussoir::app::reader
