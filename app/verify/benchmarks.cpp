#include <iterator>

#include "app/verify/families.h"

namespace voussoir
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
    add(three_sines_benchmarks());
    add(shaking_table_benchmarks());
    add(other_incline_benchmarks());
    add(two_blocks_benchmarks());
    add(mode_chart_benchmarks(seed));
    add(rocking_benchmarks());
    add(wave_benchmarks());
    add(kinetic_damping_benchmarks());
    add(impact_benchmarks());
    add(tower_benchmarks());
    return all;
}

}  // namespace voussoir
