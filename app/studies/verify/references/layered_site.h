// Vertical shear waves in elastic layers on a rigid base: the exact response in the frequency domain.
#pragma once

#include <complex>
#include <vector>

namespace voussoir::app::studies::verify::references
{

/// A layer, and the joint below it. Listed from the base upwards.
struct SiteLayer {
    double thickness = 0;        // m
    double density = 0;          // kg/m3
    double shear_modulus = 0;    // Pa
    double joint_stiffness = 0;  // Pa/m, shear, of the joint under the layer; infinite when bonded without one
};

/// Surface motion / base motion at a frequency: transfer matrices of displacement and shear stress from the free
/// surface down, with all stiffnesses times 1 + 2 i xi(f). @param frequency [Hz]
/// @param relaxation 2 xi / omega [s]; h / 2 for Newmark (1/2, 1), whose damping ratio is omega h / 4
/// Source: [Kramer1996], 7.2.1 (layers); the damping of the integrator: docs/method.md
std::complex<double> amplification(const std::vector<SiteLayer>& layers, double frequency, double relaxation);

struct Peak {
    double frequency = 0;  // Hz
    double value = 0;      // -
};

/// Local maxima of sampled |ratio|, each refined by a parabola through three samples.
/// @param values at frequencies first, first + interval, ...
std::vector<Peak> peaks_of(const std::vector<double>& values, double first, double interval);

/// Finite Fourier integral of a sampled record at a frequency (rectangle rule). @returns [unit of samples x s]
std::complex<double> fourier(const std::vector<double>& samples, double time_step, double frequency);

}  // namespace voussoir::app::studies::verify::references
