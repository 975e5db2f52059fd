#include "importers/patterns/vault_ribs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "importers/patterns/circular_arc.h"
#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{
namespace
{

constexpr std::array<std::pair<const char*, std::array<int, 2>>, 4> quadrants{
    {{"ne", {1, 1}}, {"nw", {-1, 1}}, {"sw", {-1, -1}}, {"se", {1, -1}}}};

double reach_of(const CrossVault& vault)
{
    return vault.rib_width /
           std::numbers::sqrt2;  // m, along the axis of a web, from the groin to the face of a rib
}

double arris_of(const CrossVault& vault)
{
    return std::min(vault.rib_width, vault.rib_depth) / 10;  // m
}

using Outline = std::array<Eigen::Vector3d, 5>;

/// Half a rib: the part under one web.
struct HalfRib {
    const CrossVault& vault;
    std::array<int, 2> quadrant;  // signs of x and y
    int along = 0;                // 0, 1: the stones of the web lie along x, y

    /// @param angle from the crown [rad]; @param off from the groin, along the axis of the web [m]
    Eigen::Vector3d corner(double radius, double angle, double off) const
    {
        const CircularArc arc = arc_over(vault.span, vault.rise);
        const double across = radius * std::sin(angle);
        Eigen::Vector3d x;
        x[along] = to_nanometre(quadrant[static_cast<std::size_t>(along)] * (across + off));
        x[1 - along] = to_nanometre(quadrant[static_cast<std::size_t>(1 - along)] * across);
        x.z() = to_nanometre(arc.centre + radius * std::cos(angle));
        return x;
    }
    /// The outline of a bed: the soffit from under the groin to the face, the back from the face to the groin,
    /// whose arris is left free: else stones of neighbouring courses would touch in it with a corner.
    Outline bed(int number) const
    {
        const CircularArc arc = arc_over(vault.span, vault.rise);
        const double angle = arc.springing * number / vault.courses, inner = arc.radius - vault.rib_depth,
                     reach = reach_of(vault), arris = arris_of(vault);
        return {corner(inner, angle, 0), corner(inner, angle, reach), corner(arc.radius, angle, reach),
                corner(arc.radius, angle, arris), corner(arc.radius - arris, angle, 0)};
    }
};

/// @param lower, upper beds; @param meets the others at its upper bed: the boss
ConvexPolyhedron part_between(const Outline& lower, const Outline& upper, bool meets, const std::string& name)
{
    std::vector<Eigen::Vector3d> corners(lower.begin(), lower.end());
    corners.insert(corners.end(), upper.begin(), upper.end());
    // Below, above, soffit, face, back, arris, under the groin.
    std::vector<std::vector<int>> faces{{0, 1, 2, 3, 4}, {9, 8, 7, 6, 5}};
    for (int i = 0; i < 5; ++i) faces.push_back({i, 5 + i, 5 + (i + 1) % 5, (i + 1) % 5});
    if (volume_of(corners, faces) < 0)
        for (std::vector<int>& face : faces) std::reverse(face.begin(), face.end());
    ConvexPolyhedron part = make_convex_polyhedron(std::move(corners), std::move(faces), name);
    part.glued = {false, meets, false, false, false, false, true};
    return part;
}

}  // namespace

void check_ribs(const CrossVault& vault, std::vector<Fault>& faults)
{
    if (vault.rib_width == 0) return;
    check_positive("ribs.width", vault.rib_width, faults);
    check_positive("ribs.depth", vault.rib_depth, faults);
    if (!faults.empty()) return;
    const CircularArc arc = arc_over(vault.span, vault.rise);
    if (vault.rib_depth >= 0.5 * arc.radius)
        faults.push_back({"ribs.depth", std::to_string(vault.rib_depth) + " m",
                          "must be less than half the radius of the webs"});
    if (vault.rib_depth * std::cos(arc.springing) >= vault.support - 1e-6)
        faults.push_back({"support", std::to_string(vault.support) + " m",
                          "the ribs reach below it: give a deeper support or shallower ribs"});
    const double room = vault.thickness * std::sin(arc.springing) + vault.margin;
    if (reach_of(vault) > room)
        faults.push_back({"ribs.width", std::to_string(vault.rib_width) + " m",
                          "must be at most " + std::to_string(room * std::numbers::sqrt2) +
                              " m, that the ribs end within the bay"});
}

void add_ribs(const CrossVault& vault, const std::string& prefix, Pattern& pattern)
{
    PatternStone boss{prefix + "boss", "ribs", {}};
    for (const auto& [corner, signs] : quadrants) {
        const std::array<HalfRib, 2> halves{HalfRib{vault, signs, 0}, HalfRib{vault, signs, 1}};
        PatternStone support{prefix + "support_rib_" + corner, foundation_group, {}};
        for (const HalfRib& half : halves) {
            const Outline bed = half.bed(vault.courses);
            Outline feet = bed;
            for (Eigen::Vector3d& foot : feet) foot.z() = to_nanometre(-vault.support);
            support.parts.push_back(part_between(feet, bed, false, support.name));
        }
        pattern.stones.push_back(std::move(support));
        for (int i = vault.courses - 1; i >= 0; --i) {
            PatternStone stone{
                prefix + "rib_" + corner + "_c" + numbered(vault.courses - i, vault.courses), "ribs", {}};
            PatternStone& owner = i == 0 ? boss : stone;
            for (const HalfRib& half : halves)
                owner.parts.push_back(part_between(half.bed(i + 1), half.bed(i), i == 0, owner.name));
            if (i > 0) pattern.stones.push_back(std::move(stone));
        }
    }
    pattern.stones.push_back(std::move(boss));
}

}  // namespace voussoir::importers::patterns
