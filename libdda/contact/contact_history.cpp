#include "libdda/contact/contact_history.h"

#include <algorithm>
#include <cmath>

#include "libdda/contact/normal_stiffness.h"
#include "libdda/contact/stone_bending.h"

namespace voussoir::contact
{

namespace
{

constexpr double same_plane = 0.9;            // cosine: the faces of a rough or warped joint, not its edge
constexpr double nearest_point_reach = 0.05;  // of the patch's extent

/// At a place where there was no corner: unlike the slip the rest gap is linear over the patch, so that near
/// corners count more, by the inverse square of their distance.
template <int D>
double rest_gap_between(std::span<const ContactPointIn<D>> old, const VectorIn<D>& place)
{
    double sum = 0, weights = 0;
    for (const ContactPointIn<D>& point : old) {
        const double square = (point.position - place).squaredNorm();
        if (square == 0) return point.rest_gap;
        sum += point.rest_gap / square;
        weights += 1 / square;
    }
    return weights > 0 ? sum / weights : 0;
}

/// Takes over slip and rest gap from the old patch; `sign` is -1 when reference and incident body have changed
/// places.
/// @param sheared share of the patch that the old one was: what has only now come into touch has no elastic slip,
/// and the mean is taken, so that the shear force does not jump
/// @param extent of the patch: the root of its area, or its length [m]
/// @param index of the point in its patch: most often that of the old one too
template <int D>
void inherit(const History<D>& history, bool same_features, double sign, double sheared, double extent,
             std::size_t index, ContactPointIn<D>& point)
{
    const ContactPointIn<D>* source = nullptr;
    if (same_features && index < history.points.size() && history.points[index].feature == point.feature)
        source = &history.points[index];
    else if (same_features)
        for (const ContactPointIn<D>& old : history.points)
            if (old.feature == point.feature) source = &old;
    if (!source) {
        double nearest = nearest_point_reach * extent;
        for (const ContactPointIn<D>& old : history.points) {
            const double distance = (old.position - point.position).norm();
            if (distance > nearest) continue;
            nearest = distance;
            source = &old;
        }
    }
    if (source) {
        point.elastic_slip = sign * sheared * source->elastic_slip;
        point.plastic_slip = sign * source->plastic_slip;
        point.rest_gap = source->rest_gap;
        point.status = source->status;
    } else {
        double area = 0;
        for (const ContactPointIn<D>& old : history.points) {
            area += old.area;
            point.elastic_slip += sign * old.area * old.elastic_slip;
            point.plastic_slip += sign * old.area * old.plastic_slip;
        }
        if (area > 0) {
            point.elastic_slip *= sheared / area;
            point.plastic_slip /= area;
            point.status = history.points.front().status;
        }
        point.rest_gap = rest_gap_between(history.points, point.position);
    }
}

/// Of a patch with the normal stiffness `stiffness` in all [N/m], how much the old patch had: at most 1.
template <int D>
double sheared_share(const History<D>& history, double stiffness)
{
    if (!history.patch) return 1;
    double area = 0;
    for (const ContactPointIn<D>& old : history.points) area += old.area;
    const double before = history.patch->stiffness * area;
    return before < stiffness ? before / stiffness : 1;
}

/// Gaps of a face as the stones beside it bend; of those that do not, as the stones are drawn.
template <int D>
class BentGaps
{
 public:
    BentGaps(const Model& model, const std::vector<bool>& fully_held, const PlacedPartIn<D>& incident,
             const PlacedPartIn<D>& reference, const ContactPatchIn<D>& patch,
             const std::vector<ContactPointIn<D>>& points)
    {
        if (patch.edge_edge || !is_deformable(model.kinematics)) return;
        double area = 0;
        for (const ContactPointIn<D>& p : points) {
            area += p.area;
            centre_ += p.area * p.position;
        }
        if (!(area > 0)) return;
        centre_ /= area;
        const HalfStone<D> a{incident.block, incident.pose.map, fully_held[incident.block]},
            b{reference.block, reference.pose.map, fully_held[reference.block]};
        flexibility_ = bending_flexibility(model, a, b, patch.normal, area);
        twist_ = twist_flexibility(model, a, b, patch.normal, area);
        shear_ = model.joint_between(a.block, b.block).shear_to_normal_stiffness;
    }
    /// Bends the stones: gaps become those that the springs feel. @returns what is stored in the stones [J]
    double bend(const ContactPatchIn<D>& patch, std::vector<ContactPointIn<D>>& points)
    {
        if (flexibility_.isZero(0)) return 0;
        const auto pressure = [&](const VectorIn<D>& slope) {
            MomentOf<D> sum;
            for (const ContactPointIn<D>& p : points) {
                const VectorIn<D> place = p.position - centre_;
                const double gap = p.gap + (slope - slope_).dot(place), stiffness = patch.stiffness * p.area;
                if (gap < 0 || patch.intact) sum.add(-stiffness * gap, stiffness, place);
            }
            return sum;
        };
        balance_moment(flexibility_, VectorIn<D>(VectorIn<D>::Zero()), 1, pressure, moment_);
        const VectorIn<D> change = flexibility_ * moment_ - slope_;
        for (ContactPointIn<D>& p : points) p.gap += change.dot(p.position - centre_);
        slope_ += change;
        return 0.5 * moment_.dot(slope_) + twist_energy(patch, points);
    }
    /// Gap of a point as the stones are drawn [m].
    double drawn(const ContactPointIn<D>& p) const { return p.gap - slope_.dot(p.position - centre_); }

