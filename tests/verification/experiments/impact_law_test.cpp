// Laws of impact beside Newton's of the point with Coulomb's friction, by impulses alone, on thrown cubes: fitted
// on half of the tosses and scored on the others. The engine's law stays while none is nearer:
// docs/experiments.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "tests/verification/experiments/cube_by_impulses.h"
#include "tests/verification/experiments/cube_table.h"
#include "tests/verification/experiments/laboratory.h"

namespace voussoir::verification
{
namespace
{

constexpr double step = 5e-4;  // s: as good as 0.1 ms here

/// A law with one number of its own.
struct LawOfImpact {
    std::string name, symbol;
    std::vector<double> values;
    std::function<void(ImpactLaw&, double)> set;
};

std::vector<LawOfImpact> laws()
{
    return {
        {"Newton, the engine's", "", {0}, [](ImpactLaw&, double) {}},
        {"Poisson",
         "",
         {0},
         [](ImpactLaw& law, double) { law.restitution = ImpactLaw::Restitution::of_the_impulse; }},
        {"friction of its own in impacts",
         "friction in impacts",
         {0.05, 0.1, 0.14, 0.22, 0.3, 0.5},
         [](ImpactLaw& law, double value) { law.friction = value; }},
        {"restitution of the slip",
         "its restitution",
         {-0.2, 0.1, 0.2, 0.4, 0.6},
         [](ImpactLaw& law, double value) { law.tangential = value; }},
        {"restitution that falls with the speed",
         "speed of its half, m/s",
         {0.25, 0.5, 1, 2},
         [](ImpactLaw& law, double value) { law.half_speed = value; }},
    };
}

struct FittedLaw {
    CubeSetting setting;
    ImpactLaw law;
    double value = 0;
};

CubeModel model_of(const ImpactLaw& law)
{
    return [law](const Toss& toss, const CubeSetting& setting, bool& ran) {
        ran = true;
        return cube_by_impulses(toss, setting, step, law);
    };
}

FittedLaw fitted_to(const std::vector<Toss>& tosses, const LawOfImpact& kind)
{
    FittedLaw best;
    double least = 1e300;
    for (const double value : kind.values)
        for (int mu = 12; mu <= 24; mu += 2)
            for (int e = 0; e <= 4; ++e) {
                FittedLaw trial{{}, {}, value};
                trial.setting.friction = 0.01 * mu;
                trial.setting.restitution = 0.1 * e;
                kind.set(trial.law, value);
                const double error =
                    figures_of(scores_of(tosses, trial.setting, model_of(trial.law))).mean_position;
                if (error >= least) continue;
                least = error;
                best = trial;
            }
    return best;
}

TEST(LawsOfImpact, NoneIsNearerToThrownCubesThanThatOfTheEngine)
{
    const char* others = std::getenv("VOUSSOIR_TOSSES");
    const std::filesystem::path file =
        others != nullptr ? std::filesystem::path(others) : laboratory_folder("cube") / "tosses.csv.gz";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no tosses of the cube beside VOUSSOIR_DATA";
    const Halves<Toss> halves = halves_of(read_tosses(file));
    print_head();
    CubeFigures engine;
    for (const LawOfImpact& kind : laws()) {
        const FittedLaw best = fitted_to(halves.fitted, kind);
        const std::string name =
            kind.symbol.empty() ? kind.name : fmt::format("{}: {} {:g}", kind.name, kind.symbol, best.value);
        const CubeFigures figures =
            print_line(name, best.setting, scores_of(halves.judged, best.setting, model_of(best.law)));
        if (kind.symbol.empty() && engine.position == 0) engine = figures;
        EXPECT_GT(figures.position, 0.85 * engine.position) << name;
        EXPECT_LT(figures.right_faces, engine.right_faces + 3 * engine.right_faces_error) << name;
    }
}

}  // namespace
}  // namespace voussoir::verification
