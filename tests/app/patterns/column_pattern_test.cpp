// Multidrum columns and temple fronts from a case file.
#include <cmath>
#include <numbers>

#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

const std::string column =
    "column: {height: 6 m, diameter: 1 m, top_diameter: 0.8 m, drums: 6, sides: 16, capital: {height: 0.6 m, "
    "width: 1.2 m}}";
const std::string front =
    "temple_front: {columns: 4, spacing: 2.5 m, height: 5 m, diameter: 1 m, top_diameter: 0.8 m, drums: 5, "
    "capital: {height: 0.6 m, width: 1.2 m}, architrave: 0.7 m, frieze: 0.7 m, pediment: 1.5 m, depth: 0.9 m}";

/// Area of a regular outline over the square of its width across the flats.
double shape_area(int sides)
{
    return sides * std::tan(std::numbers::pi / sides) / 4;
}

TEST(ColumnPattern, HasTheVolumeOfItsFrusta)
{
    const Model model = read_pattern(column).model;
    EXPECT_EQ(model.blocks.size(), 1U + 6 + 2);
    // A straight shaft is one frustum, however it is cut.
    EXPECT_NEAR(volume_in(model, "drums"), shape_area(16) * 6 / 3 * (1 + 0.8 + 0.64), 1e-7);
    EXPECT_NEAR(block_of(model, "abacus").moments.volume, 1.2 * 1.2 * 0.3, 1e-9);
    EXPECT_NEAR(block_of(model, "echinus").moments.volume, shape_area(16) * 0.3 / 3 * (0.64 + 0.8 * 1.2 + 1.44),
                1e-7);
    const Model swollen = read_pattern(with(column, "drums: 6", "entasis: 2 cm, drums: 6")).model;
    EXPECT_GT(volume_in(swollen, "drums"), volume_in(model, "drums") * 1.02);
}

TEST(ColumnPattern, IsSoundSymmetricAndBearsOnItsWholePlan)
{
    const Model model = read_pattern(column).model;
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    expect_symmetric(model, 0);
    expect_symmetric(model, 1);
    ASSERT_EQ(assembly.contacts.size(), 8U);
    EXPECT_NEAR(joint_area(assembly, "slab", "drum_1"), shape_area(16), 1e-7);
    EXPECT_NEAR(joint_area(assembly, "drum_3", "drum_4"), shape_area(16) * 0.81, 1e-7);
    EXPECT_NEAR(joint_area(assembly, "echinus", "abacus"), shape_area(16) * 1.44, 1e-7);
}

TEST(ColumnPattern, Rests)
{
    expect_rest(read_pattern(column));
    expect_rest(read_pattern(column, {"kinematics=spatial_rigid"}));
}

/// Statics: a monolithic shaft of one width overturns about its edge where push / weight = width / height.
TEST(ColumnPattern, OverturnsWhereStaticsSays)
{
    const std::string shaft = "column: {height: 8 m, diameter: 1 m, drums: 1, sides: 4}";
    const auto stands = [&](double push) {
        return run_to_rest(read_pattern(shaft, {"kinematics=spatial_rigid", "stages[1]=null",
                                                "gravity={direction: [" + std::to_string(push) + ", 0, -1]}"}))
                   .report.outcome == Outcome::completed;
    };
    EXPECT_TRUE(stands(0.125 * 0.995));
    EXPECT_FALSE(stands(0.125 * 1.005));
}

/// A square shaft of three drums whose joints are doweled, under its weight and `push` of it along x.
bool doweled_shaft_stands(double width, double height, double cohesion, double tension, double push)
{
    const std::string shaft = "column: {height: " + std::to_string(height) +
                              " m, diameter: " + std::to_string(width) + " m, drums: 3, sides: 4}";
    const std::string dowels = "{friction: 35 deg, cohesion: " + std::to_string(cohesion) +
                               " Pa, tensile_strength: " + std::to_string(tension) + " Pa}";
    const std::vector<std::string> overrides{
        "kinematics=spatial_rigid",
        "stages[1]=null",
        "joints={dry: {friction: 35 deg}, doweled: " + dowels + "}",
        "default_joint=dry",
        "joint_rules=[{between: [drums, drums], joint: doweled}, {between: [foundation, drums], joint: doweled}]",
        "gravity={direction: [" + std::to_string(push) + ", 0, -1]}"};
    return run_to_rest(read_pattern(shaft, overrides)).report.outcome == Outcome::completed;
}

/// Statics: the joint that bears most, on the slab, slides where push N = mu N + V, V the shear at which the
/// dowels of a joint yield; drums further up have as many dowels and less to hold.
TEST(ColumnPattern, DoweledDrumsSlideWhereTheirSteelYields)
{
    constexpr double width = 3, height = 0.9;      // m; 0.9 * 0.45 m < 3 m / 6: the resultant stays in the kern
    constexpr double steel = 2e-4, yield = 240e6;  // m2 in each joint, Pa
    const double dowels = steel * yield / std::sqrt(3.0);  // N
    const double mu = std::tan(35 * std::numbers::pi / 180);
    const double weight = 2400 * 9.80665 * width * width * height;
    double limit = mu;
    for (int i = 0; i < 100; ++i) limit = mu + dowels / weight * std::hypot(limit, 1.0);
    ASSERT_GT(limit, 1.2 * mu);
    ASSERT_LT(limit * height / 2, width / 6);
    const double cohesion = dowels / (width * width);
    EXPECT_TRUE(doweled_shaft_stands(width, height, cohesion, 0, limit * 0.995));
    EXPECT_FALSE(doweled_shaft_stands(width, height, cohesion, 0, limit * 1.005));
    EXPECT_TRUE(doweled_shaft_stands(width, height, 0, 0, mu * 0.995));
    EXPECT_FALSE(doweled_shaft_stands(width, height, 0, 0, mu * 1.005));
}

