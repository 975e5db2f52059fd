// A boulder under 60 motions of a shake table: whether it is overturned.
#include "tests/verification/experiments/shaken_boulder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/verification/experiments/laboratory.h"

namespace voussoir::verification
{
namespace
{

double from_environment(const char* name, double otherwise)
{
    const char* value = std::getenv(name);
    return value != nullptr ? std::atof(value) : otherwise;
}

class ShakenBoulder : public ::testing::Test
{
 protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(laboratory_folder("boulder") / "tests.csv"))
            GTEST_SKIP() << "no motions of the boulder beside VOUSSOIR_DATA";
        shape = read_boulder();
        tests = read_table_motions();
    }
    BoulderShape shape;
    std::vector<TableMotion> tests;
};

TEST_F(ShakenBoulder, ExploresSettings)
{
    BoulderSetting setting;
    setting.friction = from_environment("MU", 0.6);
    setting.sign = from_environment("SIGN", 1);
    setting.control.time_step = from_environment("STEP", 2e-3);
    if (std::getenv("K")) setting.stiffness = from_environment("K", 1e8);
    if (std::getenv("E")) setting.young = from_environment("E", 1e8);
    if (std::getenv("DIS")) {
        setting.control.integrator = Integrator::energy_decaying;
        setting.control.dissipation = from_environment("DIS", 0.02);
    }
    const int every = static_cast<int>(from_environment("EVERY", 1));
    std::vector<TableMotion> some;
    for (std::size_t i = 0; i < tests.size(); i += every) some.push_back(tests[i]);
    const std::vector<BoulderEnd> ends = ends_of(shape, some, setting);
    double seconds = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
        fmt::print("{} {} pgv {:.3f} pga {:.3f} overturned {} -> {} tilt {:.2f} {:.2f} moved {:.3f} settled {} ran {} cpu {:.1f} ({:.3f} per s)\n",
                   some[i].number, some[i].record, some[i].peak_velocity, some[i].peak_acceleration, some[i].overturned, ends[i].overturned,
                   ends[i].largest_tilt, ends[i].last_tilt, ends[i].moved, ends[i].settled, ends[i].ran, ends[i].seconds,
                   ends[i].seconds / some[i].motion->duration());
        seconds += ends[i].seconds;
    }
    const BoulderFigures f = figures_of(some, ends);
    const BoulderFigures t = figures_of_threshold(some, 0.123);
    fmt::print("FIGURES mu {} sign {} step {} accuracy {:.3f} false {} misses {} stopped {} (threshold {:.3f}) cpu {:.1f}\n", setting.friction,
               setting.sign, setting.control.time_step, f.accuracy(), f.false_overturnings, f.misses, f.stopped, t.accuracy(), seconds);
}

}  // namespace
}  // namespace voussoir::verification
