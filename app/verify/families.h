// The families of benchmarks, each made in files of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "app/verify/benchmark.h"

namespace voussoir
{

/// A block dropped from 3 m: what a bounce costs; and the settled penetration. Source: li.
std::vector<Benchmark> impact_benchmarks();

/// A rocking block: overturning threshold, motion before and after the first impact. Source:
/// yagoda-biran-hatzor 3.3.
std::vector<Benchmark> rocking_benchmarks();

/// First motion of a block on an incline. Source: yagoda-biran-hatzor 3.2. @param seed of the points of the chart
std::vector<Benchmark> mode_chart_benchmarks(std::uint64_t seed);

/// Shear waves through stacked layers and the response of 15 layers. Source: yagoda-biran-hatzor 3.5.
std::vector<Benchmark> wave_benchmarks();

/// A slender tower of 100 courses. Source: ma.
std::vector<Benchmark> tower_benchmarks();

/// A mass under a constant force with damping per step and per second. Source: yagoda-biran-hatzor 4.2.2.
std::vector<Benchmark> kinetic_damping_benchmarks();

}  // namespace voussoir
