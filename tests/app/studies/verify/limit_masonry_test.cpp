// The first of the random walls and arches; many_limit_masonry_test.cpp runs all.
#include <cmath>
#include <numbers>

#include "app/studies/scenes/materials.h"
#include "app/studies/verify/even_draw.h"
#include "libdda/limit/limit_factor.h"
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

// The limit of a prism in space, by mechanisms of springs, is that of its section by the linear program.
TEST(LimitMasonry, PrismsHaveTheLimitsOfTheirSections)
{
    for (int n = 4; n < 35; n += 5) {
        const double section =
            limit::associated_limit(limit_problem(random_masonry(limit_masonry_seed, n, true).model)).factor;
        const LimitMasonry masonry = random_masonry(limit_masonry_seed, n);
        EXPECT_NEAR(limit::limit_factor(limit_problem(masonry.model)).value_or(0), section, 2e-5 * section)
            << masonry.description;
    }
}

// A wall that slides off its base as one, whose stones press on each other no more: what is rounded differently
// must not leave the answer open.
TEST(LimitMasonry, RoundingLeavesNothingOpen)
{
    const limit::LimitProblem exact = limit_problem(random_masonry(limit_masonry_seed, 9).model);
    EvenDraw draw(limit_masonry_seed, 9);
    for (int n = 0; n < 12; ++n) {
        limit::LimitProblem rounded = exact;
        for (limit::LimitContact& contact : rounded.contacts) {
            contact.position *= 1 + draw.between(-1e-13, 1e-13);
            contact.friction *= 1 + draw.between(-1e-13, 1e-13);
        }
        const double friction = exact.contacts.front().friction;
        EXPECT_NEAR(limit::limit_factor(rounded).value_or(0), friction, 2e-5 * friction) << n;
    }
}

// Seven voussoirs over 157.5 degrees, thickness 0.15 of the radius: four hinges at 0.3736 of the weight (virtual
// work over all sets of four hinges, cases/arch_planar.yaml). Source: [Oppenheim1992].
TEST(LimitMasonry, ArchOfFourHinges)
{
    constexpr double inner = 1.85, half = 7 * std::numbers::pi / 16;
    importers::patterns::BarrelVault vault;
    vault.span = 2 * inner * std::sin(half);
    vault.rise = inner * (1 - std::cos(half));
    vault.thickness = 0.3;
    vault.length = 1;
    vault.courses = 7;
    vault.stones = 1;
    vault.bonded = false;
    for (const Kinematics kinematics : {Kinematics::planar_rigid, Kinematics::spatial_rigid}) {
        Model model = make_model(kinematics, scenes::stone(), scenes::dry_joint(0.839));
        add_arch(model, vault);
        const limit::LimitProblem problem = limit_problem(model);
        EXPECT_NEAR(limit::associated_limit(problem).factor, 0.3736, 1e-4);
        EXPECT_NEAR(limit::non_associated_limit(problem).factor, 0.3736, 1e-4);
    }
}

// Stones are in one piece and touch: limit analysis needs contacts at every stone.
TEST(LimitMasonry, EveryStoneHasContacts)
{
    for (int n = 0; n < 30; ++n) {
        const LimitMasonry masonry = random_masonry(limit_masonry_seed, n);
        const limit::LimitProblem problem = limit_problem(masonry.model);
        std::vector<int> count(problem.blocks.size());
        for (const limit::LimitContact& contact : problem.contacts) {
            ++count[static_cast<std::size_t>(contact.block_a)];
            ++count[static_cast<std::size_t>(contact.block_b)];
        }
        for (const int contacts : count) EXPECT_GE(contacts, 2) << masonry.description;
    }
}

}  // namespace voussoir::app::studies::verify
