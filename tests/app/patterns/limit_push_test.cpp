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

}  // namespace
}  // namespace voussoir::app::patterns_test
