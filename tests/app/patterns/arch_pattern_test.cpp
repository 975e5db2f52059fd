// Arches of all shapes from a case file: what they are, and when they stand.
#include <cmath>
#include <numbers>

#include "app/studies/verify/limit_masonry.h"
#include "libdda/limit/limit_analysis.h"
#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

using limit::associated_limit;
using studies::verify::limit_problem;

const std::vector<std::string> shapes = {
    "shape: circular, rise: 3 m", "shape: circular, embrace: 120 deg", "shape: pointed, rise: 5 m",
    "shape: elliptic, rise: 2 m", "shape: polycentric, rise: 2.2 m",
};

std::string arch(const std::string& keys)
{
    return "arch: {span: 6 m, " + keys + "}";
}

TEST(ArchPattern, HasTheNamesGroupsAndCountOfMasonry)
{
    const Model model = read_pattern(arch("thickness: 0.6 m, voussoirs: 17")).model;
    ASSERT_EQ(model.blocks.size(), 19U);
    EXPECT_EQ(model.blocks[0].name, "springing_left");
    EXPECT_EQ(model.blocks[1].name, "voussoir_01");
    EXPECT_EQ(model.blocks[9].name, "keystone");
    EXPECT_EQ(model.blocks[18].name, "springing_right");
    EXPECT_EQ(group_of(model, "springing_left"), "foundation");
    EXPECT_EQ(group_of(model, "keystone"), "voussoirs");
    EXPECT_EQ(model.foundations.size(), 2U);
}

TEST(ArchPattern, IsSoundAndSymmetricInEveryShape)
{
    for (const std::string& shape : shapes)
        for (const char* number : {"16", "17"}) {
            SCOPED_TRACE(shape + ", " + number);
            const Model model =
                read_pattern(arch(shape + ", thickness: 0.6 m, width: 1.5 m, voussoirs: " + number)).model;
            expect_symmetric(model, 0);
            const auto assembly = assembly_of(model);
            expect_sound(assembly);
            // Every joint is the thickness wide; that in the crown of a pointed arch is steep, and longer.
            const bool has_apex = shape.find("pointed") != std::string::npos && number == std::string("16");
            EXPECT_EQ(assembly.contacts.size(), model.blocks.size() - 1);
            for (const auto& contact : assembly.contacts) {
                if (has_apex && assembly.stones[contact.a].name == "voussoir_08") continue;
                EXPECT_NEAR(contact.area, 0.6 * 1.5, 1e-7) << assembly.stones[contact.a].name;
            }
        }
}

/// Of a circle: n quadrilaterals between two radii, exact.
TEST(ArchPattern, HasTheVolumeOfItsChords)
{
    const int n = 17;
    const double inner = 3, outer = 3.6;
    const Model model = read_pattern(arch("thickness: 0.6 m, voussoirs: 17, width: 2 m, rise: 3 m")).model;
    const double step = std::numbers::pi / n;
    EXPECT_NEAR(volume_in(model, "voussoirs"), n * 0.5 * std::sin(step) * (outer * outer - inner * inner) * 2,
                1e-7);
    // An arc of three centres with rise = half the span is a semicircle, whatever its side arcs.
    const Model three = read_pattern(arch("shape: polycentric, side_arc: 50 deg, thickness: 0.6 m, voussoirs: 17, "
                                          "width: 2 m, rise: 3 m"))
                            .model;
    EXPECT_NEAR(volume_in(three, ""), volume_in(model, ""), 1e-6);
    const Model ellipse =
        read_pattern(arch("shape: elliptic, thickness: 0.6 m, voussoirs: 17, width: 2 m, rise: 3 m")).model;
    EXPECT_NEAR(volume_in(ellipse, ""), volume_in(model, ""), 1e-6);
}

/// Of the mean radius R: t = k R, R = 3 m + t / 2.
TEST(ArchPattern, TakesItsThicknessOverItsRadius)
{
    const auto volume = [](const std::string& keys) {
        return volume_in(read_pattern(arch(keys + ", voussoirs: 17, rise: 3 m")).model, "voussoirs");
    };
    const double thickness = 0.2 * 3 / (1 - 0.1);
    EXPECT_NEAR(volume("thickness_over_radius: 20 %"), volume("thickness: " + std::to_string(thickness) + " m"),
                1e-5);
    const double outer = 3 + thickness;
    EXPECT_NEAR(volume("thickness_over_radius: 20 %"),
                17 * 0.5 * std::sin(std::numbers::pi / 17) * (outer * outer - 9), 1e-7);
    const auto faults = [](const std::string& keys) {
        return reader::faults_of(pattern_case(arch("voussoirs: 9" + keys)));
    };
    EXPECT_NE(faults(", thickness: 0.5 m, thickness_over_radius: 10 %").find("give one of them"),
              std::string::npos);
    EXPECT_NE(faults(", shape: elliptic, thickness_over_radius: 10 %").find("not circular"), std::string::npos);
    EXPECT_NE(faults("").find("thickness: missing"), std::string::npos) << faults("");
}

TEST(ArchPattern, BondsStonesAcross)
{
    const Model model = read_pattern(arch("thickness: 0.6 m, voussoirs: 17, width: 2 m, stones_across: 2")).model;
    const Model whole = read_pattern(arch("thickness: 0.6 m, voussoirs: 17, width: 2 m")).model;
    EXPECT_EQ(count_in(model, "voussoirs"), 9 * 2 + 8 * 3);
    EXPECT_NEAR(volume_in(model, ""), volume_in(whole, ""), 1e-9);
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    expect_symmetric(model, 1);
    EXPECT_NEAR(joint_area(assembly, "voussoir_01_b01", "voussoir_02_b02"), 0.6 * 0.5, 1e-7);
}

