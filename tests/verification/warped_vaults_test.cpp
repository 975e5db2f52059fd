// Two vaults with warped joints, noise and random diagonals: from mesh to shaking.
#include "tests/verification/warped_vaults.h"

namespace voussoir::verification
{

TEST(WarpedVaults, OfFourHundredStonesRunFromMeshToShaking)
{
    expect_vault_is_shaken(dome, 1);
    expect_vault_is_shaken(barrel, 1);
}

// Stones that touch everywhere and are pressed, or pulled by less than their weight moves them: no joint gapes.
TEST(Vaults, HaveNoOpenJointUnderTheirOwnWeight)
{
    const std::string small = "dome";
    for (const std::string& pattern :
         {small, small + as_surveyed, std::string("cross-vault --courses 6 --stones 4"),
          std::string("barrel-vault")}) {
        SCOPED_TRACE(pattern);
        const TemporaryFolder folder;
        const Scene scene{generated(folder, pattern), "", "\"support_*\"", "kinematics: spatial_rigid\n"};
        const Outcome ran = started(folder, "run", scene.text(rest));
        ASSERT_EQ(ran.word(), "completed") << ran.said;
        const nlohmann::json joints = ran.summary.at("joints");
        EXPECT_GT(joints.at("count"), 100);
        EXPECT_EQ(joints.at("counts_from_m"), 1e-4);
        EXPECT_EQ(joints.at("opened"), 0) << joints.at("listed").dump(1).substr(0, 2000);
    }
}

}  // namespace voussoir::verification
