#include "app/studies/verify/references/layered_site.h"

#include <cmath>
#include <numbers>

namespace voussoir::app::studies::verify::references
{

using Complex = std::complex<double>;

Complex amplification(const std::vector<SiteLayer>& layers, double frequency, double relaxation)
{
    const double omega = 2 * std::numbers::pi * frequency;
    const Complex damped(1, omega * relaxation);
    Complex displacement = 1, stress = 0;  // at the free surface
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        const Complex modulus = layer->shear_modulus * damped;
        const Complex wave_number = omega * std::sqrt(layer->density / modulus);
        const Complex c = std::cos(wave_number * layer->thickness), s = std::sin(wave_number * layer->thickness);
        // z upwards: at the bottom u = u_top cos kH - tau_top sin kH / (k G), tau = k G u_top sin kH + tau_top cos
        // kH.
        const Complex below = displacement * c - stress * s / (wave_number * modulus);
        stress = displacement * wave_number * modulus * s + stress * c;
        displacement = below - stress / (layer->joint_stiffness * damped);
    }
    return 1.0 / displacement;
}

std::vector<Peak> peaks_of(const std::vector<double>& values, double first, double interval)
{
    std::vector<Peak> peaks;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const double left = values[i - 1], middle = values[i], right = values[i + 1];
        if (!(middle > left && middle >= right)) continue;
        const double bend = left - 2 * middle + right, shift = 0.5 * (left - right) / bend;
        peaks.push_back(
            {first + interval * (static_cast<double>(i) + shift), middle - 0.25 * (left - right) * shift});
    }
    return peaks;
}

Complex fourier(const std::vector<double>& samples, double time_step, double frequency)
{
    const Complex turn = std::polar(1.0, -2 * std::numbers::pi * frequency * time_step);
    Complex sum = 0, phase = 1;
    for (const double sample : samples) {
        sum += sample * phase;
        phase *= turn;
    }
    return sum * time_step;
}

}  // namespace voussoir::app::studies::verify::references
