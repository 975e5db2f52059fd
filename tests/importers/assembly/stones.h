// Small assemblies for the tests.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "importers/assembly/assembly.h"
#include "libdda/geometry/moments.h"

namespace voussoir::importers
{

inline assembly::AssemblyStone stone(const std::string& name, ConvexPolyhedron shape)
{
    const double volume = moments_of(shape).volume;
    return {name, {std::move(shape)}, volume, 0, false};
}

inline assembly::AssemblyStone box(const std::string& name, const Eigen::Vector3d& lower,
                                   const Eigen::Vector3d& upper)
{
    return stone(name, make_box(lower, upper));
}

/// A wall in running bond on a slab: courses of bricks 0.4 x 0.2 x 0.2 m, every second shifted by half a brick.
inline std::vector<assembly::AssemblyStone> wall(int courses, int bricks, double head_joint = 0)
{
    std::vector<assembly::AssemblyStone> stones = {box("slab", {0, 0, -0.2}, {0.4 * bricks + 0.2, 0.2, 0})};
    for (int k = 0; k < courses; ++k)
        for (int i = 0; i < bricks; ++i) {
            const double x = 0.4 * i + (k % 2 == 0 ? 0 : 0.2);
            stones.push_back(box("brick_" + std::to_string(k) + "_" + std::to_string(i), {x, 0, 0.2 * k},
                                 {x + 0.4 - head_joint, 0.2, 0.2 * (k + 1)}));
        }
    return stones;
}

/// A semicircular arch of equal voussoirs, width 1 m along y.
inline std::vector<assembly::AssemblyStone> arch(int voussoirs, double inner, double outer)
{
    std::vector<assembly::AssemblyStone> stones;
    for (int i = 0; i < voussoirs; ++i) {
        std::vector<Eigen::Vector3d> v;
        for (const double y : {0.0, 1.0})
            for (const int side : {0, 1})
                for (const double r : {inner, outer}) {
                    const double angle = std::numbers::pi * (i + side) / voussoirs;
                    v.emplace_back(-r * std::cos(angle), y, r * std::sin(angle));
                }
        stones.push_back(
            stone("voussoir_" + std::to_string(i),
                  make_convex_polyhedron(
                      v, {{0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2}, {1, 3, 7, 5}})));
    }
    return stones;
}

inline std::vector<assembly::AssemblyStone> moved(std::vector<assembly::AssemblyStone> stones,
                                                  const Eigen::Isometry3d& motion)
{
    for (assembly::AssemblyStone& each : stones)
        for (ConvexPolyhedron& part : each.parts)
            for (Eigen::Vector3d& x : part.vertices) x = motion * x;
    return stones;
}

inline bool has_finding(const assembly::Assembly& assembly, const std::string& kind)
{
    for (const assembly::AssemblyFinding& finding : assembly.findings)
        if (finding.kind == kind) return true;
    return false;
}

inline const assembly::AssemblyFinding& finding(const assembly::Assembly& assembly, const std::string& kind)
{
    for (const assembly::AssemblyFinding& each : assembly.findings)
        if (each.kind == kind) return each;
    throw std::runtime_error("no finding " + kind);
}

}  // namespace voussoir::importers
