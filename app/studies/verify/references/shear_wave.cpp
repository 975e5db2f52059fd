#include "app/studies/verify/references/shear_wave.h"

#include <cmath>

namespace voussoir::app::studies::verify::references
{

double shear_wave(const std::function<double(double)>& base, double speed, double layer, double height,
                  double time)
{
    double u = 0;
    for (int n = 0; 2 * n * layer + height <= speed * time; ++n) {
        const double sign = n % 2 == 0 ? 1 : -1;
        u += sign * base(time - (2 * n * layer + height) / speed);
        u += sign * base(time - (2 * (n + 1) * layer - height) / speed);
    }
    return u;
}

double jointed_shear_modulus(double shear_modulus, double joint_stiffness, double depth)
{
    return 1 / (1 / shear_modulus + 1 / (joint_stiffness * depth));
}

double lag_of(const std::vector<double>& trace, const std::function<double(double)>& original, double time_step)
{
    const auto misfit = [&](double shift) {
        double sum = 0;
        for (std::size_t i = 0; i < trace.size(); ++i) {
            const double difference = trace[i] - original(static_cast<double>(i) * time_step - shift);
            sum += difference * difference;
        }
        return sum;
    };
    double best = 0, reach = 0.02 * time_step * static_cast<double>(trace.size());
    for (; reach > 1e-3 * time_step; reach *= 0.25) {
        double least = INFINITY, place = best;
        for (int i = -8; i <= 8; ++i) {
            const double shift = best + reach * i / 8, value = misfit(shift);
            if (value < least) {
                least = value;
                place = shift;
            }
        }
        best = place;
    }
    return best;
}

}  // namespace voussoir::app::studies::verify::references
