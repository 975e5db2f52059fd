// A saved state goes on bit for bit, and a damaged one is refused.
#include "app/results/state_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>

#include "libdda/errors.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{
namespace
{

State odd_state(Kinematics kinematics)
{
    State state = synthetic::swaying(synthetic::arch(kinematics), 1.23456789);
    state.stage_time = 0.1 + 0.2;
    state.grid = 617;
    state.next_time_step = 1e-300;
    state.coordinates[0] = std::numeric_limits<double>::denorm_min();
    state.contacts.patches[2].intact = true;
    state.contacts.patches[3].edge_edge = true;
    state.contacts.points[5].status = ContactStatus::sliding;
    state.contacts.points[5].shear_force = {1, -0.0, 3};
    state.contacts.points[6].elastic_slip = {1e-9, 2e-9, 3e-9};
    state.contacts.points[7].rest_gap = 1e-7;
    return state;
}

class StateFile : public testing::TestWithParam<Kinematics>
{
};

TEST_P(StateFile, EveryBitComesBack)
{
    const TemporaryFolder folder;
    const State state = odd_state(GetParam());
    save_state(state, folder.path() / "state");
    const State loaded = load_state(folder.path() / "state");
    EXPECT_EQ(hash_of(loaded), hash_of(state));
    EXPECT_EQ(loaded.coordinates, state.coordinates);
    EXPECT_EQ(loaded.contacts.points.size(), state.contacts.points.size());
    EXPECT_TRUE(loaded.contacts.patches[2].intact);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "state.part"));
}

INSTANTIATE_TEST_SUITE_P(Kinematics, StateFile,
                         testing::Values(Kinematics::spatial_deformable, Kinematics::spatial_rigid));

TEST(StateFile, BelongsToItsModel)
{
    const Case arch = synthetic::arch(Kinematics::spatial_rigid),
               tower = synthetic::tower(Kinematics::spatial_rigid);
    const State good = synthetic::swaying(arch, 1.2);
    EXPECT_NO_THROW(check_fits(good, arch.model, "state"));
    EXPECT_THROW(check_fits(good, tower.model, "state"), InputError);
    State bad = good;
    bad.contacts.patches.at(0).block_b = static_cast<int>(arch.model.blocks.size());
    EXPECT_THROW(check_fits(bad, arch.model, "state"), InputError);
    bad = good;
    bad.velocities.at(0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(check_fits(bad, arch.model, "state"), InputError);
}

TEST(StateFile, PatchesWithoutTheirPointsAreRefused)
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "state";
    for (const int count : {-1, 1 << 30}) {
        State state = odd_state(Kinematics::spatial_rigid);
        state.contacts.patches.back().point_count = count;
        save_state(state, path);  // with a checksum that fits
        EXPECT_THROW(load_state(path), InputError) << count;
    }
}

TEST(StateFile, DamageIsRefused)
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "state";
    save_state(odd_state(Kinematics::spatial_rigid), path);
    std::ifstream stream(path, std::ios::binary);
    const std::string good((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    const auto refused = [&](const std::string& bytes) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
        try {
            load_state(path);
        } catch (const InputError&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(refused(good));
    for (std::size_t size = 0; size < good.size(); size += 97) EXPECT_TRUE(refused(good.substr(0, size)));
    for (std::size_t at = 0; at < good.size(); at += 101) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x40);
        EXPECT_TRUE(refused(bad)) << at;
    }
    EXPECT_THROW(load_state(folder.path() / "none"), InputError);
}

TEST(StateFile, AnUnwritableFolderIsOneSentence)
{
    try {
        save_state(odd_state(Kinematics::spatial_rigid), "/nonexistent/folder/state");
        FAIL();
    } catch (const InputError& error) {
        ASSERT_EQ(error.faults.size(), 1U);
        EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos);
    }
}

}  // namespace
}  // namespace voussoir::app::results
