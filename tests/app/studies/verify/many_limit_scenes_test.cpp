// A hundred random arches, walls, portals, leaning frames and domes around their limits, rigid and deformable.
#include "tests/app/studies/verify/scene_verdicts.h"

namespace voussoir::app::studies::verify
{

TEST(ManyLimitScenes, StandBelowTheirLimitAndFallBeyond)
{
    VerdictCounts counts;
    for (int n = 0; n < 100; ++n)
        for (const bool rigid : {true, false})
            judge_scene(limit_scene_seed, n, rigid, {0.95, 0.97, 0.98, 0.99, 0.995, 1.005, 1.01, 1.03}, counts);
    std::printf(
        "seed %d: %d scenes, %d without a limit left out, %d with one limit; %d verdicts, %d left open by "
        "friction, "
        "of which %d undecided; %.2f times the iterations to fall\n",
        static_cast<int>(limit_scene_seed), counts.scenes, counts.left_out, counts.sharp, counts.verdicts,
        counts.open, counts.undecided,
        static_cast<double>(counts.falling) / counts.fell / (static_cast<double>(counts.standing) / counts.stood));
    EXPECT_GE(counts.sharp, 100);
    EXPECT_LE(counts.undecided, counts.open / 20);
    EXPECT_LE(counts.falling * counts.stood, 10 * counts.standing * counts.fell);
}

}  // namespace voussoir::app::studies::verify