/// Statics: dowels that hold tension carry the shaft beyond push = width / height, to where the linear stress at
/// the edge is their strength: 6 M / width^3 - N / width^2, M = push N height / 2.
TEST(ColumnPattern, DowelsThatHoldTensionCarryBeyondOverturning)
{
    constexpr double height = 4, limit = 0.35;  // dry it overturns at 0.25
    const double normal = 2400 * 9.80665 * height / std::hypot(limit, 1.0);
    const double tension = normal * (3 * limit * height - 1);
    EXPECT_TRUE(doweled_shaft_stands(1, height, tension, tension, limit * 0.995));
    EXPECT_FALSE(doweled_shaft_stands(1, height, tension, tension, limit * 1.005));
}

/// A square shaft of three drums with a bar in each joint, under its weight and `push` of it along x.
bool shaft_with_bars_stands(double width, double height, const std::string& bar, double push)
{
    const std::string shaft = "column: {height: " + std::to_string(height) +
                              " m, diameter: " + std::to_string(width) + " m, drums: 3, sides: 4}";
    const std::string between[] = {"foundation, drums", "drums, drums"};
    std::string bars;
    for (const std::string& groups : between)
        bars +=
            (bars.empty() ? "" : ", ") + std::string("{between: [") + groups + "], length: 20 cm, " + bar + "}";
    return run_to_rest(read_pattern(shaft, {"kinematics=spatial_rigid", "stages[1]=null",
                                            "joints={dry: {friction: 35 deg}}", "bars=[" + bars + "]",
                                            "gravity={direction: [" + std::to_string(push) + ", 0, -1]}"}))
               .report.outcome == Outcome::completed;
}

/// The same statics as of DoweledDrumsSlideWhereTheirSteelYields, with dowels in the place of a strength of
/// joints.
TEST(ColumnPattern, DrumsSlideWhereTheirBarsYield)
{
    constexpr double width = 3, height = 0.9;
    constexpr double steel = 2e-4, yield = 240e6;  // m2 in each joint, Pa
    const double weight = 2400 * 9.80665 * width * width * height, mu = std::tan(35 * std::numbers::pi / 180);
    double limit = mu;
    for (int i = 0; i < 100; ++i) limit = mu + steel * yield / std::sqrt(3.0) / weight * std::hypot(limit, 1.0);
    const std::string bar = "area: 2 cm2, yield_strength: 240 MPa";
    EXPECT_TRUE(shaft_with_bars_stands(width, height, bar, limit * 0.995));
    EXPECT_FALSE(shaft_with_bars_stands(width, height, bar, limit * 1.005));
}

/// Statics: a bar in the middle of the lowest joint that holds the force T when the shaft turns about its edge:
/// push N H / 2 = (N + T) w / 2. A joint further up has as strong a bar and less above it.
TEST(ColumnPattern, BarsThatHoldTensionCarryBeyondOverturning)
{
    constexpr double height = 4, area = 1e-4, yield = 100e6;
    const double tension = area * yield;
    double limit = 0.25;  // dry
    for (int i = 0; i < 100; ++i)
        limit = (1 + tension * std::hypot(limit, 1.0) / (2400 * 9.80665 * height)) / height;
    ASSERT_GT(limit, 1.1 * 0.25);
    const std::string bar = "area: 1 cm2, yield_strength: 100 MPa, carries: [tension, shear]";
    EXPECT_TRUE(shaft_with_bars_stands(1, height, bar, limit * 0.995));
    EXPECT_FALSE(shaft_with_bars_stands(1, height, bar, limit * 1.005));
}

TEST(TempleFrontPattern, HasTheNamesVolumesAndSymmetryOfMasonry)
{
    const Model model = read_pattern(front).model;
    EXPECT_EQ(count_in(model, "drums"), 4 * 5);
    EXPECT_EQ(count_in(model, "capital"), 4 * 2);
    EXPECT_EQ(count_in(model, "entablature"), 3 + 4);
    EXPECT_EQ(group_of(model, "column_4_drum_5"), "drums");
    EXPECT_EQ(group_of(model, "stylobate"), "foundation");
    const double length = 3 * 2.5 + 1.2;
    EXPECT_NEAR(volume_in(model, "entablature"), length * 1.4 * 0.9, 1e-7);
    EXPECT_NEAR(volume_in(model, "pediment"), length * 0.9 * (0.3 + 1.5) / 2, 1e-7);
    expect_symmetric(model, 0);
    expect_symmetric(model, 1);
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    EXPECT_NEAR(joint_area(assembly, "column_2_abacus", "architrave_1"), 0.6 * 0.9, 1e-7);
}

TEST(TempleFrontPattern, Rests)
{
    expect_rest(read_pattern(front, {"kinematics=spatial_rigid"}));
}

TEST(TempleFrontPattern, SaysWhichKeyMakesNoTemple)
{
    const std::string close = reader::faults_of(pattern_case(with(front, "spacing: 2.5 m", "spacing: 1.1 m")));
    EXPECT_NE(close.find("temple_front.spacing: 1.100000 m; the columns must stand apart"), std::string::npos)
        << close;
    const std::string sides = reader::faults_of(pattern_case(with(column, "sides: 16", "sides: 17")));
    EXPECT_NE(sides.find("column.sides: 17"), std::string::npos) << sides;
}

}  // namespace
}  // namespace voussoir::app::patterns_test
