#include "app/studies/verify/references/smooth_ode.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voussoir::app::studies::verify::references
{

using Eigen::VectorXd;

namespace
{

struct Trial {
    VectorXd y;
    double error = 0;  // estimate / allowed
};

Trial try_step(const Derivative& f, double t, const VectorXd& y, double h, double tolerance)
{
    static constexpr std::array<double, 7> c{0, 0.2, 0.3, 0.8, 8.0 / 9, 1, 1};
    static constexpr double a[7][6] = {{},
                                       {1.0 / 5},
                                       {3.0 / 40, 9.0 / 40},
                                       {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                       {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                       {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                       {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
    static constexpr std::array<double, 7> fourth{
        5179.0 / 57600, 0, 7571.0 / 16695, 393.0 / 640, -92097.0 / 339200, 187.0 / 2100, 1.0 / 40};
    std::array<VectorXd, 7> k;
    VectorXd stage = y;
    for (int i = 0; i < 7; ++i) {
        stage = y;
        for (int j = 0; j < i; ++j) stage += h * a[i][j] * k[j];
        k[i] = f(t + c[i] * h, stage);
    }
    VectorXd lower = y;
    for (int i = 0; i < 7; ++i) lower += h * fourth[i] * k[i];
    Trial trial{stage, 0};  // the last stage is the fifth-order solution
    for (Eigen::Index i = 0; i < y.size(); ++i)
        trial.error = std::max(trial.error, std::abs(stage[i] - lower[i]) / (tolerance * (1 + std::abs(y[i]))));
    return trial;
}

/// The step length in (0, h] at which the event is zero: bisection, for 1e-16 of the step costs 52 halvings only.
double length_to_event(const Derivative& f, const OdePoint& start, double h, const Event& event)
{
    double low = 0, high = h;
    for (int i = 0; i < 60 && low < high; ++i) {
        const double middle = 0.5 * (low + high);
        const VectorXd y = try_step(f, start.time, start.y, middle, 1).y;
        (event(start.time + middle, y) > 0 ? low : high) = middle;
    }
    return high;
}

}  // namespace

bool integrate(const Derivative& f, double end, double tolerance, const Event& event, OdePoint& point)
{
    double h = point.next_step > 0 ? point.next_step : std::min(1e-4, end - point.time);
    while (point.time < end) {
        const bool last = point.time + h >= end;
        const double length = last ? end - point.time : h;
        const Trial trial = try_step(f, point.time, point.y, length, tolerance);
        const double change = 0.9 * std::pow(std::max(trial.error, 1e-10), -0.2);
        if (trial.error > 1) {
            h = length * std::clamp(change, 0.1, 0.9);
            continue;
        }
        if (event && event(point.time, point.y) > 0 && event(point.time + length, trial.y) <= 0) {
            const double cut = length_to_event(f, point, length, event);
            point.y = try_step(f, point.time, point.y, cut, 1).y;
            point.time += cut;
            point.next_step = 0;
            return true;
        }
        point.y = trial.y;
        point.time = last ? end : point.time + length;
        if (!last || trial.error > 0.1) h = length * std::clamp(change, 0.2, 5.0);
    }
    point.next_step = h;
    return false;
}

}  // namespace voussoir::app::studies::verify::references
