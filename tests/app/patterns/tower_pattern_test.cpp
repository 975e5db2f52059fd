// Towers from a case file: square, octagonal and round.
#include <cmath>
#include <ctime>
#include <numbers>

#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

std::string tower(const std::string& plan, const std::string& storeys, const std::string& more = "")
{
    return "tower: {plan: " + plan + ", width: 6 m, block: [0.8 m, 0.4 m], storeys: [" + storeys + "]" + more +
           "}";
}

const std::vector<std::string> plans = {"square", "octagonal", "round"};
const std::string two_storeys =
    "{height: 2.4 m, thickness: 0.8 m, openings: [{side: east, width: 0.6 m, height: 1.6 m}]}, "
    "{name: belfry, height: 2.4 m, thickness: 0.6 m, floor: 6 t}";

/// Area of the plan of a wall between regular polygons, and between the chords of stones.
double plan_area(const std::string& plan, double width, double thickness)
{
    if (plan == "round") {
        const int stones = static_cast<int>(std::lround(std::numbers::pi * width / 0.8));
        const double outer = width / 2, inner = outer - thickness;
        return stones * 0.5 * std::sin(2 * std::numbers::pi / stones) * (outer * outer - inner * inner);
    }
    const int sides = plan == "square" ? 4 : 8;
    const double tangent = std::tan(std::numbers::pi / sides), outer = width / 2, inner = outer - thickness;
    return sides * tangent * (outer * outer - inner * inner);
}

TEST(TowerPattern, HasTheVolumeOfItsPlan)
{
    for (const std::string& plan : plans) {
        const Model model = read_pattern(tower(plan,
                                               "{height: 2.4 m, thickness: 0.8 m}, "
                                               "{name: belfry, height: 1.2 m, thickness: 0.6 m}"))
                                .model;
        EXPECT_NEAR(volume_in(model, "storey_1"), 2.4 * plan_area(plan, 6, 0.8), 1e-6) << plan;
        EXPECT_NEAR(volume_in(model, "belfry"), 1.2 * plan_area(plan, 6, 0.6), 1e-6) << plan;
        EXPECT_EQ(count_in(model, "foundation"), 1);
        // Courses of 0.4 m, the number of stones to a course by their length between the corners.
        const int sides = plan == "square" ? 4 : 8;
        const double corner = 0.8 * std::tan(std::numbers::pi / sides);
        const int each =
            plan == "round"
                ? static_cast<int>(std::lround(6 * std::numbers::pi / 0.8))
                : sides *
                      static_cast<int>(std::lround((6 * std::tan(std::numbers::pi / sides) - 2 * corner) / 0.8));
        EXPECT_EQ(count_in(model, "storey_1"), 6 * each) << plan;
    }
}

TEST(TowerPattern, IsSoundWithOpenings)
{
    for (const std::string& plan : plans) {
        SCOPED_TRACE(plan);
        const Case the_case = read_pattern(tower(plan, two_storeys));
        const auto assembly = assembly_of(the_case.model);
        expect_sound(assembly);
        EXPECT_EQ(group_of(the_case.model, "storey_1_lintel_1"), "storey_1");
        double floor = 0;
        for (const Block& block : the_case.model.blocks) floor += block.attached_mass;
        EXPECT_NEAR(floor, 6000, 1e-9);
    }
}

TEST(TowerPattern, OpeningTakesItsVolume)
{
    const Model whole = read_pattern(tower("square", "{height: 2.4 m, thickness: 0.8 m}")).model;
    const Model open = read_pattern(tower("square",
                                          "{height: 2.4 m, thickness: 0.8 m, openings: "
                                          "[{side: west, width: 0.6 m, height: 1.6 m}]}"))
                           .model;
    EXPECT_NEAR(volume_in(whole, "") - volume_in(open, ""), 0.6 * 1.6 * 0.8, 1e-7);
    const Block& lintel = block_of(open, "storey_1_lintel_1");
    EXPECT_NEAR(lintel.moments.volume, (0.6 + 2 * 0.4) * 0.4 * 0.8, 1e-7);
    EXPECT_NEAR(lintel.moments.centroid.x(), -2.6, 1e-7);
    EXPECT_NEAR(lintel.moments.centroid.z(), 1.8, 1e-7);
}

