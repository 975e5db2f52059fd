// left_out names exactly what is not created.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/results/hdf5_file.h"
#include "app/results/results_writer.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{
namespace
{

bool names(const std::vector<std::string>& words, const std::string& start)
{
    return std::any_of(words.begin(), words.end(), [&](const std::string& w) { return w.starts_with(start); });
}

TEST(LeftOut, ABareRigidCaseLeavesOutNearlyAll)
{
    const auto words = left_out(synthetic::tower(Kinematics::spatial_rigid));
    for (const char* word :
         {"strains", "mesh importers", "ground motion", "body accelerations", "cohesion", "contact damping",
          "kinetic damping", "viscous boundaries", "histories", "renderer"}) {
        EXPECT_TRUE(names(words, word)) << word;
    }
    EXPECT_FALSE(names(words, "foundations"));
}

TEST(LeftOut, WhatACaseListsIsNotLeftOut)
{
    Case full = synthetic::arch(Kinematics::spatial_deformable);
    const auto sine = std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(1, 1, 0, 1));
    full.mesh_files = {"arch.obj"};
    full.stages[1].motions = {{0, 0, sine}};
    full.stages[1].body_accelerations = {{0, 0, sine}};
    full.stages[1].damping.rate = 1;
    full.model.joints[0].tensile_strength = 1e3;
    full.model.joints[0].relaxation_time = 1e-4;
    full.model.joints.push_back(full.model.joints[0]);  // a joint has a dashpot or a law of impacts
    full.model.joints[1].relaxation_time = 0;
    full.output.snapshots.emplace();
    EXPECT_EQ(left_out(full),
              (std::vector<std::string>{
                  "Rayleigh damping (no material has any)", "hysteretic damping (no material has any)",
                  "bars (no metal is between stones)", "viscous boundaries (no face of a block is one)"}));
    full.model.materials[0].rayleigh.of_mass = 1;
    full.model.materials[0].branches = {{0.1, 1}};
    full.model.boundaries.push_back({"base", {{0, 0, 0}}, RestSupport::full});
    full.model.bars.emplace_back();
    EXPECT_TRUE(left_out(full).empty());
    full.model.foundations.clear();
    EXPECT_TRUE(names(left_out(full), "foundations"));
}

TEST(LeftOut, FilesHaveNothingOfTheGroundWhereNoneIs)
{
    const TemporaryFolder folder;
    const Case bare = synthetic::tower(Kinematics::spatial_rigid);
    ResultsWriter writer(bare, folder.path());
    const State state = initial_state(bare.model);
    writer.frame(state, {});
    writer.finish(state, {}, {0, 0});
    const Hdf5File file = Hdf5File::open(writer.results_file());
    EXPECT_TRUE(file.has("/model/foundations"));
    for (const char* group : {"/model/boundaries", "/model/tied_sides", "/model/side_ties"})
        EXPECT_FALSE(file.has(group)) << group;
}

}  // namespace
}  // namespace voussoir::app::results
