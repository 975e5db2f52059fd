// Patterns on both sides of the push, or the thickness, that statics says: those that are more than one arch.
#include "tests/app/patterns/limit_thickness.h"

namespace voussoir::app::patterns_test
{
namespace
{

/// An entry, turned by a quarter so that x of the push is its y.
std::string turned(const std::string& entry)
{
    return "{" + entry + ", rotate: {axis: z, angle: 90 deg}}";
}

const std::string front =
    "temple_front: {columns: 3, spacing: 2.5 m, height: 5 m, diameter: 1 m, drums: 3, sides: 8, capital: {height: "
    "0.6 m, width: 1.2 m}, architrave: 0.7 m, frieze: 0.7 m, pediment: 1.5 m, depth: 0.9 m}";

TEST(LimitPush, OfATempleFrontAlongAndAcross)
{
    expect_limit_push(front);
    expect_limit_push(turned(front));
}

TEST(LimitPush, OfAButtress)
{
    const std::string buttress =
        "buttress: {width: 1 m, block: [0.8 m, 0.4 m], stages: [{height: 2.4 m, depth: 1.2 m}, {height: 1.6 m, "
        "depth: 0.7 m}]}";
    expect_limit_push(buttress);
    expect_limit_push(turned(buttress));
}

/// Out of its plane: whole courses turn about the edge of the base.
TEST(LimitPush, OfAWallAcrossIt)
{
    expect_limit_push(
        "{wall: {length: 2.4 m, height: 2.4 m, thickness: 0.4 m, block: [0.8 m, 0.4 m], base: {height: 0.3 m}}, "
        "groups: {foundation: \"*_base\"}, rotate: {axis: z, angle: 90 deg}}");
}

TEST(LimitPush, OfAGateAcrossIt)
{
    expect_limit_push(
        turned("gate: {span: 2.4 m, thickness: 0.5 m, voussoirs: 9, depth: 0.8 m, block: [0.9 m, 0.6 m], pier: "
               "{width: 1.2 m, height: 2.4 m}, attic: 0.6 m}"));
}

TEST(LimitPush, OfABridgeOfUnequalSpans)
{
    expect_limit_push(
        "bridge: {spans: [{span: 3 m, voussoirs: 9}, {span: 4 m, voussoirs: 11}], thickness: 0.5 m, width: 1 m, "
        "stones_across: 1, block: [1 m, 0.6 m], pier_width: 1.6 m, pier_height: 3 m}");
}

TEST(LimitThickness, OfAGroinVault)
{
    expect_limit_thickness(
        [](double thickness) {
            return "cross_vault: {span: 4 m, rise: 2 m, margin: 0.3 m, courses: 5, stones: 1, thickness: " +
                   std::to_string(thickness) + " m}";
        },
        0.06, 0.4);
}

/// Joints without friction cannot dilate: there limit analysis is exact. A dome of them stands if it begins
/// high enough, for all its courses press along themselves; half of it does so between the two sides of its arch.
TEST(LimitSpringing, OfHalfADomeWithoutFriction)
{
    expect_limit_thickness(
        [](double elevation) {
            return "{dome: {radius: 4 m, thickness: 0.3 m, half: true, front: 0.6 m, oculus: 12 deg, courses: 5, "
                   "stones: 4, springing: " +
                   std::to_string(90 - elevation) + " deg}, groups: {foundation: \"front*\"}}";
        },
        25, 50, {"joints.dry.friction=0 deg"});
}

/// With friction its bonded courses hold themselves between the sides of the arch: no thickness is too small.
TEST(LimitThickness, OfHalfADomeThatIsBondedIsNone)
{
    const std::string thin =
        "{dome: {radius: 4 m, thickness: 0.05 m, half: true, front: 0.6 m, oculus: 12 deg, courses: 5, stones: 4, "
        "springing: 90 deg}, groups: {foundation: \"front*\"}}";
    EXPECT_TRUE(bears_itself(studies::verify::limit_problem(read_pattern(thin, under_own_weight).model)));
    EXPECT_TRUE(stands(thin));
}

/// Stones of ribs and of webs lock one another, at angles, so that friction decides, and limit analysis, in
/// which joints that slide open, is a bound from above. Rough ribs make it bear webs of any thickness; on ribs
/// without friction there is one below which nothing stands.
TEST(LimitThickness, OfARibbedVaultIsBoundedByTheLinearProgram)
{
    const auto ribbed = [](double thickness) {
        return "cross_vault: {span: 4 m, rise: 2 m, margin: 0.3 m, courses: 5, stones: 1, ribs: {width: 0.1 m, "
               "depth: 0.05 m}, thickness: " +
               std::to_string(thickness) + " m}";
    };
    const std::vector<std::string> smooth{"joints={dry: {friction: 40 deg}, smooth: {friction: 0 deg}}",
                                          "default_joint=dry",
                                          "joint_rules=[{between: [ribs, vault], joint: smooth}]"};
    const auto by_program = [&](double thickness, std::vector<std::string> overrides) {
        overrides.insert(overrides.end(), under_own_weight.begin(), under_own_weight.end());
        return bears_itself(studies::verify::limit_problem(read_pattern(ribbed(thickness), overrides).model));
    };
    EXPECT_TRUE(by_program(0.015, {}));
    EXPECT_FALSE(by_program(0.02, smooth));
    EXPECT_FALSE(stands(ribbed(0.02), smooth));
    EXPECT_TRUE(by_program(0.08, smooth));
    EXPECT_TRUE(stands(ribbed(0.08), smooth));
}

}  // namespace
}  // namespace voussoir::app::patterns_test
