// A scene in each engine.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "tests/peers/scenes.h"

namespace voussoir::peers
{

/// What is varied. A direct solver has no iterations, voussoir decides on its own.
struct Setting {
    std::string engine;    // voussoir, bullet, bullet-anchored, bullet-direct, ode-quick, ode-direct
    double time_step = 0;  // s
    int iterations = 0;    // of the contact solver in each step
};

/// Where a block is: its centroid [m], and what turns its axes from where they were at first.
struct Place {
    Eigen::Vector3d centroid;
    Eigen::Matrix3d turn;
};
using PlaceOf = std::function<Place(int block)>;

/// Called when the motion begins (time 0) and after each of its steps. @returns false when enough was seen
using Watch = std::function<bool(double time, const PlaceOf&)>;

/// @returns why the engine did not come to the end; empty: it did
std::string run_voussoir(const Scene& scene, const Setting& setting, const Watch& watch);
std::string run_bullet(const Scene& scene, const Setting& setting, const Watch& watch);
std::string run_ode(const Scene& scene, const Setting& setting, const Watch& watch);

/// What pushes all blocks of a scene in a step: the mean over it [m/s2].
inline Eigen::Vector3d mean_push(const Scene& scene, double from, double to)
{
    Eigen::Vector3d push = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 2; ++axis)
        if (const auto& motion = scene.push[axis])
            push[axis] = (motion->velocity(to) - motion->velocity(from)) / (to - from);
    return push;
}

/// Integral of r^2 1 - r r^T over the mass of a block about its centroid [kg m2].
inline Eigen::Matrix3d inertia_of(const Model& model, int block)
{
    const Eigen::Matrix3d second = model.mass_second(block);
    return second.trace() * Eigen::Matrix3d::Identity() - second;
}

/// Steps an engine that has no static stage through rest and motion.
/// @param step takes what pushes [m/s2]; @returns what run_* do
std::string march(const Scene& scene, double h, const std::function<void(const Eigen::Vector3d&)>& step,
                  const PlaceOf& place_of, const Watch& watch);

}  // namespace voussoir::peers