 private:
    /// [J]
    double twist_energy(const ContactPatchIn<D>& patch, const std::vector<ContactPointIn<D>>& points) const
    {
        double couple = 0;
        if constexpr (twists<D>)
            for (const ContactPointIn<D>& p : points)
                couple += shear_ * patch.stiffness * p.area *
                          patch.normal.cross(p.position - centre_).dot(p.elastic_slip);
        return 0.5 * twist_ * couple * couple;
    }

    MatrixIn<D> flexibility_ = MatrixIn<D>::Zero();
    double twist_ = 0, shear_ = 0;
    VectorIn<D> centre_ = VectorIn<D>::Zero(), moment_ = VectorIn<D>::Zero(), slope_ = VectorIn<D>::Zero();
};

/// In the normal springs that press [J].
template <int D>
double pressed_energy(double stiffness, std::span<const ContactPointIn<D>> points)
{
    double energy = 0;
    for (const ContactPointIn<D>& p : points)
        if (p.gap < 0) energy += 0.5 * stiffness * p.area * p.gap * p.gap;
    return energy;
}

/// Where a contact goes over to another face or to a pair of edges, or is found late, area and depth jump: a
/// needle of 10 mm2 that is 3 mm deep has nothing to do with the hundredth of a face that two edges get, and would
/// throw the blocks apart. The overlap that no work has been done for is forgiven: the springs store what they
/// stored.
template <int D>
void forgive_overlap(double stored, BentGaps<D>& gaps, ContactPatchIn<D>& patch,
                     std::vector<ContactPointIn<D>>& points)
{
    const double found = pressed_energy<D>(patch.stiffness, points) + patch.bending_energy;
    if (found <= stored) return;
    const double share = std::sqrt(stored / found);
    for (ContactPointIn<D>& p : points) {
        if (p.gap >= 0) continue;
        const double forgiven = (1 - share) * gaps.drawn(p);
        p.rest_gap += forgiven;
        p.gap -= forgiven;
    }
    patch.bending_energy = gaps.bend(patch, points);
}

/// What the point of a dry joint keeps of an overlap that was forgiven: as the stones part it shrinks, and where
/// they are apart nothing is left of it but what the drawing may be wrong by.
/// @param gap of the stones themselves [m]; @param fit of the model [m]
double kept_rest_gap(double rest_gap, double gap, double fit)
{
    const double drawn = 0.0 - fit;
    return rest_gap < drawn ? std::max(rest_gap, std::min(gap, drawn)) : rest_gap;
}

/// The sides and features of a polygon, still without stiffness, bond or place in a set.
template <int D>
ContactPatchIn<D> patch_of(const PlacedPartIn<D>& reference, const PlacedPartIn<D>& incident,
                           const ContactPolygonIn<D>& polygon)
{
    ContactPatchIn<D> patch;
    patch.block_a = incident.block;
    patch.part_a = incident.part;
    patch.block_b = reference.block;
    patch.part_b = reference.part;
    patch.feature_a = polygon.incident_feature;
    patch.feature_b = polygon.reference_feature;
    patch.edge_edge = polygon.edge_edge;
    patch.normal = polygon.normal;
    return patch;
}

template <int D>
bool has_same_features(const ContactPatchIn<D>& patch, const ContactPatchIn<D>& old)
{
    return old.block_b == patch.block_b && old.edge_edge == patch.edge_edge && old.feature_a == patch.feature_a &&
           old.feature_b == patch.feature_b;
}

/// Whether two patches of the same stones lie in nearly one plane.
template <int D>
bool looks_alike(const ContactPatchIn<D>& patch, const ContactPatchIn<D>& old)
{
    const double sign = old.block_b == patch.block_b ? 1 : -1;
    return sign * old.normal.dot(patch.normal) > same_plane;
}

/// A smaller gap is a closed joint [m]. @param size of the smaller part [m]
double closed_within(const Model& model, double size)
{
    return std::max(closed_at_start * size, model.fit_tolerance);
}

/// A joint with strength is a bond if it is closed when the run begins, at every corner.
template <int D>
bool is_bonded(const Model& model, const State& state, const ContactPatchIn<D>& patch,
               const std::vector<PolygonPointIn<D>>& corners, double size)
{
    if (state.step != 0) return false;
    const JointMaterial& joint = model.joint_between(patch.block_a, patch.block_b);
    if (!joint.has_strength()) return false;
    return std::all_of(corners.begin(), corners.end(),
                       [&](const PolygonPointIn<D>& corner) { return corner.gap < closed_within(model, size); });
}

/// Where two stones begin to touch, or other parts of them: as the drawing has them, and then as beside.
template <int D>
double new_rest_gap(const Model& model, const State& state, const ContactPatchIn<D>& patch,
                    const PolygonPointIn<D>& corner, double size, const History<D>& history)
{
    const double fit = model.fit_tolerance;
    if (patch.intact) return std::max(corner.gap, -closed_within(model, size));
    if (fit == 0) return 0;
    if (state.step == 0) return corner.gap <= fit ? std::max(corner.gap, -fit) : 0;
    std::vector<ContactPointIn<D>> beside;
    for (const int k : history.of_stones) {
        const ContactPatchIn<D>& old = history.all->patches[k];
        if (!looks_alike(patch, old)) continue;
        const auto points = std::span(history.all->points).subspan(old.first_point, old.point_count);
        beside.insert(beside.end(), points.begin(), points.end());
    }
    return std::clamp(rest_gap_between<D>(beside, corner.position), -fit, fit);
}

}  // namespace

template <int D>
void attach_history(const Model& model, const State& state, const std::vector<bool>& fully_held,
                    const PlacedPartIn<D>& first, const PlacedPartIn<D>& second,
                    const ContactPolygonIn<D>& polygon, const History<D>& history, NewOverlap overlap,
                    FoundPatch<D>& found)
{
    const PlacedPartIn<D>& reference = polygon.second_is_reference ? second : first;
    const PlacedPartIn<D>& incident = polygon.second_is_reference ? first : second;
    const double size = std::min(first.size, second.size);
    found.patch = patch_of(reference, incident, polygon);
    found.points.clear();
    ContactPatchIn<D>& patch = found.patch;
    const bool same_features = history.patch && has_same_features(patch, *history.patch);
    patch.stiffness = same_features ? history.patch->stiffness
                                    : normal_stiffness(model, fully_held, polygon, reference, incident);
    patch.intact = history.patch ? history.patch->intact : is_bonded(model, state, patch, polygon.points, size);

    double measure = 0;
    for (const PolygonPointIn<D>& corner : polygon.points) measure += corner.area;
    const double extent = D == 3 ? std::sqrt(measure) : measure;
    const double sheared = sheared_share(history, patch.stiffness * measure * depth_of<D>(model));
    const double sign = history.patch && history.patch->block_b != patch.block_b ? -1 : 1;
    const bool forgives = overlap == NewOverlap::forgiven && !patch.intact && !same_features;
    const bool turns_away =
        model.fit_tolerance > 0 && history.patch && !patch.intact && !looks_alike(patch, *history.patch);
    found.points.reserve(polygon.points.size());
    for (const PolygonPointIn<D>& corner : polygon.points) {
        ContactPointIn<D> point;
        point.feature = corner.feature;
        point.position = corner.position;
        point.area = corner.area * depth_of<D>(model);
        if (history.patch)
            inherit(history, same_features, sign, sheared, extent, found.points.size(), point);
        else
            point.rest_gap = new_rest_gap(model, state, patch, corner, size, history);
        if (turns_away) point.rest_gap = std::min(point.rest_gap, 0.0);
        if (forgives) point.rest_gap = std::max(point.rest_gap, 0.0);  // forgiven anew, by the energy
        if (!patch.intact) point.rest_gap = kept_rest_gap(point.rest_gap, corner.gap, model.fit_tolerance);
        point.gap = corner.gap - point.rest_gap;
        point.elastic_slip -= patch.normal.dot(point.elastic_slip) * patch.normal;
        found.points.push_back(point);
    }
    BentGaps<D> gaps(model, fully_held, incident, reference, patch, found.points);
    if (overlap != NewOverlap::drawn) patch.bending_energy = gaps.bend(patch, found.points);
    if (forgives) {
        const double stored = history.patch ? pressed_energy(history.patch->stiffness, history.points) +
                                                  history.patch->bending_energy
                                            : 0;
        forgive_overlap(stored, gaps, patch, found.points);
    }
}

#define VOUSSOIR_INSTANTIATE(D)                                                                                \
    template void attach_history(const Model&, const State&, const std::vector<bool>&, const PlacedPartIn<D>&, \
                                 const PlacedPartIn<D>&, const ContactPolygonIn<D>&, const History<D>&,        \
                                 NewOverlap, FoundPatch<D>&)
VOUSSOIR_INSTANTIATE(3);
VOUSSOIR_INSTANTIATE(2);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::contact
