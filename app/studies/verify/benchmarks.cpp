#include <iterator>

#include "app/studies/verify/families.h"
#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{

std::vector<Benchmark> all_benchmarks(std::uint64_t seed)
{
    std::vector<Benchmark> all;
    const auto add = [&](std::vector<Benchmark> family) {
        all.insert(all.end(), std::make_move_iterator(family.begin()), std::make_move_iterator(family.end()));
    };
    add(incline_benchmarks());
    add(two_direction_benchmarks());
    add(wedge_benchmarks());
    add(foundation_benchmarks());
    add(many_blocks_benchmarks());
    // In the plane in the papers: planar here, the spatial scene beside it.
    add(made_planar(three_sines_benchmarks()));
    add(made_planar(shaking_table_benchmarks(), false));
    add(other_incline_benchmarks());
    std::vector<Benchmark> two_blocks = made_planar(two_blocks_benchmarks());
    two_blocks.back().also = {Kinematics::spatial_rigid};
    add(std::move(two_blocks));
    add(mode_chart_benchmarks(seed));
    add(made_planar(rocking_benchmarks(), false));
    add(rocking_default_benchmarks());
    add(made_planar(wave_benchmarks(), false));
    add(vibration_benchmarks());
    add(face_benchmarks());
    add(linear_face_benchmarks());
    add(column_benchmarks());
    add(frame_benchmarks());
    add(ground_benchmarks());
    add(bar_benchmarks());
    add(with_planar(kinetic_damping_benchmarks()));
    add(impact_benchmarks());
    add(made_planar(tower_benchmarks(), false));
    add(made_planar(bridge_benchmarks(), false));
    add(vault_benchmarks());
    add(cross_vault_benchmarks());
    add(made_planar(opening_benchmarks(), false));
    add(limit_state_benchmarks());
    add(verdict_benchmarks());
    return all;
}

}  // namespace voussoir::app::studies::verify
