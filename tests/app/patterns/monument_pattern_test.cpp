// Gates, buttresses, steps, obelisks and pinnacles from a case file.
#include <cmath>
#include <numbers>

#include "tests/app/patterns/limit_thickness.h"

namespace voussoir::app::patterns_test
{
namespace
{

constexpr double pi = std::numbers::pi;
const std::vector<std::string> rigid{"kinematics=spatial_rigid"};

std::string faults(const std::string& entry)
{
    return reader::faults_of(pattern_case(entry));
}

std::string obelisk(int stones, const std::string& more = "")
{
    return "obelisk: {height: 6 m, width: 1 m, top_width: 0.7 m, pyramidion: 0.8 m, stones: " +
           std::to_string(stones) + more + "}";
}

TEST(ObeliskPattern, HasTheVolumeOfAFrustumAndAPyramid)
{
    const double volume = 6 * (1 + 0.7 + 0.49) / 3 + 0.49 * 0.8 / 3;
    for (const int stones : {1, 4}) {
        const Model model = read_pattern(obelisk(stones, ", pedestal: {height: 0.8 m, width: 1.5 m}")).model;
        EXPECT_EQ(count_in(model, "shaft"), stones);
        EXPECT_NEAR(volume_in(model, "shaft"), volume, 1e-7);
        EXPECT_NEAR(volume_in(model, "pedestal"), 1.5 * 1.5 * 0.8, 1e-9);
        expect_symmetric(model, 0);
        expect_symmetric(model, 1);
        const auto assembly = assembly_of(model);
        expect_sound(assembly);
        EXPECT_NEAR(joint_area(assembly, "pedestal", "shaft_1"), 1, 1e-8);
        if (stones == 4) {
            EXPECT_NEAR(joint_area(assembly, "shaft_2", "shaft_3"), 0.85 * 0.85, 1e-7);
        }
    }
}

/// About its edge, where push / weight = half its width / the height of its centroid.
TEST(ObeliskPattern, RestsAndOverturnsWhereStaticsSays)
{
    expect_rest(read_pattern(obelisk(4, ", pedestal: {height: 0.8 m, width: 1.5 m}")));
    const Model model = read_pattern(obelisk(1)).model;
    const double push = 0.5 / (block_of(model, "shaft_1").moments.centroid + model.origin).z();
    EXPECT_TRUE(stands(obelisk(1), pushed(0.995 * push)));
    EXPECT_FALSE(stands(obelisk(1), pushed(1.005 * push)));
}

TEST(ObeliskPattern, SaysWhichKeyMakesNone)
{
    EXPECT_NE(faults("obelisk: {height: 6 m, width: 1 m, top_width: 1.2 m}").find("obelisk.top_width: 1.200000 m"),
              std::string::npos);
    EXPECT_NE(faults("obelisk: {height: 2 m, width: 1 m, top_width: 0.2 m, pyramidion: 3 m}").find("no shoulder"),
              std::string::npos);
    EXPECT_NE(faults("obelisk: {height: 6 m, width: 1 m, pedestal: {height: 1 m, width: 0.5 m}}")
                  .find("obelisk.pedestal.width"),
              std::string::npos);
}

const std::string pinnacle = "pinnacle: {width: 0.6 m, height: 1.2 m, courses: 3, spire: 2.1 m, spire_stones: 3}";

TEST(PinnaclePattern, IsAShaftAndAnOctagonalPyramid)
{
    const Model model = read_pattern(pinnacle).model;
    EXPECT_EQ(model.blocks.size(), 1U + 3 + 3);
    EXPECT_NEAR(volume_in(model, "shaft"), 0.36 * 1.2, 1e-9);
    const double octagon = 2 * std::tan(pi / 8) * 0.36;
    EXPECT_NEAR(volume_in(model, "spire"), octagon * 2.1 / 3, 1e-8);
    expect_symmetric(model, 0);
    expect_symmetric(model, 1);
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    EXPECT_NEAR(joint_area(assembly, "shaft_3", "spire_1"), octagon, 1e-8);
    EXPECT_NEAR(joint_area(assembly, "spire_1", "spire_2"), octagon * 4 / 9, 1e-8);
    expect_rest(read_pattern(pinnacle));
    EXPECT_NE(faults("pinnacle: {width: 0.6 m, height: 1.2 m}").find("spire"), std::string::npos);
}

/// All of it about the edge of the lowest course, where push / weight = half the width / the height of its
/// centroid.
TEST(PinnaclePattern, OverturnsWhereStaticsSays)
{
    const Model model = read_pattern(pinnacle).model;
    double volume = 0, moment = 0;
    for (const Block& block : model.blocks) {
        if (block.name == "slab") continue;
        volume += block.moments.volume;
        moment += block.moments.volume * (block.moments.centroid + model.origin).z();
    }
    const double push = 0.3 / (moment / volume);
    EXPECT_TRUE(stands(pinnacle, pushed(0.995 * push)));
    EXPECT_FALSE(stands(pinnacle, pushed(1.005 * push)));
}

const std::string steps = "steps: {number: 4, rise: 0.18 m, going: 0.3 m, width: 3 m, landing: 0.9 m}";

TEST(StepsPattern, AreCoursesThatBearOnEachOther)
{
    const Model model = read_pattern(steps).model;
    // 1.8, 1.5, 1.2 and 0.9 m deep.
    EXPECT_NEAR(volume_in(model, "steps"), 3 * 0.18 * (1.8 + 1.5 + 1.2 + 0.9), 1e-8);
    // Rows of 0.45 m or more: four, three, two, two, of three stones, or of two between halves.
    EXPECT_EQ(count_in(model, "steps"), (3 + 4 + 3 + 4) + (4 + 3 + 4) + (3 + 4) + (4 + 3));
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    double beds = 0;
    for (const auto& contact : assembly.contacts)
        if (std::abs(contact.normal.z()) > 0.99) beds += contact.area;
    EXPECT_NEAR(beds, 3 * (1.8 + 1.5 + 1.2 + 0.9), 1e-7);
    expect_symmetric(model, 1);
    expect_rest(read_pattern(steps, rigid));
    EXPECT_NE(faults("steps: {number: 4, width: 3 m, going: 0.3 m, landing: 0.2 m}").find("steps.landing: 0.2"),
              std::string::npos);
    EXPECT_NE(faults("steps: {number: 4, width: 3 m, going: 0.3 m, depth: 0.3 m}").find("must be more than going"),
              std::string::npos);
    EXPECT_NE(faults("steps: {width: 3 m}").find("number"), std::string::npos);
}

/// The beds of two steps slide where push / weight is the coefficient of friction, forward and backward.
TEST(StepsPattern, SlideWhereStaticsSays)
{
    const std::string two = "steps: {number: 2, rise: 0.18 m, going: 0.3 m, width: 1 m, landing: 0.6 m}";
    const double push = std::tan(40 * pi / 180);
    for (const double side : {1.0, -1.0}) {
        EXPECT_TRUE(stands(two, pushed(0.995 * side * push))) << side;
        EXPECT_FALSE(stands(two, pushed(1.005 * side * push))) << side;
    }
}

const std::string buttress =
    "buttress: {width: 1 m, block: [0.8 m, 0.4 m], weathering: 50 deg, stages: [{height: 2 m, depth: 1.6 m}, "
    "{height: 1.6 m, depth: 0.9 m}]}";

TEST(ButtressPattern, StepsBackUnderSlopes)
{
    const Model model = read_pattern(buttress).model;
    const double slope = std::tan(50 * pi / 180), lower = 0.7 * slope, upper = 0.9 * slope;
    EXPECT_NEAR(volume_in(model, "buttress"), 1.6 * 2 + 0.9 * 1.6 + lower * (1.6 + 0.9) / 2 + upper * 0.9 / 2,
                1e-7);
    // Five courses of one stone between halves or of two, four of one, and a weathering each.
    EXPECT_EQ(count_in(model, "buttress"), 3 + 2 + 3 + 2 + 3 + 1 + 4 + 1);
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    EXPECT_NEAR(joint_area(assembly, "stage_1_weathering", "stage_2_c01_b01"), 0.9, 1e-8);
    EXPECT_NEAR(joint_area(assembly, "stage_2_c04_b01", "stage_2_weathering"), 0.9, 1e-8);
    expect_symmetric(model, 1);
    expect_rest(read_pattern(buttress));
    EXPECT_NE(faults(with(buttress, "depth: 0.9 m", "depth: 1.7 m")).find("buttress.stages[1].depth: 1.700000 m"),
              std::string::npos)
        << faults(with(buttress, "depth: 0.9 m", "depth: 1.7 m"));
    EXPECT_NE(faults(with(buttress, "50 deg", "90 deg")).find("buttress.weathering: 90 deg"), std::string::npos);
}

std::string flyer(double thickness, const std::string& more = ", pinnacle: 1.6 m")
{
    return "flying_buttress: {span: 4 m, thickness: " + std::to_string(thickness) +
           " m, voussoirs: 9, width: 0.6 m, block: [0.8 m, 0.4 m], pier: {depth: 1.8 m, height: 2 m}" + more + "}";
}

TEST(FlyingButtressPattern, IsHalfAnArchFromAWallToAPier)
{
    const Model model = read_pattern(flyer(0.5)).model;
    EXPECT_EQ(count_in(model, "voussoirs"), 9);
    EXPECT_NEAR(volume_in(model, "voussoirs"), 9 * 0.5 * std::sin(pi / 18) * (4.5 * 4.5 - 4 * 4) * 0.6, 1e-7);
    EXPECT_NEAR(volume_in(model, "pier"), 1.8 * 2 * 0.6, 1e-8);
    EXPECT_NEAR(volume_in(model, "pinnacle"), (1.8 - 0.5 - 0.1) * 1.6 * 0.6, 1e-7);
    EXPECT_EQ(group_of(model, "wall"), "foundation");
    expect_symmetric(model, 1);
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    EXPECT_NEAR(joint_area(assembly, "wall", "voussoir_01"), 0.5 * 0.6, 1e-7);
    EXPECT_NEAR(joint_area(assembly, "voussoir_09", "impost"), 0.5 * 0.6, 1e-7);
    expect_rest(read_pattern(flyer(0.6), rigid));
}

TEST(FlyingButtressPattern, SaysWhichKeyMakesNone)
{
    EXPECT_NE(faults(flyer(0.5, ", rise: 5 m")).find("flying_buttress.rise: 5.000000 m; must be at most the span"),
              std::string::npos)
        << faults(flyer(0.5, ", rise: 5 m"));
    EXPECT_NE(faults(flyer(2)).find("flying_buttress.pier.depth: 1.800000 m; the end of the arch and a stone"),
              std::string::npos)
        << faults(flyer(2));
    EXPECT_NE(faults(with(flyer(0.5), "pier: {depth: 1.8 m, height: 2 m}", "pier: {width: 1.8 m}")).find("depth"),
              std::string::npos);
}

std::string gate(double thickness, const std::string& more = "")
{
    return "gate: {span: 3 m, thickness: " + std::to_string(thickness) +
           " m, voussoirs: 13, depth: 1.2 m, block: [0.8 m, 0.4 m], pier: {width: 1.6 m, height: 2.4 m}, attic: "
           "0.6 "
           "m" +
           more + "}";
}

TEST(GatePattern, FillsItsOutline)
{
    const Model model = read_pattern(gate(0.5)).model;
    const double joint = 2.0 * std::sin(pi / 2 - pi / 26);  // the keystone's joints end at the level of the crown
    const double opening = 13 * 0.5 * std::sin(pi / 13) * 1.5 * 1.5;
    double volume = 0;
    for (const char* group : {"pier", "voussoirs", "wall"}) volume += volume_in(model, group);
    EXPECT_NEAR(volume, 1.2 * ((3 + 2 * 1.6) * (joint + 0.6) - opening + 2 * 1.6 * 2.4), 1e-6);
    EXPECT_NEAR(volume_in(model, "pier"), 1.2 * 2 * 1.6 * 2.4, 1e-7);
    EXPECT_EQ(count_in(model, "voussoirs"), 13);
    EXPECT_EQ(count_in(model, "foundation"), 2);
    EXPECT_EQ(group_of(model, "keystone"), "voussoirs");
    EXPECT_EQ(group_of(model, "attic_c01_b01"), "wall");
    expect_symmetric(model, 1);
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    EXPECT_NEAR(joint_area(assembly, "pier_left_impost", "voussoir_01"), 0.5 * 1.2, 1e-7);
    double slab = 0;
    for (const auto& contact : assembly.contacts)
        if (assembly.stones[contact.a].name == "slab_right" || assembly.stones[contact.b].name == "slab_right")
            slab += contact.area;
    EXPECT_NEAR(slab, 1.6 * 1.2, 1e-8);
    expect_rest(read_pattern(gate(0.5), rigid));
}

TEST(GatePattern, TakesEveryShapeOfArch)
{
    for (const char* shape : {", shape: pointed, rise: 2.4 m", ", shape: elliptic, rise: 1 m",
                              ", shape: polycentric, rise: 1.1 m", ", embrace: 140 deg"}) {
        SCOPED_TRACE(shape);
        const std::string entry = with(gate(0.5, shape), "voussoirs: 13", "voussoirs: 14");
        const Model model = read_pattern(entry).model;
        expect_sound(assembly_of(model));
        expect_symmetric(model, 1);
    }
}

TEST(GatePattern, SaysWhichKeyMakesNone)
{
    EXPECT_NE(faults(with(gate(0.5), "width: 1.6 m", "width: 0.5 m")).find("gate.pier.width: 0.500000 m; the end"),
              std::string::npos)
        << faults(with(gate(0.5), "width: 1.6 m", "width: 0.5 m"));
    const std::string thin =
        with(with(gate(0.05), "[0.8 m, 0.4 m]", "[1 m, 0.6 m]"), "voussoirs: 13", "voussoirs: 11");
    EXPECT_NE(faults(thin).find("gate.thickness: a voussoir with its stepped back would not be convex"),
              std::string::npos)
        << faults(thin);
    EXPECT_NE(faults(gate(0.5, ", shape: pointed, rise: 2.4 m")).find("an odd number in a pointed gate"),
              std::string::npos);
    EXPECT_NE(faults(with(gate(0.5), "pier: {width: 1.6 m, height: 2.4 m}, ", "")).find("pier"),
              std::string::npos);
}

TEST(FlyingButtressPattern, StandsAndFallsAtTheLimitThicknessOfTheLinearProgram)
{
    expect_limit_thickness([](double thickness) { return flyer(thickness); }, 0.2, 0.6);
}

}  // namespace
}  // namespace voussoir::app::patterns_test
