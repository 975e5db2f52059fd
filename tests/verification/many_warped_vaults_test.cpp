// The same with every pattern and more seeds.
#include "tests/verification/warped_vaults.h"

namespace voussoir::verification
{

TEST(WarpedVaultsOfManySeeds, OfFourHundredStonesRunFromMeshToShaking)
{
    for (int seed = 2; seed < 5; ++seed)
        for (const std::string& pattern :
             {std::string(dome), std::string(dome) + " --bonded false", std::string(barrel), std::string(cross)})
            expect_vault_is_shaken(pattern, seed);
}

}  // namespace voussoir::verification
