// What a work-precision diagram varies, in words and in lists.
#pragma once

#include <string>
#include <vector>

#include "app/studies/verify/benchmark.h"

namespace voussoir::app::studies::verify
{

/// "spatial rigid, Newmark", with ", published iteration" where it is Shi's.
std::string method_name(const scenes::SceneSetting& setting);

/// The setting of a row that is held against values which a paper computed: Newmark (1/2, 1), impacts left to
/// springs, and these as stiff as the papers choose them where they print nothing.
scenes::SceneSetting as_in_papers(scenes::SceneSetting setting);

/// Time steps x methods (rigid and deformable, that of the papers, their open-close iteration), then the contact
/// stiffnesses at the default time step.
/// @param time_steps [s]; @param stiffness_factors times the documented default
std::vector<scenes::SceneSetting> standard_sweep(const std::vector<double>& time_steps,
                                                 const std::vector<double>& stiffness_factors = {});

/// Makes a planar benchmark of one whose scene lies in the x-z plane, its sweep too. Beside it stand the
/// one-block-thick spatial scene and, with `other_blocks`, both with deformable blocks instead of rigid ones or
/// the other way round.
void make_planar(Benchmark& benchmark, bool other_blocks = true);
std::vector<Benchmark> made_planar(std::vector<Benchmark> benchmarks, bool other_blocks = true);

/// Stands the planar scene beside the spatial one of a benchmark whose scene lies in the x-z plane.
void add_planar(Benchmark& benchmark);
std::vector<Benchmark> with_planar(std::vector<Benchmark> benchmarks);

/// Time steps of the sliding benchmarks [s].
inline const std::vector<double> sliding_steps{1e-2, 5e-3, 2.5e-3, 1e-3, 5e-4, 2.5e-4};

}  // namespace voussoir::app::studies::verify