TEST(ArchPattern, RestsInEveryShape)
{
    for (const std::string& shape : shapes) {
        SCOPED_TRACE(shape);
        expect_rest(read_pattern(arch(shape + ", thickness: 0.9 m, voussoirs: 15")));
    }
}

/// Whether a planar rigid arch stands, by the linear program, and by the engine.
bool stands_by_program(const std::string& keys)
{
    return associated_limit(limit_problem(read_pattern(arch(keys), {"kinematics=planar_rigid"}).model)).found;
}
bool stands_by_engine(const std::string& keys)
{
    const Case the_case = read_pattern(arch(keys), {"kinematics=planar_rigid", "stages[1]=null"});
    return run_to_rest(the_case).report.outcome == Outcome::completed;
}

std::string of_thickness(double thickness)
{
    return ", voussoirs: 15, thickness: " + std::to_string(thickness) + " m";
}

TEST(ArchPattern, StandsAndFallsAtTheLimitThicknessOfTheLinearProgram)
{
    for (const std::string& shape : shapes) {
        double falls = 0.02, stands = 1.2;
        ASSERT_TRUE(stands_by_program(shape + of_thickness(stands))) << shape;
        ASSERT_FALSE(stands_by_program(shape + of_thickness(falls))) << shape;
        while (stands / falls > 1.001) {
            const double middle = (stands + falls) / 2;
            (stands_by_program(shape + of_thickness(middle)) ? stands : falls) = middle;
        }
        EXPECT_TRUE(stands_by_engine(shape + of_thickness(stands * 1.004))) << shape << " at " << stands;
        EXPECT_FALSE(stands_by_engine(shape + of_thickness(falls * 0.996))) << shape << " at " << falls;
    }
}

TEST(ArchPattern, ImperfectStonesStayInTheirSpace)
{
    const std::string keys = "thickness: 0.9 m, voussoirs: 15, width: 2 m, stones_across: 3";
    const Case drawn = read_pattern(arch(keys));
    const std::string disturbed = keys + ", imperfection: {seed: 3, size: 2 %, position: 1, friction: 10 %}";
    const Case uneven = read_pattern(arch(disturbed));
    EXPECT_LT(volume_in(uneven.model, ""), volume_in(drawn.model, "") * 0.9975);
    EXPECT_GT(volume_in(uneven.model, ""), volume_in(drawn.model, "") * 0.98);
    EXPECT_TRUE(assembly_of(uneven.model).overlaps.empty());
    std::set<double> factors;
    for (const Block& block : uneven.model.blocks) factors.insert(block.friction_factor);
    EXPECT_GT(factors.size(), 40U);
    expect_rest(uneven);
    const Model again = read_pattern(arch(disturbed)).model;
    for (std::size_t b = 0; b < again.blocks.size(); ++b)
        EXPECT_EQ(again.blocks[b].moments.volume, uneven.model.blocks[b].moments.volume);
}

/// Stones of half a metre or a metre with joints of up to 10 mm are shorter by at most that.
TEST(ArchPattern, JointsHaveAThicknessOfTheirOwn)
{
    const std::string keys = "thickness: 0.9 m, voussoirs: 15, width: 2 m, stones_across: 2";
    const auto volumes = [&](const std::string& imperfection) {
        const Model model = read_pattern(arch(keys + imperfection)).model;
        EXPECT_TRUE(assembly_of(model).overlaps.empty());
        std::vector<double> all;
        for (const Block& block : model.blocks)
            if (model.groups[block.group] == "voussoirs") all.push_back(block.moments.volume);
        return all;
    };
    const std::vector<double> drawn = volumes(""), jointed = volumes(", imperfection: {seed: 3, joint: 10 mm}"),
                              sized = volumes(", imperfection: {seed: 3, size: 2 %}"),
                              both = volumes(", imperfection: {seed: 3, size: 2 %, joint: 10 mm}");
    const double section = drawn.front();  // of a stone of a metre, m2
    double largest = 0, least = 1;
    for (std::size_t b = 0; b < drawn.size(); ++b) {
        const double thickness = (drawn[b] - jointed[b]) / section;
        largest = std::max(largest, thickness);
        least = std::min(least, thickness);
        EXPECT_NEAR(sized[b] - both[b], drawn[b] - jointed[b], 1e-12) << "each draws its own";
    }
    EXPECT_GT(largest, 0.008);
    EXPECT_LE(largest, 0.01 + 1e-9);
    EXPECT_GE(least, 0);
    EXPECT_LT(least, 0.002);
}

TEST(ArchPattern, SaysWhichKeyMakesNoArch)
{
    const auto faults = [](const std::string& keys) { return reader::faults_of(pattern_case(arch(keys))); };
    EXPECT_NE(
        faults("thickness: 0.5 m, voussoirs: 15, rise: 4 m").find("arch.rise: 4.000000 m; must be at most half"),
        std::string::npos)
        << faults("thickness: 0.5 m, voussoirs: 15, rise: 4 m");
    EXPECT_NE(faults("thickness: 0.5 m, voussoirs: 15, rise: 1 m, embrace: 90 deg").find("both rise and embrace"),
              std::string::npos);
    EXPECT_NE(faults("thickness: 0.5 m").find("voussoirs"), std::string::npos);
    EXPECT_NE(faults("thickness: 0.5 m, voussoirs: 15, keystones: 2").find("unknown key"), std::string::npos);
}

}  // namespace
}  // namespace voussoir::app::patterns_test
