// The first of the random walls and arches; many_limit_masonry_test.cpp runs all.
#include "tests/app/studies/verify/limit_verdicts.h"

namespace voussoir::app::studies::verify
{

TEST(LimitMasonry, StandsBelowItsLimitsAndFallsAboveThem)
{
    LimitCounts counts;
    for (int n = 0; n < 12; ++n) judge_verdicts(limit_masonry_seed, n, counts);
    EXPECT_GE(counts.sharp, 4);
    EXPECT_GE(counts.wide, 4);
}

TEST(LimitMasonry, TheSameSeedDrawsTheSame)
{
    EXPECT_EQ(random_masonry(7, 3).description, random_masonry(7, 3).description);
    EXPECT_NE(random_masonry(7, 3).description, random_masonry(8, 3).description);
}

// The limit of a prism in space, its pyramids of friction exact in its plane, is that of its section.
TEST(LimitMasonry, PrismsHaveTheLimitsOfTheirSections)
{
    for (int n = 4; n < 35; n += 5) {
        const double section =
            references::associated_limit(limit_problem(random_masonry(limit_masonry_seed, n, true).model)).factor;
        const LimitMasonry masonry = random_masonry(limit_masonry_seed, n);
        EXPECT_NEAR(references::associated_limit(limit_problem(masonry.model)).factor, section, 1e-6 * section)
            << masonry.description;
    }
}

// Stones are in one piece and touch: limit analysis needs contacts at every stone.
TEST(LimitMasonry, EveryStoneHasContacts)
{
    for (int n = 0; n < 30; ++n) {
        const LimitMasonry masonry = random_masonry(limit_masonry_seed, n);
        const references::LimitProblem problem = limit_problem(masonry.model);
        std::vector<int> count(problem.blocks.size());
        for (const references::LimitContact& contact : problem.contacts) {
            ++count[static_cast<std::size_t>(contact.block_a)];
            ++count[static_cast<std::size_t>(contact.block_b)];
        }
        for (const int contacts : count) EXPECT_GE(contacts, 2) << masonry.description;
    }
}

}  // namespace voussoir::app::studies::verify
