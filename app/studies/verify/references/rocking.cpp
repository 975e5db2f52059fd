#include "app/studies/verify/references/rocking.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/references/smooth_ode.h"

namespace voussoir::app::studies::verify::references
{

using Eigen::VectorXd;

namespace
{

constexpr double tolerance = 1e-12;  // of an integration step
constexpr double at_rest = 1e-6;     // rad/s, slower than this the block stands
constexpr double fallen = 0.5 * std::numbers::pi;
constexpr double horizon = 20;  // s, to see an overturning that hesitates

double pulse_end(const RockingBlock& block)
{
    return 0.5 / block.frequency;
}

double ground(const RockingBlock& block, double t)
{
    return t <= pulse_end(block) ? block.amplitude * std::sin(2 * std::numbers::pi * block.frequency * t) : 0;
}

/// theta'' on the side +1 or -1 (the sign of theta).
double turning(const RockingBlock& block, double side, double theta, double ground_acceleration)
{
    const double radius = std::hypot(block.half_width, block.half_height);
    const double p2 = 0.75 * block.gravity / radius, alpha = slenderness(block);
    const double lean = side * alpha - theta, a = ground_acceleration / block.gravity;
    if (block.linear) return -p2 * (lean + a);
    return -p2 * (std::sin(lean) + a * std::cos(lean));
}

/// The block between two impacts, or standing.
struct Rocking {
    OdePoint point;   // y = (theta, theta')
    double side = 0;  // 0: stands
    bool overturned = false;
    int impacts = 0;
    double last_impact = 0;
};

double uplift_time(const RockingBlock& block)
{
    const double least =
        block.linear ? block.gravity * slenderness(block) : block.gravity * block.half_width / block.half_height;
    if (block.amplitude <= least) return INFINITY;
    return std::asin(least / block.amplitude) / (2 * std::numbers::pi * block.frequency);
}

/// Lets the block rock to `end`, with no kink of the ground motion between.
void rock(const RockingBlock& block, double end, Rocking& now)
{
    while (now.point.time < end && !now.overturned) {
        if (now.side == 0) {
            now.point.time = end;
            return;
        }
        const double side = now.side;
        const Derivative f = [&](double t, const VectorXd& y) {
            return VectorXd{{y[1], turning(block, side, y[0], ground(block, t))}};
        };
        const Event returns = [&](double, const VectorXd& y) {
            return std::min(side * y[0], fallen - side * y[0]);
        };
        if (!integrate(f, end, tolerance, returns, now.point)) return;
        now.overturned = side * now.point.y[0] > 0.5 * fallen;
        if (now.overturned) return;
        ++now.impacts;
        now.last_impact = now.point.time;
        now.point.y = VectorXd{{0, housner_restitution(block) * now.point.y[1]}};
        now.side = std::abs(now.point.y[1]) < at_rest ? 0 : -side;
        // A first step well inside the next swing, or the swing would come and go unseen.
        const double pull = std::abs(turning(block, -side, 0, ground(block, now.point.time)));
        now.point.next_step = 0.1 * std::abs(now.point.y[1]) / pull;
    }
}

/// To `end` through the kinks: uplift and the end of the pulse. (A block that came to rest within the pulse would
/// stay.)
void advance(const RockingBlock& block, double end, Rocking& now)
{
    const double lift = uplift_time(block), pause = pulse_end(block);
    for (const double stop : {std::min(lift, end), std::min(pause, end), end}) {
        if (stop > now.point.time) {
            rock(block, stop, now);
        }
        if (now.point.time == lift && now.side == 0 && now.impacts == 0)
            now.side = -1;  // away from the acceleration
    }
}

Rocking standing()
{
    Rocking now;
    now.point.y = VectorXd::Zero(2);
    return now;
}

}  // namespace

double slenderness(const RockingBlock& block)
{
    return std::atan2(block.half_width, block.half_height);
}

double housner_restitution(const RockingBlock& block)
{
    return 1 - 1.5 * std::pow(std::sin(slenderness(block)), 2);
}

std::vector<double> rocking_angles(const RockingBlock& block, const std::vector<double>& times)
{
    Rocking now = standing();
    std::vector<double> angles;
    for (const double t : times) {
        advance(block, t, now);
        angles.push_back(now.point.y[0]);
    }
    return angles;
}

std::optional<double> first_impact(const RockingBlock& block)
{
    Rocking now = standing();
    for (double t = 0.01; t < horizon && !now.overturned; t += 0.01) {
        advance(block, t, now);
        if (now.impacts > 0) return now.last_impact;
    }
    return std::nullopt;
}

double overturning_threshold(RockingBlock block)
{
    double stands = block.gravity * std::tan(slenderness(block)), falls = 10 * stands;
    while (falls - stands > 1e-9) {
        block.amplitude = 0.5 * (stands + falls);
        (first_impact(block) ? stands : falls) = block.amplitude;
    }
    return 0.5 * (stands + falls);
}

double restitution_between(const RockingBlock& block, double before, double after)
{
    const double alpha = slenderness(block);
    const auto energy = [&](double apex) { return std::cos(alpha - apex) - std::cos(alpha); };
    return std::sqrt(energy(after) / energy(before));
}

}  // namespace voussoir::app::studies::verify::references
