#include "app/studies/stability/references/block_on_springs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace voussoir::app::studies::stability::references
{
namespace
{

constexpr double largest_step = 1e-5;        // s
constexpr double share_of_time_unit = 0.05;  // of 1/omega

struct Edge {
    double x = 0;     // m
    double slip = 0;  // m, elongation of the shear spring
};

struct Motion {
    double x = 0, z = 0, lean = 0;
    double speed_x = 0, speed_z = 0, spin = 0;
    std::array<Edge, 2> edges;
};

struct Acceleration {
    double x = 0, z = 0, lean = 0;
};

double ground_acceleration(const SpringBlock& block, double time)
{
    return time < block.pulse_end ? block.amplitude * std::sin(2 * std::numbers::pi * time / block.period) : 0;
}

/// Moves the shear springs along with the edges, and sums the forces.
Acceleration accelerate(const SpringBlock& block, double time, Motion& now)
{
    const double c = std::cos(now.lean), s = std::sin(now.lean);
    double force_x = -block.mass * ground_acceleration(block, time), force_z = -block.mass * block.gravity;
    double moment = 0;
    for (int i = 0; i < 2; ++i) {
        Edge& edge = now.edges[i];
        const double along = i == 0 ? -block.half_width : block.half_width;
        const double arm_x = along * c - block.half_height * s, arm_z = -along * s - block.half_height * c;
        const double moved = now.x + arm_x - edge.x;
        edge.x += moved;
        const double normal = block.normal_stiffness * std::max(0.0, -(now.z + arm_z));
        const double most = block.friction * normal / block.shear_stiffness;
        edge.slip = std::clamp(edge.slip + moved, -most, most);
        const double shear = -block.shear_stiffness * edge.slip;
        force_x += shear;
        force_z += normal;
        moment += arm_z * shear - arm_x * normal;
    }
    return {force_x / block.mass, force_z / block.mass, moment / block.inertia};
}

/// On the edge it leans on.
Motion leaning(const SpringBlock& block)
{
    Motion start;
    start.lean = block.start_lean;
    const double c = std::cos(start.lean), s = std::sin(start.lean);
    start.z = block.half_width * std::abs(s) + block.half_height * c - start_sink(block);
    for (int i = 0; i < 2; ++i)
        start.edges[i].x = (i == 0 ? -block.half_width : block.half_width) * c - block.half_height * s;
    return start;
}

Motion at_rest(const SpringBlock& block)
{
    if (block.start_lean != 0) return leaning(block);
    Motion start;
    start.z = block.half_height - block.mass * block.gravity / (2 * block.normal_stiffness);
    start.edges[0].x = -block.half_width;
    start.edges[1].x = block.half_width;
    return start;
}

double step_for(const SpringBlock& block)
{
    const double radius_2 = block.half_width * block.half_width + block.half_height * block.half_height;
    const double lightest = 1 / (1 / block.mass + radius_2 / block.inertia);  // what one edge feels
    const double omega = std::sqrt(2 * std::max(block.normal_stiffness, block.shear_stiffness) / lightest);
    return std::min(largest_step, share_of_time_unit / omega);
}

void step(const SpringBlock& block, double time, double h, Motion& now, Acceleration& a)
{
    now.speed_x += 0.5 * h * a.x;
    now.speed_z += 0.5 * h * a.z;
    now.spin += 0.5 * h * a.lean;
    now.x += h * now.speed_x;
    now.z += h * now.speed_z;
    now.lean += h * now.spin;
    a = accelerate(block, time + h, now);
    now.speed_x += 0.5 * h * a.x;
    now.speed_z += 0.5 * h * a.z;
    now.spin += 0.5 * h * a.lean;
}

}  // namespace

double start_sink(const SpringBlock& block)
{
    const double off_edge = std::atan2(block.half_width, block.half_height) - std::abs(block.start_lean);
    const double radius_2 = block.half_width * block.half_width + block.half_height * block.half_height;
    const double share = block.mass * radius_2 / (block.inertia + block.mass * radius_2);
    return block.mass * block.gravity * (1 - share * std::pow(std::sin(off_edge), 2)) / block.normal_stiffness;
}

std::vector<SpringBlockPoint> block_on_springs(const SpringBlock& block, const std::vector<double>& times)
{
    Motion now = at_rest(block);
    Acceleration a = accelerate(block, 0, now);
    const double nominal = step_for(block);
    double time = 0;
    std::vector<SpringBlockPoint> points;
    points.reserve(times.size());
    for (const double end : times) {
        const double start = time;
        const auto steps = static_cast<long>(std::ceil((end - start) / nominal));
        for (long n = 0; n < steps; ++n)
            step(block, start + (end - start) * static_cast<double>(n) / static_cast<double>(steps),
                 (end - start) / static_cast<double>(steps), now, a);
        time = end;
        points.push_back({now.x, now.lean});
    }
    return points;
}

}  // namespace voussoir::app::studies::stability::references
