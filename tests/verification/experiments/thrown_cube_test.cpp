// 60 tosses of a plastic cube, predicted from their first row: what the engine makes of impacts and friction at
// its defaults.
#include "tests/verification/experiments/thrown_cube.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/verification/experiments/laboratory.h"

namespace voussoir::verification
{
namespace
{

class ThrownCube : public ::testing::Test
{
 protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(laboratory_folder("cube") / "tosses.csv.gz"))
            GTEST_SKIP() << "no tosses of the cube beside VOUSSOIR_DATA";
        tosses = read_tosses();
    }
    std::vector<Toss> tosses;
};

CubeFigures line(const std::string& name, const std::vector<Toss>& tosses, const CubeSetting& setting)
{
    const std::vector<TossScore> scores = scores_of(tosses, setting);
    const CubeFigures f = figures_of(scores);
    int stopped = 0;
    for (const TossScore& score : scores) stopped += score.ran ? 0 : 1;
    fmt::print("| {} | {:.2f} | {:.3f} | {} | {:.1f} ({:.1f} to {:.1f}) | {:.0f} % | {:.1f} | {:.0f} % | {:.1f} | {:+.1f} | {} |\n",
               name, setting.friction, setting.restitution.value_or(-1), tosses.size(), 1e3 * f.position,
               1e3 * f.position_low, 1e3 * f.position_high, 100 * f.position / cube_edge, f.rotation,
               100 * f.right_faces, 1e3 * f.travel, 1e3 * f.travel_bias, stopped);
    std::fflush(stdout);
    return f;
}

TEST_F(ThrownCube, ExploresSettings)
{
    for (const double step : {2e-3, 1e-3, 5e-4, 2.5e-4, 1e-4})
        for (const bool decaying : {false, true}) {
            CubeSetting setting;
            setting.control.time_step = step;
            if (decaying) {
                setting.control.integrator = Integrator::energy_decaying;
                setting.control.dissipation = std::min(0.1, 10 * step);
            }
            line(fmt::format("{} {}", step, decaying), tosses, setting);
        }
}

}  // namespace
}  // namespace voussoir::verification
