#include "libdda/run/step_error.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace voussoir::driver
{

namespace
{

constexpr double safety = 0.9;  // of the step that would just do
constexpr double least = 0.2, most = 2;

}  // namespace

std::vector<double> mean_accelerations(const State& before, const State& after, double h)
{
    std::vector<double> result(after.velocities.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = (after.velocities[i] - before.velocities[i]) / h;
    return result;
}

double step_error(const Model& model, const std::vector<double>& earlier, double earlier_h,
                  const std::vector<double>& accelerations, double h)
{
    const int unknowns = static_cast<int>(unknowns_per_block(model.kinematics)),
              dimension = dimension_of(model.kinematics);
    double most = 0;  // m/s2
    for (int block = 0; block < static_cast<int>(model.blocks.size()); ++block) {
        using Values = Eigen::Map<const Eigen::VectorXd>;
        Eigen::VectorXd change = Values(accelerations.data() + block * unknowns, unknowns);
        if (!earlier.empty()) change -= Values(earlier.data() + block * unknowns, unknowns);
        most = std::max(most, change.head(dimension).norm() +
                                  size_of(model, block) * change.tail(unknowns - dimension).norm());
    }
    return h * h * h / 12 * most * 2 / (h + (earlier.empty() ? h : earlier_h));
}

double next_share(double error, double wanted)
{
    return error > 0 ? std::clamp(safety * std::cbrt(wanted / error), least, most) : most;
}

}  // namespace voussoir::driver
