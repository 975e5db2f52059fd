// The comparison of two steps tells what is the same, what is not unique, and what is wrong.
#include <algorithm>
#include <cmath>

#include "app/problems/judge.h"
#include "app/problems/tables.h"
#include "app/problems/whole.h"
#include "tests/app/problems/shaken_boxes.h"

namespace voussoir::app::problems
{
namespace
{

using JudgedProblems = ShakenBoxes;

TEST_F(JudgedProblems, AreJudgedTheSame)
{
    arguments.every = 9;
    const Corpus corpus = take(arguments);
    const Case the_case = read(corpus.cases[0]);
    std::vector<Judgement> found;
    for (const StoredStep& problem : corpus.problems) {
        found.push_back(judge(the_case, problem));
        EXPECT_EQ(found.back().verdict, Verdict::same) << line_of(found.back(), 20);
        EXPECT_GT(found.back().plain.open_close_iterations, 0);
    }
    EXPECT_TRUE(passes(found));
    EXPECT_EQ(judge(the_case, corpus.problems.back(), {.large_from = 2}).verdict, Verdict::lawful);
    const int taken = fast_iterations(found);
    EXPECT_GT(taken, 0);
    EXPECT_TRUE(passes(found, {.most_in_all = taken}));
    EXPECT_FALSE(passes(found, {.most_in_all = taken - 1})) << "a lame iteration fails by their number";
    EXPECT_TRUE(passes(found, {.most_not_unique = 0}));
    EXPECT_NE(json_of(found).find("\"passes\": true"), std::string::npos);
}

/// The last step of two boxes, made by both, to be falsified.
class FalsifiedStep : public ShakenBoxes
{
 protected:
    FalsifiedStep()
    {
        arguments.at = {0.03};
        const Corpus corpus = take(arguments);
        the_case = read(corpus.cases[0]);
        problem = corpus.problems.at(0);
        stage = stage_of(problem, the_case);
        fast = make_step(the_case, stage, problem, OpenClose::newton);
        plain = make_step(the_case, stage, problem, OpenClose::plain);
    }
    Judgement judged() const { return compare(the_case, stage, problem, fast, plain); }
    /// The first coordinate of the stone, which moves.
    double& x_of_stone()
    {
        return fast.state.coordinates[static_cast<std::size_t>(coordinates_per_block(the_case.model.kinematics))];
    }

    Case the_case;
    StoredStep problem;
    Stage stage;
    MadeStep fast, plain;
};

TEST_F(FalsifiedStep, IsTheSameAsLongAsItIsNone)
{
    EXPECT_EQ(judged().verdict, Verdict::same);
    EXPECT_LT(judged().difference.worst, most_difference);
}

// 2 m |dx| / h^2 over tolerance times weight and contact forces, which together are twice the weight.
TEST_F(FalsifiedStep, DifferenceIsTheForceThatInertiaNeeds)
{
    fast = plain;
    const double step = 1e-8;
    x_of_stone() += step;
    const double load = loads_of(the_case.model, stage, plain.state)[1], h = problem.time_step;
    EXPECT_NEAR(judged().difference.worst, 2 * the_case.model.mass(1) * step / (h * h) / (1e-5 * load), 0.01);
    EXPECT_EQ(judged().difference.block, 1);
}

TEST_F(FalsifiedStep, ShiftedDownwardsIsWrong)
{
    (&x_of_stone())[2] -= 1e-3;
    EXPECT_EQ(judged().verdict, Verdict::wrong);
    EXPECT_NE(judged().why.find("fall"), std::string::npos) << judged().why;
}

TEST_F(FalsifiedStep, WithMoreFrictionThanTheBoundIsWrong)
{
    x_of_stone() += 1e-5;
    EXPECT_EQ(judged().verdict, Verdict::not_unique);  // each obeys the laws, for all that can be seen
    EXPECT_FALSE(passes({judged()}));
    ContactPoint& point = fast.state.contacts.points[0];
    point.shear_force = 1.1 * std::tan(0.6) * std::max(1.0, point.normal_force) * Eigen::Vector3d::UnitX();
    EXPECT_EQ(judged().verdict, Verdict::wrong);
    EXPECT_NE(judged().why.find("rubs"), std::string::npos) << judged().why;
}

TEST_F(FalsifiedStep, ThatPullsOrLosesEnergyOrBalanceIsWrong)
{
    x_of_stone() += 1e-5;
    const MadeStep good = fast;
    fast.state.contacts.points[0].normal_force = -1e4;
    EXPECT_NE(judged().why.find("pulls"), std::string::npos) << judged().why;
    fast = good;
    fast.energy.friction += 0.1 * fast.energy.scale();
    EXPECT_NE(judged().why.find("unexplained"), std::string::npos) << judged().why;
    fast = good;
    for (double& velocity : fast.state.velocities) velocity *= 2;
    EXPECT_NE(judged().why.find("motion"), std::string::npos) << judged().why;
    fast = good;
    fast.report.unbalanced = 1e-3;
    EXPECT_NE(judged().why.find("unbalanced"), std::string::npos) << judged().why;
}

TEST_F(FalsifiedStep, ThatWasNotMadeIsTold)
{
    const MadeStep good = fast;
    fast.report.outcome = StepOutcome::gave_up;
    fast.report.trouble = Trouble::chatter;
    EXPECT_EQ(judged().verdict, Verdict::fast_failed);
    EXPECT_FALSE(passes({judged()}));
    fast = good;
    plain.report.cuts = 1;
    EXPECT_EQ(judged().verdict, Verdict::plain_failed);
    EXPECT_TRUE(passes({judged()}));
    EXPECT_EQ(summary_of({judged()}),
              "1 problems: 0 the same, 0 not unique, 1 plain failed, 0 fast failed, 0 wrong; " +
                  std::to_string(good.report.open_close_iterations) + " iterations");
}

TEST_F(JudgedProblems, OfAWholeRunByBothIterationsAgree)
{
    const WholeComparison both = compare_whole(read({bytes_of("case.yaml"), {}}));
    EXPECT_GE(both.frames, 5);
    EXPECT_TRUE(both.one_outcome);
    EXPECT_TRUE(both.passes()) << lines_of(both);
}

}  // namespace
}  // namespace voussoir::app::problems
