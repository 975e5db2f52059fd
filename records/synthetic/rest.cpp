#include "records/synthetic/rest.h"

namespace voussoir::records::synthetic
{

namespace
{

/// Velocity and displacement at the end of a piecewise linear acceleration sampled at unit steps.
struct Residual {
    double velocity = 0, displacement = 0;
};

Residual residual(const std::vector<double>& samples)
{
    Residual end;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        end.displacement += end.velocity + (2 * samples[i] + samples[i + 1]) / 6;
        end.velocity += (samples[i] + samples[i + 1]) / 2;
    }
    return end;
}

}  // namespace

void bring_to_rest(std::vector<double>& samples)
{
    const auto last = static_cast<double>(samples.size() - 1);
    std::vector<double> b0(samples.size()), b1(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double x = static_cast<double>(i) / last;
        b0[i] = x * x * (1 - x) * (1 - x);
        b1[i] = x * b0[i];
    }
    const Residual r = residual(samples), r0 = residual(b0), r1 = residual(b1);
    const double determinant = r0.velocity * r1.displacement - r1.velocity * r0.displacement;
    const double c0 = (r1.velocity * r.displacement - r.velocity * r1.displacement) / determinant;
    const double c1 = (r.velocity * r0.displacement - r0.velocity * r.displacement) / determinant;
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += c0 * b0[i] + c1 * b1[i];
}

}  // namespace voussoir::records::synthetic
