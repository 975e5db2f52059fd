// Bridges of several spans from a case file.
#include <cmath>
#include <ctime>
#include <numbers>

#include "app/studies/verify/limit_masonry.h"
#include "libdda/limit/balance.h"
#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

const std::string keys =
    "spans: 2, span: 6 m, rise: 3 m, thickness: 0.6 m, voussoirs: 17, width: 3 m, stones_across: 2, "
    "block: [1 m, 0.5 m], pier_width: 2 m, pier_height: 2 m, abutment_length: 2 m";
const std::string walls = ", spandrel_thickness: 0.5 m, cover: 0.4 m";

std::string bridge(const std::string& more)
{
    return "bridge: {" + keys + more + "}";
}

TEST(BridgePattern, HasTheNamesAndGroupsOfMasonry)
{
    const Model model = read_pattern(bridge(walls + ", cutwater: 0.8 m, backing: 1 m, fill: blocks, "
                                                    "parapet: {height: 0.8 m, thickness: 0.3 m}"))
                            .model;
    for (const auto& [name, group] :
         std::vector<std::pair<std::string, std::string>>{{"abutment_left", "foundation"},
                                                          {"pier_1_slab", "foundation"},
                                                          {"pier_1_c01_b01", "pier"},
                                                          {"pier_1_impost_b01", "pier"},
                                                          {"pier_1_cutwater_south", "pier"},
                                                          {"arch_1_voussoir_01_b01", "voussoirs"},
                                                          {"arch_2_keystone_b02", "voussoirs"},
                                                          {"spandrel_south_2_c01_b01", "spandrel"},
                                                          {"backing_2_c01_b01", "backing"},
                                                          {"fill_1_c05_b01", "fill"},
                                                          {"parapet_north_b01", "parapet"}})
        EXPECT_EQ(group_of(model, name), group) << name;
    expect_sound(assembly_of(model));
}

/// The walls, the fill and the arches leave no room: all of the bridge above its springings is stone.
TEST(BridgePattern, FillsItsOutline)
{
    const Model model = read_pattern(bridge(walls + ", fill: blocks")).model;
    const double road = 3.6 * std::sin((8.0 / 17 + 0) * std::numbers::pi) +
                        0.4;  // the keystone's joints end at the level of the crown
    const double length = 2 * 6 + 2 + 2 * 2, step = std::numbers::pi / 17;
    const double openings = 2 * 17 * 0.5 * 9 * std::sin(step);
    double volume = 0;
    for (const char* group : {"voussoirs", "spandrel", "backing", "fill"}) volume += volume_in(model, group);
    EXPECT_NEAR(volume, 3 * (length * road - openings), 1e-6);
    EXPECT_NEAR(volume_in(model, "pier"), 2 * 3 * 2, 1e-9);
    const Model open = read_pattern(bridge("")).model;
    EXPECT_EQ(count_in(open, "spandrel") + count_in(open, "fill"), 0);
    EXPECT_EQ(volume_in(open, "voussoirs"), volume_in(model, "voussoirs"));
}

TEST(BridgePattern, FillAsMassWeighsWhatItsBlocksWould)
{
    for (const std::string backing : {"", ", backing: 1.2 m"}) {
        const Model blocks = read_pattern(bridge(walls + backing + ", fill: blocks")).model;
        const Model masses =
            read_pattern(bridge(walls + backing + ", fill: mass, fill_density: 2000 kg/m3")).model;
        double attached = 0;
        for (const Block& block : masses.blocks) attached += block.attached_mass;
        EXPECT_NEAR(attached, 2000 * volume_in(blocks, "fill"), 1e-3) << backing;
        EXPECT_EQ(volume_in(blocks, "backing"), volume_in(masses, "backing"));
    }
}

TEST(BridgePattern, CutwatersArePrismsWithHoods)
{
    const Model with = read_pattern(bridge(", cutwater: 0.8 m")).model, without = read_pattern(bridge("")).model;
    // Triangles of 2 m x 0.8 m / 2 beside courses up to the impost of 0.5 m, and pyramids of 0.5 m on them.
    EXPECT_NEAR(volume_in(with, "pier") - volume_in(without, "pier"), 2 * 0.8 * 1.5 + 2 * 0.8 * 0.5 / 3, 1e-9);
}

TEST(BridgePattern, JointsHaveTheirAreas)
{
    const auto assembly = assembly_of(read_pattern(bridge(walls)).model);
    expect_sound(assembly);
    // A springing bears half the width: stones of 1.5 m on 0.6 m.
    double bears = 0;
    for (const auto& contact : assembly.contacts) {
        const std::string &a = assembly.stones[contact.a].name, &b = assembly.stones[contact.b].name;
        if (a == "abutment_left" && b.starts_with("arch_1_voussoir_01")) bears += contact.area;
    }
    EXPECT_NEAR(bears, 0.6 * 3, 1e-7);
    EXPECT_NEAR(joint_area(assembly, "spandrel_south_1_c01_b01", "abutment_left"), 0.5 * 1.4, 0.36);
}

