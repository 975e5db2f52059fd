#include "libdda/analysis/drawn_misfit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "libdda/analysis/overlaps.h"
#include "libdda/contact/find_contacts.h"
#include "libdda/contact/initial_contacts.h"

namespace voussoir
{

namespace
{

constexpr double largest = 0.01;           // of the smaller stone's size
constexpr double largest_of_width = 0.05;  // of the thinner stone's width
constexpr double smallest = 1e-6;          // of the smaller stone's size: rounding
constexpr double touching_share = 0.25;    // of the facing area: less is a wedge

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
        const auto points = std::span(contacts.points).subspan(patch.first_point, patch.point_count);
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

template <int D>
void add_stiffness(const ContactSetIn<D>& contacts, std::vector<double>& stiffness)
{
    for (const ContactPatchIn<D>& patch : contacts.patches)
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            for (const int block : {patch.block_a, patch.block_b})
                stiffness[block] += patch.stiffness * contacts.points[i].area;
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
    State state = initial_state(model);
    find_initial_contacts(model, state);
    std::vector<double> stiffness(model.blocks.size(), 0);
    add_stiffness(state.contacts, stiffness);
    add_stiffness(state.planar_contacts, stiffness);
    for (const Foundation& foundation : model.foundations) stiffness[foundation.block] = 0;
    const std::vector<double> widths = least_widths(model);
    std::vector<SoftStone> soft;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        if (stiffness[b] == 0) continue;  // it falls, or is held
        const double depth = model.mass(b) * gravity.norm() / stiffness[b], share = depth / widths[b];
        if (share > deepest_share) soft.push_back({b, depth, share, share / deepest_share});
    }
    return soft;
}

}  // namespace voussoir
