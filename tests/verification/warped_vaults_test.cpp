// Two vaults with warped joints, noise and random diagonals: from mesh to shaking.
#include "tests/verification/warped_vaults.h"

namespace voussoir::verification
{

TEST(WarpedVaults, OfFourHundredStonesRunFromMeshToShaking)
{
    expect_vault_is_shaken(dome, 1);
    expect_vault_is_shaken(barrel, 1);
}

}  // namespace voussoir::verification
