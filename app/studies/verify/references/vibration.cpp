#include "app/studies/verify/references/vibration.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace voussoir::app::studies::verify::references
{

using std::numbers::pi;

double rod_frequency(int elements, double speed, double height)
{
    const double t = pi / (2 * elements), length = height / elements;
    return std::sqrt(6 * (1 - std::cos(t)) / (2 + std::cos(t))) * speed / length / (2 * pi);
}

double layer_amplitude(double speed, double height, double rate, double frequency)
{
    const double omega = 2 * pi * frequency;
    const std::complex<double> square = std::complex<double>(omega * omega, -omega * rate) / (speed * speed);
    return std::abs(omega * omega / (speed * speed * square) * (1.0 / std::cos(std::sqrt(square) * height) - 1.0));
}

}  // namespace voussoir::app::studies::verify::references