/// A quarter turn brings a square tower onto itself, and every bed bears the whole plan.
TEST(TowerPattern, BedsBearTheWholePlan)
{
    for (const std::string plan : {"square", "octagonal"}) {
        const Model model = read_pattern(tower(plan, "{height: 1.2 m, thickness: 0.8 m}")).model;
        const auto assembly = assembly_of(model);
        double beds = 0;
        for (const auto& contact : assembly.contacts)
            if (std::abs(contact.normal.z()) > 0.99) beds += contact.area;
        EXPECT_NEAR(beds, 3 * plan_area(plan, 6, 0.8), 1e-5) << plan;  // on the slab and two beds
        for (const Block& block : model.blocks) {
            const Eigen::Vector3d turned(-block.moments.centroid.y(), block.moments.centroid.x(),
                                         block.moments.centroid.z());
            bool found = false;
            for (const Block& other : model.blocks)
                found = found || (other.moments.centroid - turned).norm() < 1e-7;
            EXPECT_TRUE(found) << block.name;
        }
    }
}

TEST(TowerPattern, CornerStonesAreBonded)
{
    const Model model = read_pattern(tower("square", "{height: 0.8 m, thickness: 0.8 m}")).model;
    int bent = 0;
    for (const Block& block : model.blocks) bent += block.parts.size() == 2;
    EXPECT_EQ(bent, 2 * 4);
    const auto assembly = assembly_of(model);
    // No joint runs through two courses: no stone lies on one alone.
    for (std::size_t upper = 0; upper < assembly.stones.size(); ++upper) {
        if (assembly.stones[upper].name.find("_c02_") == std::string::npos) continue;
        int below = 0;
        for (const auto& contact : assembly.contacts)
            below += std::abs(contact.normal.z()) > 0.99 &&
                     (contact.a == static_cast<int>(upper) || contact.b == static_cast<int>(upper));
        EXPECT_GE(below, 2) << assembly.stones[upper].name;
    }
}

TEST(TowerPattern, Rests)
{
    for (const std::string& plan : plans) {
        SCOPED_TRACE(plan);
        expect_rest(read_pattern(tower(plan, two_storeys), {"kinematics=spatial_rigid"}));
    }
}

/// Statics: a tower under a steady push along x overturns about its edge when the push is width / height of its
/// weight, for its centroid is at half its height.
TEST(TowerPattern, OverturnsWhereStaticsSays)
{
    const std::string slender =
        "tower: {width: 2 m, block: [0.8 m, 0.5 m], storeys: [{height: 8 m, thickness: 0.5 m}]}";
    const std::vector<std::string> rigid{"kinematics=spatial_rigid", "stages[1]=null",
                                         "joints.dry.friction=60 deg"};
    const auto stands = [&](double share) {
        std::vector<std::string> pushed = rigid;
        pushed.push_back("gravity={direction: [" + std::to_string(share) + ", 0, -1]}");
        return run_to_rest(read_pattern(slender, pushed)).report.outcome == Outcome::completed;
    };
    EXPECT_TRUE(stands(0.25 * 0.9));
    EXPECT_FALSE(stands(0.25 * 1.01));
}

TEST(TowerPattern, OfFiveThousandStonesIsMadeAndCheckedInSeconds)
{
    const std::clock_t start = std::clock();
    const Model model = read_pattern(
                            "tower: {width: 10 m, block: [0.7 m, 0.3 m], storeys: [{height: 17 m, "
                            "thickness: 1.2 m}, {height: 17 m, thickness: 0.9 m}]}")
                            .model;
    const auto assembly = assembly_of(model);
    EXPECT_GT(model.blocks.size(), 5000U);
    EXPECT_TRUE(assembly.overlaps.empty());
    EXPECT_TRUE(assembly.unsupported.empty());
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10);
}

TEST(TowerPattern, SaysWhichKeyMakesNoTower)
{
    const auto faults = [](const std::string& storeys) {
        return reader::faults_of(pattern_case(tower("square", storeys)));
    };
    const std::string wide = faults("{height: 3 m, thickness: 0.8 m, openings: [{width: 4 m, height: 1 m}]}");
    EXPECT_NE(
        wide.find("storeys[0].openings[0].width: 4.000000 m; with its lintel it must fit between the corners"),
        std::string::npos)
        << wide;
    EXPECT_NE(faults("{height: 3 m, thickness: 2.9 m}").find("storeys[0].thickness: 2.9"), std::string::npos)
        << faults("{height: 3 m, thickness: 2.9 m}");
    EXPECT_NE(faults("").find("storeys: none"), std::string::npos) << faults("");
}

}  // namespace
}  // namespace voussoir::app::patterns_test
