// The families of benchmarks: one function each, in files of their own. To add one: its line here, its line in
// benchmarks.cpp, its sources in CMakeLists.txt.
#pragma once

#include <cstdint>
#include <vector>

#include "app/studies/verify/benchmark.h"

namespace voussoir::app::studies::verify
{

std::vector<Benchmark> incline_benchmarks();        // gravity, start velocity, sine
std::vector<Benchmark> two_direction_benchmarks();  // dip and strike at once
std::vector<Benchmark> wedge_benchmarks();          // on two planes at once
std::vector<Benchmark> foundation_benchmarks();     // on a base that moves in one, two, three directions
std::vector<Benchmark> many_blocks_benchmarks();    // the same with up to 200 blocks
std::vector<Benchmark> three_sines_benchmarks();    // [Tsesarsky2002]
std::vector<Benchmark> shaking_table_benchmarks();  // [Wartman1999] in [Tsesarsky2002]
std::vector<Benchmark> two_blocks_benchmarks();     // [Ma1996]
std::vector<Benchmark> other_incline_benchmarks();  // [Li2017], [KhanSoftContact]

/// A block dropped from 3 m: what a bounce costs; and the settled penetration. Source: [Li2017].
std::vector<Benchmark> impact_benchmarks();

/// A rocking block: overturning threshold, motion before and after the first impact.
/// Source: [YagodaBiranHatzor2017], 3.3.
std::vector<Benchmark> rocking_benchmarks();

/// Order in the time step before the first impact, and Housner's impacts, at the program's defaults.
std::vector<Benchmark> rocking_default_benchmarks();

/// First motion of a block on an incline. Source: [YagodaBiranHatzor2017], 3.2.
/// @param seed of the points of the chart
std::vector<Benchmark> mode_chart_benchmarks(std::uint64_t seed);

/// Shear waves through stacked layers and the response of 15 layers. Source: [YagodaBiranHatzor2017], 3.5.
std::vector<Benchmark> wave_benchmarks();

/// Bonded rods, layers at resonance and a tower that vibrates, at the program's defaults.
std::vector<Benchmark> vibration_benchmarks();

/// Joints that rest on points inside their faces: bending and torsion.
std::vector<Benchmark> face_benchmarks();

/// Joints that give way linearly and open.
std::vector<Benchmark> linear_face_benchmarks();

/// Columns of stones that bend.
std::vector<Benchmark> column_benchmarks();

/// An arch and a frame of stones that bend.
std::vector<Benchmark> frame_benchmarks();

/// Waves through viscous boundaries, layers on rock, and Rayleigh's damping.
std::vector<Benchmark> ground_benchmarks();

/// Rods and dowels.
std::vector<Benchmark> bar_benchmarks();

/// A slender tower of 100 courses. Source: [Ma1996].
std::vector<Benchmark> tower_benchmarks();

/// Mosca's bridge. Source: [Ma1996].
std::vector<Benchmark> bridge_benchmarks();

std::vector<Benchmark> vault_benchmarks();        // domes and barrel vaults under their own weight
std::vector<Benchmark> cross_vault_benchmarks();  // cross vaults

/// Openings and slips of joints against geometry: a rocking block, an arch with four hinges, a sheared bond.
std::vector<Benchmark> opening_benchmarks();

/// Lateral capacities, a least thickness and a bridge that stays closed, beside limit analysis.
std::vector<Benchmark> limit_state_benchmarks();

/// What is said of random structures on both sides of their limit.
std::vector<Benchmark> verdict_benchmarks();

/// A mass under a constant force with damping per step and per second. Source: [YagodaBiranHatzor2017], 4.2.2.
std::vector<Benchmark> kinetic_damping_benchmarks();

}  // namespace voussoir::app::studies::verify
