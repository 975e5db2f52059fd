// Datasets say their units themselves.
#include "app/results/units.h"

#include <gtest/gtest.h>

#include "app/results/hdf5_file.h"
#include "app/results/results_writer.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{
namespace
{

TEST(Units, StandBesideWhatHasThem)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_deformable);
    ResultsWriter writer(the_case, folder.path());
    writer.frame(synthetic::swaying(the_case, 1), {});
    writer.finish(synthetic::swaying(the_case, 1), {}, {0, 0});
    const Hdf5File file = Hdf5File::open(writer.results_file());
    const std::pair<const char*, const char*> samples[] = {
        {"/model/mass", "kg"},           {"/model/second_moments", "m5"},  {"/model/materials/young", "Pa"},
        {"/frames/time", "s"},           {"/frames/stress", "Pa"},         {"/joints/area", "m2"},
        {"/frames/joints/opening", "m"}, {"/frames/contacts/force", "N"},  {"/frames/contacts/moment", "N m"},
        {"/frames/contacts/area", "m2"}, {"/frames/contacts/normal", "1"}, {"/joints/largest_slip", "m"}};
    for (const auto& [dataset, unit] : samples) EXPECT_EQ(file.text_attribute(dataset, "unit"), unit) << dataset;
}

TEST(Units, CountsNamesAndIndicesHaveNone)
{
    for (const char* dataset :
         {"/frames/count", "/model/block_names", "/joints/pair", "/frames/report", "/summary"})
        EXPECT_EQ(unit_of(dataset), "") << dataset;
}

}  // namespace
}  // namespace voussoir::app::results
