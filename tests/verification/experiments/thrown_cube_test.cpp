// 60 tosses of a plastic cube, predicted from their first row: what the engine makes of impacts and friction at
// its defaults. The bounds are what it reached, with room for tosses that turn over another edge: see
// docs/experiments.md.
#include "tests/verification/experiments/thrown_cube.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "app/plots/plots.h"
#include "tests/verification/experiments/cube_by_impulses.h"
#include "tests/verification/experiments/cube_table.h"
#include "tests/verification/experiments/laboratory.h"

namespace voussoir::verification
{
namespace
{

using Scores = std::vector<TossScore>;

TrackedMotion by_impulses(const Toss& toss, const CubeSetting& setting, bool& ran)
{
    ran = true;
    return cube_by_impulses(toss, setting, 1e-4);
}

/// Share of the tosses whose position error is smaller.
app::plots::Curve distribution(const std::string& name, const Scores& scores, bool is_reference)
{
    app::plots::Curve curve{name, {}, {}, is_reference};
    std::vector<double> errors;
    for (const TossScore& score : scores) errors.push_back(score.position);
    for (int i = 0; i <= 100; ++i) {
        curve.x.push_back(1e3 * quantile_of(errors, i / 100.0));
        curve.y.push_back(i);
    }
    return curve;
}

/// The median of the distances at each time that half of the tosses have.
app::plots::Curve growth(const std::string& name, const Scores& scores, bool is_reference)
{
    app::plots::Curve curve{name, {}, {}, is_reference};
    for (std::size_t row = 0;; ++row) {
        std::vector<double> distances;
        for (const TossScore& score : scores)
            if (row < score.distances.size()) distances.push_back(1e3 * score.distances[row]);
        if (2 * distances.size() < scores.size()) return curve;
        curve.x.push_back(static_cast<double>(row) / 148);
        curve.y.push_back(median_of(distances));
    }
}

void draw(const Scores& engine, const Scores& impulses, const Scores& springs)
{
    const std::string names[] = {"impulses alone, step 0.1 ms", "defaults", "restitution: none"};
    app::plots::Figure figure{"thrown_cube",
                              "A thrown cube: 60 tosses predicted from their first row",
                              "friction 0.18 and restitution 0.125 as published",
                              {},
                              false,
                              {}};
    figure.diagrams.push_back({"mean position error of a toss [mm]",
                               "share of the tosses with less [%]",
                               {distribution(names[0], impulses, true), distribution(names[1], engine, false),
                                distribution(names[2], springs, false)},
                               {},
                               false,
                               false,
                               false});
    figure.diagrams.push_back(
        {"time since the first row [s]",
         "median distance of the centres [mm]",
         {growth(names[0], impulses, true), growth(names[1], engine, false), growth(names[2], springs, false)},
         {},
         false,
         false,
         false});
    draw_if_asked(figure);
}

class ThrownCube : public ::testing::Test
{
 protected:
    void SetUp() override
    {
        const std::filesystem::path file = laboratory_folder("cube") / "tosses.csv.gz";
        if (!std::filesystem::exists(file)) GTEST_SKIP() << "no tosses of the cube beside VOUSSOIR_DATA";
        tosses = read_tosses(file);
        ASSERT_EQ(tosses.size(), 60U);
    }
    std::vector<Toss> tosses;
};

TEST_F(ThrownCube, GoesWhereItWentWithFrictionAndRestitutionAsPublished)
{
    print_head();
    const CubeSetting published;
    const Scores impulses = scores_of(tosses, published, by_impulses);
    const CubeFigures law = print_line("impulses alone", published, impulses);
    const Scores engine = scores_of(tosses, published);
    const CubeFigures figures = print_line("defaults", published, engine);
    CubeSetting low = published, other = published, springs = published;
    low.table = -0.0011;
    print_line("defaults, table 1.1 mm lower", low, scores_of(tosses, low));
    other.friction = 0.15;
    print_line("defaults", other, scores_of(tosses, other));
    springs.restitution = std::nullopt;
    const Scores without = scores_of(tosses, springs);
    print_line("defaults without landing law", springs, without);
    draw(engine, impulses, without);
    EXPECT_LT(figures.position, 0.0115);
    EXPECT_LT(figures.rotation, 11.5);
    EXPECT_GE(figures.right_faces, 0.85);
    EXPECT_LT(figures.travel, 0.021);
    EXPECT_LT(std::abs(figures.travel_bias), 0.006);
    EXPECT_LT(figures.position, 1.25 * law.position) << "the law of impact itself is nearer to the tosses";
}

TEST_F(ThrownCube, GoesThereAtEveryStep)
{
    print_head();
    for (const double step : {4e-3, 1e-3, 5e-4, 2e-4}) {
        CubeSetting setting;
        setting.control.time_step = step;
        const CubeFigures figures =
            print_line(fmt::format("step {:g} ms", 1e3 * step), setting, scores_of(tosses, setting));
        EXPECT_LT(figures.position, 0.0125) << step;
        EXPECT_GE(figures.right_faces, 0.82) << step;
    }
}

/// The friction and restitution that bring tosses nearest on the average.
CubeSetting fitted_to(const std::vector<Toss>& tosses)
{
    CubeSetting best;
    double least = 1e300;
    for (int mu = 14; mu <= 24; ++mu)
        for (int e = 0; e <= 8; ++e) {
            CubeSetting setting;
            setting.friction = 0.01 * mu;
            setting.restitution = 0.05 * e;
            const double error = figures_of(scores_of(tosses, setting)).mean_position;
            if (error >= least) continue;
            least = error;
            best = setting;
        }
    return best;
}

/// Fits on every second toss and scores on the others.
void judge_in_halves(const std::vector<Toss>& tosses)
{
    const Halves<Toss> halves = halves_of(tosses);
    const CubeSetting best = fitted_to(halves.fitted), published;
    print_head();
    print_line("defaults, fitted, this half", best, scores_of(halves.fitted, best));
    const CubeFigures fitted =
        print_line("defaults, fitted to the other half", best, scores_of(halves.judged, best));
    const CubeFigures plain = print_line("defaults", published, scores_of(halves.judged, published));
    EXPECT_NEAR(best.friction, published.friction, 0.03);
    EXPECT_LT(plain.position, 1.25 * fitted.position);
    EXPECT_GT(plain.position, 0.75 * fitted.position);
}

TEST_F(ThrownCube, IsNotMuchNearerWithFrictionAndRestitutionFittedToHalfOfTheTosses)
{
    judge_in_halves(tosses);
}

/// All that were published but the 60, if VOUSSOIR_TOSSES names their table (scripts/cube_tosses makes it).
class OtherTosses : public ::testing::Test
{
 protected:
    void SetUp() override
    {
        const char* file = std::getenv("VOUSSOIR_TOSSES");
        if (file == nullptr) GTEST_SKIP() << "no other tosses of the cube: VOUSSOIR_TOSSES names no table";
        tosses = read_tosses(file);
        ASSERT_GE(tosses.size(), 100U);
    }
    std::vector<Toss> tosses;
};

TEST_F(OtherTosses, GoWhereTheLawOfImpactSendsThem)
{
    print_head();
    const CubeSetting published;
    const CubeFigures law = print_line("impulses alone", published, scores_of(tosses, published, by_impulses));
    const CubeFigures figures = print_line("defaults", published, scores_of(tosses, published));
    CubeSetting springs = published;
    springs.restitution = std::nullopt;
    const CubeFigures without = print_line("defaults without landing law", springs, scores_of(tosses, springs));
    EXPECT_LT(figures.position, 1.25 * law.position);
    EXPECT_GE(figures.right_faces, law.right_faces - 2 * law.right_faces_error);
    EXPECT_GT(figures.right_faces, without.right_faces + 2 * without.right_faces_error);
}

TEST_F(OtherTosses, AreNotMuchNearerWithFrictionAndRestitutionFittedToHalf)
{
    judge_in_halves(tosses);
}

}  // namespace
}  // namespace voussoir::verification
