// Damping that does not depend on frequency: a material's memory of its strain.
#pragma once

#include <complex>
#include <vector>

namespace voussoir
{

/// A spring and a dashpot in a row, beside a material's own elasticity: the stress `share` C (E - q), q the strain
/// of the dashpot, dq/dt = (E - q) / time.
struct MaxwellBranch {
    double share = 0;  // -, of the elasticity of the material
    double time = 0;   // s
};

/// Modulus at the angular frequency omega [1/s], over that at rest: 1 + sum share i omega time / (1 + i omega
/// time).
std::complex<double> modulus_over_rest(const std::vector<MaxwellBranch>& branches, double omega);

/// Damping ratio at the angular frequency omega [1/s]: half the imaginary part of the modulus over the real one.
double damping_ratio_of(const std::vector<MaxwellBranch>& branches, double omega);

constexpr double most_hysteretic_ratio = 0.2;  ///< What `hysteretic_branches` takes.
constexpr double widest_band = 1e4;            ///< Highest frequency over the lowest, likewise.
/// By how much of itself the ratio of `hysteretic_branches` may differ from what was asked, within the band.
constexpr double hysteretic_ripple = 0.005;

/// The fewest branches whose damping ratio is the same within a band of frequencies [Hz], up to hysteretic_ripple.
/// Source: docs/method.md, Damping of blocks. @param ratio in (0, most_hysteretic_ratio]
/// @returns none if there are none, which arguments within these bounds do not meet
std::vector<MaxwellBranch> hysteretic_branches(double ratio, double lowest, double highest);

}  // namespace voussoir
