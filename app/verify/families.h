// The families of benchmarks: one function each, in files of their own. To add one: its line here, its line in
// benchmarks.cpp, its sources in CMakeLists.txt.
#pragma once

#include <cstdint>
#include <vector>

#include "app/verify/benchmark.h"

namespace voussoir
{

std::vector<Benchmark> incline_benchmarks();        // gravity, start velocity, sine
std::vector<Benchmark> two_direction_benchmarks();  // dip and strike at once
std::vector<Benchmark> wedge_benchmarks();          // on two planes at once
std::vector<Benchmark> foundation_benchmarks();     // on a base that moves in one, two, three directions
std::vector<Benchmark> three_sines_benchmarks();    // of Tsesarsky
std::vector<Benchmark> shaking_table_benchmarks();  // Wartman's tests in Tsesarsky
std::vector<Benchmark> two_blocks_benchmarks();     // of Ma
std::vector<Benchmark> other_incline_benchmarks();  // of Li and Khan

}  // namespace voussoir
