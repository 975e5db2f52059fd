#include "libdda/analysis/drawn_misfit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "libdda/contact/find_contacts.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/geometry/plane.h"

namespace voussoir
{

namespace
{

constexpr double largest = 0.01;           // of the smaller stone's size
constexpr double largest_of_width = 0.05;  // of the thinner stone's width
constexpr double smallest = 1e-6;          // of the smaller stone's size: rounding
constexpr double least_slope = 0.2;        // sine: flatter joints carry stones, steeper ones only lean on them
constexpr double touching_share = 0.25;    // of the facing area: less is a wedge

Eigen::Vector3d in_space(const Eigen::Vector3d& v)
{
    return v;
}

Eigen::Vector3d in_space(const Eigen::Vector2d& v)
{
    return to_space(v);
}

/// The model with contacts as drawn.
template <int D>
ContactSetIn<D> contacts_as_drawn(Model model)
{
    model.fit_tolerance = 0;
    State state = initial_state(model);
    find_initial_contacts(model, state);
    return std::move(contacts_in<D>(state));
}

/// Share of a segment that is nearer than a limit.
double closer_than(std::span<const ContactPointIn<2>> points, double limit)
{
    const double low = std::min(points[0].gap, points[1].gap), high = std::max(points[0].gap, points[1].gap);
    if (high <= limit) return 1;
    return low >= limit ? 0 : (limit - low) / (high - low);
}

/// Share of a polygon that is nearer than a limit. The gap is linear over it.
double closer_than(std::span<const ContactPoint> points, double limit)
{
    std::vector<Eigen::Vector3d> all, kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ContactPoint& here = points[i];
        const ContactPoint& next = points[(i + 1) % points.size()];
        all.push_back(here.position);
        if (here.gap <= limit) kept.push_back(here.position);
        if ((here.gap <= limit) != (next.gap <= limit))
            kept.push_back(here.position +
                           (limit - here.gap) / (next.gap - here.gap) * (next.position - here.position));
    }
    const auto area = [](const std::vector<Eigen::Vector3d>& loop) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += (loop[i] - loop[0]).cross(loop[i + 1] - loop[0]);
        return sum.norm();
    };
    return kept.size() < 3 ? 0 : area(kept) / area(all);
}

void note(double depth, const Misfit& candidate, Misfit& worst)
{
    if (depth <= worst.depth) return;
    worst = candidate;
    worst.depth = depth;
}

template <int D>
DrawnMisfit misfit_in(const Model& model)
{
    const ContactSetIn<D> contacts = contacts_as_drawn<D>(model);
    const std::vector<double> widths = least_widths(model);
    DrawnMisfit misfit;
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        const auto points = corners_of(contacts, patch);
        const double size_a = size_of(model, patch.block_a), size_b = size_of(model, patch.block_b);
        const double size = std::min(size_a, size_b),
                     width = std::min(widths[patch.block_a], widths[patch.block_b]);
        const double limit = std::min(largest * size, largest_of_width * width);
        if (patch.edge_edge || closer_than(points, contact::contact_distance * (size_a + size_b)) < touching_share)
            continue;
        const Misfit here{0, std::min(patch.block_a, patch.block_b), std::max(patch.block_a, patch.block_b)};
        for (const ContactPointIn<D>& point : points) {
            if (std::abs(point.gap) > limit || std::abs(point.gap) < smallest * size) continue;
            note(-point.gap, here, misfit.overlap);
            note(point.gap, here, misfit.gap);
        }
    }
    return misfit;
}

/// One stone upon another.
struct Support {
    int below = 0;
    double stiffness = 0;  // N/m, against a settlement of the upper stone
    double slope = 0;      // -, of the settlement that the joint closes by
    double softest = 0;    // -, share of the width that it may close by
};

/// What every block stands on.
template <int D>
void add_supports(const Model& model, const ContactSetIn<D>& contacts, const Eigen::Vector3d& up,
                  std::vector<std::vector<Support>>& supports)
{
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        double stiffness = 0;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            stiffness += patch.stiffness * contacts.points[i].area;
        const double slope = up.dot(in_space(patch.normal));  // > 0: block a is upon block b
        const int above = slope > 0 ? patch.block_a : patch.block_b;
        const int below = slope > 0 ? patch.block_b : patch.block_a;
        if (std::abs(slope) > least_slope)
            supports[above].push_back({below, stiffness * slope * slope, std::abs(slope),
                                       softest_share(model.joint_between(patch.block_a, patch.block_b).face)});
    }
}

}  // namespace

double DrawnMisfit::tolerance() const
{
    const double depth = std::max(overlap.depth, gap.depth);
    if (depth == 0) return 0;
    const double digit = std::pow(10, std::floor(std::log10(depth)) - 1);
    return std::ceil(depth / digit * (1 + 1e-9)) * digit;
}

DrawnMisfit drawn_misfit(const Model& model)
{
    return is_planar(model.kinematics) ? misfit_in<2>(model) : misfit_in<3>(model);
}

std::vector<SoftStone> too_soft_stones(const Model& model, const Eigen::Vector3d& gravity)
{
    if (gravity.norm() == 0) return {};
    const Eigen::Vector3d up = -gravity.normalized();
    State state = initial_state(model);
    find_initial_contacts(model, state);
    const int count = static_cast<int>(model.blocks.size());
    std::vector<std::vector<Support>> supports(count);
    add_supports(model, state.contacts, up, supports);
    add_supports(model, state.planar_contacts, up, supports);
    for (const Foundation& foundation : model.foundations) supports[foundation.block].clear();

    std::vector<int> downwards(count);
    std::iota(downwards.begin(), downwards.end(), 0);
    std::stable_sort(downwards.begin(), downwards.end(), [&](int one, int other) {
        return up.dot(model.blocks[one].moments.centroid) > up.dot(model.blocks[other].moments.centroid);
    });
    const std::vector<double> widths = least_widths(model);
    std::vector<double> load(count);
    std::vector<SoftStone> soft;
    for (const int b : downwards) {
        load[b] += model.mass(b) * gravity.norm();
        double stiffness = 0;
        for (const Support& support : supports[b]) stiffness += support.stiffness;
        SoftStone stone{b, 0, 0, 0};
        for (const Support& support : supports[b]) {
            load[support.below] += load[b] * support.stiffness / stiffness;
            const double depth = load[b] / stiffness * support.slope;
            const double share = depth / std::min(widths[b], widths[support.below]);
            stone.depth = std::max(stone.depth, depth);
            stone.share = std::max(stone.share, share);
            stone.factor = std::max(stone.factor, share / support.softest);
        }
        if (stone.factor > 1) soft.push_back(stone);
    }
    return soft;
}

}  // namespace voussoir