TEST(BridgePattern, IsSymmetricWithoutBond)
{
    // Joints of running bond are mirror images, for courses are divided from end to end.
    expect_symmetric(read_pattern(bridge(walls + ", cutwater: 0.8 m")).model, 1);
    expect_symmetric(read_pattern(bridge(walls + ", cutwater: 0.8 m")).model, 0);
}

TEST(BridgePattern, Rests)
{
    const std::string small =
        "spans: 2, span: 4 m, rise: 1.5 m, thickness: 0.6 m, voussoirs: 11, width: 2 m, "
        "stones_across: 1, block: [1 m, 0.5 m], pier_width: 1.8 m, pier_height: 1.5 m, "
        "abutment_length: 1.5 m, spandrel_thickness: 0.5 m, cover: 0.3 m, fill: ";
    for (const char* fill : {"mass", "blocks"})
        expect_rest(read_pattern("bridge: {" + small + fill + "}", {"kinematics=spatial_rigid"}));
}

std::string bare(double thickness)
{
    return "bridge: {span: 6 m, rise: 3 m, voussoirs: 17, width: 1 m, stones_across: 1, block: [1 m, 0.4 m], "
           "thickness: " +
           std::to_string(thickness) + " m}";
}

TEST(BridgePattern, StandsAndFallsAsTheLinearProgramSays)
{
    using namespace studies::verify;
    const std::vector<std::string> rigid{"kinematics=spatial_rigid", "stages[1]=null"};
    const auto by_program = [&](double thickness) {
        return limit::balance_of(limit_problem(read_pattern(bare(thickness), rigid).model)).standing ==
               limit::Standing::balanced;
    };
    double falls = 0.1, stands = 0.8;
    ASSERT_TRUE(by_program(stands));
    ASSERT_FALSE(by_program(falls));
    while (stands / falls > 1.002) {
        const double middle = (stands + falls) / 2;
        (by_program(middle) ? stands : falls) = middle;
    }
    const auto by_engine = [&](double thickness) {
        return run_to_rest(read_pattern(bare(thickness), rigid)).report.outcome == Outcome::completed;
    };
    EXPECT_TRUE(by_engine(stands * 1.004)) << stands;
    EXPECT_FALSE(by_engine(falls * 0.996)) << falls;
}

TEST(BridgePattern, OfTwoThousandStonesIsMadeAndCheckedInSeconds)
{
    const std::clock_t start = std::clock();
    const Model model =
        read_pattern(
            "bridge: {spans: 3, span: 12 m, rise: 4 m, thickness: 0.8 m, voussoirs: 35, width: 6 m, "
            "stones_across: 7, block: [0.8 m, 0.4 m], pier_width: 3 m, pier_height: 4 m, cutwater: 1.2 m, "
            "spandrel_thickness: 0.6 m, backing: 1.5 m, cover: 0.4 m, "
            "parapet: {height: 1 m, thickness: 0.4 m}, fill: mass}")
            .model;
    const auto assembly = assembly_of(model);
    EXPECT_GT(model.blocks.size(), 2000U);
    EXPECT_LT(model.blocks.size(), 4000U);
    EXPECT_TRUE(assembly.overlaps.empty());
    EXPECT_TRUE(assembly.unsupported.empty());
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10);
}

/// Area under the chords of a circular intrados above its springing [m2].
double opening_of(double span, double rise, int voussoirs)
{
    const double half = span / 2, radius = (half * half + rise * rise) / (2 * rise);
    const double angle = 4 * std::atan(rise / half);  // at the centre
    return voussoirs * 0.5 * radius * radius * std::sin(angle / voussoirs) - half * (radius - rise);
}

std::string unequal(const std::string& spans, const std::string& more)
{
    return "bridge: {spans: [" + spans +
           "], thickness: 0.6 m, width: 3 m, stones_across: 2, block: [1 m, 0.5 m], pier_width: 2.4 m, "
           "pier_height: 2 m, abutment_length: 2 m, spandrel_thickness: 0.5 m, cover: 0.4 m" +
           more + "}";
}

/// How high a block is [m].
double height_of(const Block& block)
{
    double low = 1e300, high = -1e300;
    for (const Eigen::Vector3d& x : block.parts[0].vertices) {
        low = std::min(low, x.z());
        high = std::max(high, x.z());
    }
    return high - low;
}

