#include "app/studies/verify/references/sliding.h"

#include <algorithm>
#include <cmath>

namespace voussoir::app::studies::verify::references
{
namespace
{

using Eigen::Vector2d;
using Vector4 = Eigen::Vector4d;  // displacement, velocity

constexpr double stopped = 1e-11;         // m/s; a block slower than this is at rest or starts anew
constexpr double local_error = 1e-13;     // m and m/s per step
constexpr double longest_step = 2e-3;     // s
constexpr double scan_step = 1e-4;        // s, between looks at the load of a block that sticks
constexpr double first_time_step = 1e-6;  // s
constexpr double first_moment = 5e-5;     // s, see start()
constexpr double least_excess = 1e-9;     // m/s2; below it a load has not overcome friction

/// A block and the clock it lives by.
struct Slider {
    const SlidingProblem& problem;
    double time = 0, next_step = first_time_step;
    Vector4 state = Vector4::Zero();
    bool slips = false;

    /// Load above friction of a block at rest [m/s2]; it slips where this is > 0.
    double excess(double t) const
    {
        return problem.driving(t).norm() - problem.friction * problem.pressing(t) - least_excess;
    }

    double friction(double speed) const
    {
        return problem.friction_at ? problem.friction_at(speed) : problem.friction;
    }

    Vector4 rate(double t, const Vector4& y) const
    {
        const Vector2d velocity = y.tail<2>(), driving = problem.driving(t);
        const Vector2d direction = velocity.norm() > 0 ? velocity : driving;
        const Vector2d change = driving - friction(velocity.norm()) * problem.pressing(t) * direction.normalized();
        return {velocity.x(), velocity.y(), change.x(), change.y()};
    }
};

/// One step of Dormand and Prince's 5(4) pair. @returns the fifth-order state; `error` the difference of the two
Vector4 dormand_prince(const Slider& slider, double h, double& error)
{
    const double t = slider.time;
    const Vector4& y = slider.state;
    const Vector4 k1 = slider.rate(t, y);
    const Vector4 k2 = slider.rate(t + h / 5, y + h * k1 / 5);
    const Vector4 k3 = slider.rate(t + h * 3 / 10, y + h * (3 * k1 / 40 + 9 * k2 / 40));
    const Vector4 k4 = slider.rate(t + h * 4 / 5, y + h * (44 * k1 / 45 - 56 * k2 / 15 + 32 * k3 / 9));
    const Vector4 k5 = slider.rate(
        t + h * 8 / 9, y + h * (19372 * k1 / 6561 - 25360 * k2 / 2187 + 64448 * k3 / 6561 - 212 * k4 / 729));
    const Vector4 k6 = slider.rate(
        t + h, y + h * (9017 * k1 / 3168 - 355 * k2 / 33 + 46732 * k3 / 5247 + 49 * k4 / 176 - 5103 * k5 / 18656));
    const Vector4 end =
        y + h * (35 * k1 / 384 + 500 * k3 / 1113 + 125 * k4 / 192 - 2187 * k5 / 6784 + 11 * k6 / 84);
    const Vector4 k7 = slider.rate(t + h, end);
    error =
        (h * (71 * k1 / 57600 - 71 * k3 / 16695 + 71 * k4 / 1920 - 17253 * k5 / 339200 + 22 * k6 / 525 - k7 / 40))
            .cwiseAbs()
            .maxCoeff();
    return end;
}

/// A block that has just stopped, or stands, starts where the load exceeds friction.
void let_go(Slider& slider)
{
    slider.slips = true;
    slider.state.tail<2>() = stopped * slider.problem.driving(slider.time).normalized();
    slider.next_step = 1e-12;
}

/// Starts from a stand as the load overcomes friction. While it is slow its slip follows the direction of the load
/// (its lag, velocity over load, is of the order of 1e-8), which makes the full equation stiff: so the first
/// moment is taken with that direction, the speed by Simpson's rule.
void start(Slider& slider, double end)
{
    const double t = slider.time, h = std::min(first_moment, end - t);
    const double speed = h / 6 * (slider.excess(t) + 4 * slider.excess(t + h / 2) + slider.excess(t + h));
    slider.time = t + h;
    if (speed <= stopped) return;
    const Vector2d direction = slider.problem.driving(slider.time).normalized();
    slider.state.head<2>() += speed * h / 3 * direction;
    slider.state.tail<2>() = speed * direction;
    slider.slips = true;
    slider.next_step = 1e-9;
}

/// Stands until `end` or until the load exceeds friction.
void stand(Slider& slider, double end)
{
    slider.state.tail<2>().setZero();
    while (slider.time < end) {
        const double next = std::min(end, slider.time + scan_step);
        if (slider.excess(next) <= 0) {
            slider.time = next;
            continue;
        }
        double holds = slider.time, fails = next;
        while (fails - holds > 1e-14 * std::max(1.0, fails)) {
            const double middle = (holds + fails) / 2;
            (slider.excess(middle) > 0 ? fails : holds) = middle;
        }
        slider.time = fails;
        return start(slider, end);
    }
}

/// Slips until `end` or until it stops.
void slip(Slider& slider, double end)
{
    while (slider.time < end) {
        const bool is_last = slider.time + slider.next_step >= end;
        const double h = is_last ? end - slider.time : slider.next_step;
        double error = 0;
        const Vector4 next = dormand_prince(slider, h, error);
        const bool turned = next.tail<2>().dot(slider.state.tail<2>()) <= 0;
        if (turned && slider.state.tail<2>().norm() <= 2 * stopped) break;
        const double growth = std::clamp(0.9 * std::pow(local_error / std::max(error, 1e-30), 0.2), 0.2, 4.0);
        if (turned || error > local_error) {
            slider.next_step = h * (turned ? std::min(growth, 0.5) : growth);
            // Rounding, not the method, is what is left below this.
            if (slider.next_step > 1e-15) continue;
            break;
        }
        slider.time = is_last ? end : slider.time + h;
        slider.state = next;
        if (!is_last || growth < 1) slider.next_step = std::min(h * growth, longest_step);
        if (slider.state.tail<2>().norm() < stopped) break;
    }
    if (slider.time >= end && slider.state.tail<2>().norm() > stopped) return;
    slider.slips = false;
    if (slider.excess(slider.time) > 0) let_go(slider);
}

}  // namespace

std::vector<SlidingPoint> slide(const SlidingProblem& problem, const std::vector<double>& times)
{
    Slider slider{problem};
    slider.state.tail<2>() = problem.start_velocity;
    slider.slips = problem.start_velocity.norm() > stopped;
    if (!slider.slips && slider.excess(0) > 0) let_go(slider);
    std::vector<SlidingPoint> points;
    for (const double time : times) {
        while (slider.time < time) slider.slips ? slip(slider, time) : stand(slider, time);
        points.push_back({slider.state.head<2>(), slider.state.tail<2>(), slider.slips});
    }
    return points;
}

double incline_displacement(double gravity, double angle, double friction_angle, double velocity, double time)
{
    const double acceleration = gravity * (std::sin(angle) - std::cos(angle) * std::tan(friction_angle));
    return acceleration * time * time / 2 + velocity * time;
}

double wedge_friction(double left, double right, double friction_angle)
{
    return std::tan(friction_angle) * (std::sin(left) + std::sin(right)) / std::sin(left + right);
}

double sum_of_sines_displacement(const std::vector<Vector2d>& amplitude_and_omega, double time)
{
    double sum = 0;
    for (const Vector2d& term : amplitude_and_omega) {
        const double phase = term[1] * time;
        sum += term[0] / (term[1] * term[1]) * (phase - std::sin(phase));
    }
    return sum;
}

}  // namespace voussoir::app::studies::verify::references
