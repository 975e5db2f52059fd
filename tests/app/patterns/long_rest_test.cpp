// Patterns left alone for a minute after their static stage.
#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

void expect_minute_of_rest(const std::string& entry)
{
    expect_rest(reader::read(pattern_case(entry, 40, 60), {"kinematics=spatial_rigid"}));
}

TEST(LongRest, OfABridgeOfTwoSpans)
{
    expect_minute_of_rest(
        "bridge: {spans: 2, span: 4 m, rise: 1.5 m, thickness: 0.6 m, voussoirs: 11, width: 2 m, stones_across: "
        "1, "
        "block: [1 m, 0.5 m], pier_width: 1.8 m, pier_height: 1.5 m, abutment_length: 1.5 m, spandrel_thickness: "
        "0.5 "
        "m, cover: 0.3 m, fill: blocks}");
}

TEST(LongRest, OfADomeUnderALantern)
{
    expect_minute_of_rest(
        "dome: {radius: 4 m, thickness: 0.5 m, springing: 80 deg, oculus: 14 deg, stones: 12, lantern: {height: 1 "
        "m}}");
}

TEST(LongRest, OfARibbedVault)
{
    expect_minute_of_rest(
        "cross_vault: {span: 4 m, rise: 2 m, thickness: 0.4 m, margin: 0.3 m, courses: 7, stones: 3, ribs: "
        "{width: "
        "0.35 m, depth: 0.3 m}}");
}

}  // namespace
}  // namespace voussoir::app::patterns_test