/// All of it is stone up to the road but the openings, whatever the shapes of the arches.
TEST(BridgePattern, OfUnequalSpansFillsItsOutline)
{
    struct Spans {
        std::string written;
        double open, spanned;  // m2, m
        int piers;
    };
    for (const Spans& spans :
         {Spans{"{span: 4 m, voussoirs: 11}, {span: 6 m, voussoirs: 17}, {span: 4 m, voussoirs: 11}",
                2 * opening_of(4, 2, 11) + opening_of(6, 3, 17), 14, 2},
          Spans{"{span: 5 m, rise: 1.4 m, voussoirs: 13}, {span: 7 m, rise: 2.6 m, voussoirs: 17}",
                opening_of(5, 1.4, 13) + opening_of(7, 2.6, 17), 12, 1}}) {
        SCOPED_TRACE(spans.written);
        const Model model = read_pattern(unequal(spans.written, ", backing: 0.9 m, fill: blocks")).model;
        double volume = 0, road = 0;
        for (const Block& block : model.blocks) {
            if (!block.name.ends_with("_slab")) volume += block.moments.volume;
            road = std::max(road, (block.moments.centroid + model.origin).z() + height_of(block) / 2);
        }
        const double below = spans.piers * 2.4 + 2 * 2;  // m, of piers and abutments along the bridge
        EXPECT_NEAR(volume, 3 * ((spans.spanned + below) * road - spans.open + below * 2), 1e-6);
        expect_sound(assembly_of(model));
        expect_symmetric(model, 1);
        if (spans.piers == 2) expect_symmetric(model, 0);
    }
}

TEST(BridgePattern, OfUnequalSpansHasItsNamesAndJoints)
{
    const std::string spans = "{span: 4 m, voussoirs: 11}, {span: 6 m, voussoirs: 17}";
    const Model model = read_pattern(unequal(spans, ", parapet: {height: 0.8 m}, fill: mass")).model;
    for (const char* name : {"spandrel_north_4_c01_b01", "arch_1_keystone_b01", "arch_2_keystone_b01",
                             "pier_1_impost_b01", "parapet_north_b01"})
        number_of(model, name);
    // Regions 2 and 3 stand on one pier, on one bed, and meet over its middle.
    const auto assembly = assembly_of(model);
    double meet = 0;
    for (const auto& contact : assembly.contacts) {
        const std::string &a = assembly.stones[contact.a].name, &b = assembly.stones[contact.b].name;
        if (a.starts_with("spandrel_south_2_c01") && b.starts_with("spandrel_south_3_c01")) meet += contact.area;
    }
    EXPECT_NEAR(meet,
                0.5 * std::min(height_of(block_of(model, "spandrel_south_2_c01_b01")),
                               height_of(block_of(model, "spandrel_south_3_c01_b01"))),
                1e-7);
    // Fill as mass weighs what its blocks would.
    double attached = 0;
    for (const Block& block : model.blocks) attached += block.attached_mass;
    EXPECT_NEAR(attached, 1800 * volume_in(read_pattern(unequal(spans, ", fill: blocks")).model, "fill"), 1e-3);
}

TEST(BridgePattern, OfEqualSpansIsThatOfTheirNumber)
{
    const Model list = read_pattern(unequal("{}, {}", ", span: 6 m, voussoirs: 17, cutwater: 0.6 m")).model;
    const Model number =
        read_pattern(with(unequal("2", ", span: 6 m, voussoirs: 17, cutwater: 0.6 m"), "[2]", "2")).model;
    ASSERT_EQ(list.blocks.size(), number.blocks.size());
    for (std::size_t b = 0; b < list.blocks.size(); ++b) {
        EXPECT_EQ(list.blocks[b].name, number.blocks[b].name);
        EXPECT_EQ(list.blocks[b].moments.volume, number.blocks[b].moments.volume);
        EXPECT_EQ(list.blocks[b].moments.centroid, number.blocks[b].moments.centroid);
    }
}

TEST(BridgePattern, OfUnequalSpansSaysWhichSpanIsWrong)
{
    const auto faults = [](const std::string& spans) {
        return reader::faults_of(pattern_case(unequal(spans, "")));
    };
    EXPECT_NE(faults("{span: 4 m, voussoirs: 11}, {span: 6 m, rise: 4 m, voussoirs: 17}")
                  .find("bridge.spans[1].rise: 4.000000 m; must be at most half the span"),
              std::string::npos)
        << faults("{span: 4 m, voussoirs: 11}, {span: 6 m, rise: 4 m, voussoirs: 17}");
    EXPECT_NE(faults("{span: 4 m, voussoirs: 11, width: 2 m}, {span: 6 m, voussoirs: 17}").find("unknown key"),
              std::string::npos);
    EXPECT_NE(faults("{span: 4 m}, {span: 6 m, voussoirs: 17}").find("voussoirs"), std::string::npos);
    EXPECT_NE(faults("").find("no arch"), std::string::npos) << faults("");
}

TEST(BridgePattern, SaysWhichKeyMakesNoBridge)
{
    const auto faults = [](const std::string& more) { return reader::faults_of(pattern_case(bridge(more))); };
    EXPECT_NE(faults(", fill: mass").find("no spandrel walls; fill and parapets need them"), std::string::npos)
        << faults(", fill: mass");
    EXPECT_NE(reader::faults_of(with(pattern_case(bridge("")), "rise: 3 m", "rise: 9 m"))
                  .find("bridge.rise: 9.000000 m; must be at most half the span"),
              std::string::npos);
    EXPECT_NE(reader::faults_of(with(pattern_case(bridge("")), "pier_width: 2 m", "pier_width: 1 m"))
                  .find("pier_width: 1.000000 m; the arches on both sides"),
              std::string::npos);
}

}  // namespace
}  // namespace voussoir::app::patterns_test
