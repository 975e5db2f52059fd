// `fit_tolerance`, and what is refused because it is more, or because no joint could carry it.
#include <gtest/gtest.h>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

TEST(DrawnFitCase, IsNoneWithoutMeshes)
{
    const Case the_case = read(two_boxes);
    EXPECT_EQ(the_case.model.fit_tolerance, 0);
    EXPECT_FALSE(has_default(the_case, "fit_tolerance"));
}

TEST(DrawnFitCase, CoversWhatBoxesOverlapBy)
{
    const std::string deep = with(two_boxes, "[-0.5, -0.5, 0]", "[-0.5, -0.5, -0.002]");
    const Case the_case = read(deep, {"fit_tolerance=2.5 mm"});
    EXPECT_EQ(the_case.model.fit_tolerance, 2.5e-3);
    EXPECT_TRUE(the_case.warnings.empty());
    EXPECT_EQ(
        faults_of(deep, {"fit_tolerance=1.5 mm"}),
        "case.yaml:8: blocks[1].box: floor and stone: overlap by 0.002 m; stones may overlap by the fit_tolerance "
        "of 0.0015 m");
    EXPECT_EQ(faults_of(two_boxes, {"fit_tolerance=-1 mm"}), "--set fit_tolerance: -1 mm; must be >= 0");
    EXPECT_NE(faults_of(two_boxes, {"fit_tolerance=1 kg"}).find("a length"), std::string::npos);
}

// 2400 g 1 m / k on the joint of a stone of 1 m.
TEST(DrawnFitCase, DoesNotHelpJointsThatAreTooSoft)
{
    EXPECT_EQ(
        faults_of(two_boxes, {"joints.dry.contact_stiffness=2e5 Pa/m"}),
        "case.yaml: stone: settles by 118 mm under the weight that it carries, 12 % of the width; give its joints "
        "a contact_stiffness 15 times as large");
    EXPECT_EQ(faults_of(two_boxes, {"joints.dry.contact_stiffness=3e6 Pa/m"}), "no fault");
    EXPECT_EQ(faults_of(two_boxes, {"joints.dry.contact_stiffness=2e5 Pa/m", "gravity={magnitude: 0.1 m/s2}"}),
              "no fault");
}

}  // namespace
}  // namespace voussoir::app::reader
