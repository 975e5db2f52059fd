// Rigid blocks that slide with Coulomb friction: what the engine's answers are measured against. Knows nothing of
// it.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace voussoir::app::studies::verify::references
{

/// A rigid block on a plane, seen from the plane: w' = driving - friction x pressing x w/|w| while it slips; it
/// sticks while |driving| <= friction x pressing. Newmark's block [Newmark1965], the vector analysis of
/// [BakunMazor2009] and equation 8 of [YagodaBiranHatzor2017] are this with different loads.
struct SlidingProblem {
    std::function<Eigen::Vector2d(double)> driving;  // of time [s]: acceleration in the plane [m/s2]
    std::function<double(double)> pressing;          // of time [s]: acceleration onto the plane [m/s2], > 0
    double friction = 0;                             // -, coefficient; of a block at rest if it depends on speed
    std::function<double(double)> friction_at = {};  // of speed [m/s], if it does; continuous
    Eigen::Vector2d start_velocity = Eigen::Vector2d::Zero();  // m/s
};

struct SlidingPoint {
    Eigen::Vector2d displacement, velocity;  // m, m/s, relative to the plane
    bool slips = false;
};

/// Integrates with Dormand and Prince's pair at a local error of 1e-13; a step never passes a reversal or a stop
/// of the slip (its direction may not turn by more than a right angle), and slip starts where the load is found to
/// exceed friction by bisection. Global error below 1e-8 of the largest displacement (tested).
/// @param times (n) [s], ascending, >= 0. @returns (n)
std::vector<SlidingPoint> slide(const SlidingProblem& problem, const std::vector<double>& times);

/// s = g (sin a - cos a tan phi) t^2 / 2 + v t: equations 4 and 5 of Yagoda-Biran and Hatzor. Angles in rad.
double incline_displacement(double gravity, double angle, double friction_angle, double velocity, double time);

/// Friction coefficient of a plane that resists like two planes which dip by `left` and `right` [rad] across their
/// line of intersection. Source: [GoodmanShi1985]; it is the equilibrium of the wedge across the line.
double wedge_friction(double left, double right, double friction_angle);

/// Displacement of a block under a sum of sines a_i sin(w_i t) [m/s2, rad/s] that never reverses:
/// sum a_i / w_i^2 (w_i t - sin w_i t). Source: [Tsesarsky2002], equation 7 with theta = 0.
double sum_of_sines_displacement(const std::vector<Eigen::Vector2d>& amplitude_and_omega, double time);

}  // namespace voussoir::app::studies::verify::references
