#include "tests/verification/experiments/cube_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace voussoir::verification
{

void print_head()
{
    fmt::print(
        "| Cube | friction, restitution | tosses | position error: median (quarters), mm | of the edge | rotation "
        "error | right face | travel error, mm | its bias, mm |\n|---|---|---|---|---|---|---|---|---|\n");
}

CubeFigures print_line(const std::string& name, const CubeSetting& setting, const std::vector<TossScore>& scores)
{
    const CubeFigures f = figures_of(scores);
    const std::string restitution = setting.restitution ? fmt::format("{:g}", *setting.restitution) : "none";
    fmt::print(
        "| {} | {:g}, {} | {} | {:.1f} ({:.1f} to {:.1f}) | {:.1f} % | {:.1f}° | {:.0f} ± {:.0f} % | {:.1f} | "
        "{:+.1f} |\n",
        name, setting.friction, restitution, scores.size(), 1e3 * f.position, 1e3 * f.position_low,
        1e3 * f.position_high, 100 * f.position / cube_edge, f.rotation, 100 * f.right_faces,
        100 * f.right_faces_error, 1e3 * f.travel, 1e3 * f.travel_bias);
    EXPECT_EQ(f.stopped, 0) << name;
    return f;
}

}  // namespace voussoir::verification
