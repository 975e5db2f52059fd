#include "importers/patterns/imperfection.h"

#include "importers/patterns/even_numbers.h"

namespace voussoir::importers::patterns
{
namespace
{

constexpr double largest_share = 0.3;  // of a stone that imperfections take

/// Smaller by a share along each axis, about a point inside, which stays: a convex stone remains in its space.
/// @param towards 0 to 1, picks the corner to which the point lies off the middle; @param off 0 to 1, how far
void shrink(ConvexPolyhedron& part, const Eigen::Array3d& share, double towards, double off)
{
    Eigen::Vector3d fixed = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& x : part.vertices) fixed += x / static_cast<double>(part.vertices.size());
    fixed += off * (part.vertices[static_cast<std::size_t>(towards * part.vertices.size())] - fixed);
    for (Eigen::Vector3d& x : part.vertices) x -= (share * (x - fixed).array()).matrix();
}

/// How long a part is along each axis [m].
Eigen::Array3d extent_of(const ConvexPolyhedron& part)
{
    Eigen::Vector3d lower = part.vertices.front(), upper = lower;
    for (const Eigen::Vector3d& x : part.vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    return upper - lower;
}

}  // namespace

void check_stone_imperfection(const StoneImperfection& imperfection, std::vector<Fault>& faults)
{
    const auto check = [&](const char* name, double value, double limit, const char* expected) {
        if (!(value >= 0 && value <= limit)) faults.push_back({name, std::to_string(value), expected});
    };
    check("imperfection.size", imperfection.size, largest_share, "must be 0 to 30 %");
    check("imperfection.joint", imperfection.joint, 1e3, "must be >= 0 m");
    check("imperfection.position", imperfection.position, 1, "must be 0 to 1");
    check("imperfection.friction", imperfection.friction, 0.99, "must be 0 to 99 %");
}

void disturb(Pattern& pattern, const StoneImperfection& imperfection)
{
    // The thickness of joints has numbers of its own, so that it changes none of the others.
    EvenNumbers numbers(imperfection.seed), thicknesses(~imperfection.seed);
    for (PatternStone& stone : pattern.stones) {
        const double size = numbers.share(), towards = numbers.share(), off = numbers.share();
        const double friction = numbers.deviation(), thickness = imperfection.joint * thicknesses.share();
        if (stone.group == foundation_group) continue;
        stone.friction_factor += imperfection.friction * friction;
        if ((imperfection.size == 0 && imperfection.joint == 0) || stone.play == Play::none ||
            stone.parts.size() != 1)
            continue;
        const Eigen::Array3d along(stone.play == Play::level ? 1 : 0, 1, 0);
        const Eigen::Array3d share = imperfection.size * size + thickness / extent_of(stone.parts[0]);
        shrink(stone.parts[0], along * share.min(largest_share), towards, imperfection.position * off);
    }
}

void check_and_disturb(Pattern& pattern, const StoneImperfection& imperfection)
{
    std::vector<Fault> faults;
    check_stone_imperfection(imperfection, faults);
    if (!faults.empty()) throw InputError(faults);
    disturb(pattern, imperfection);
}

}  // namespace voussoir::importers::patterns
