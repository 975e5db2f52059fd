#include "libdda/contact/contact_history.h"

#include <algorithm>
#include <cmath>

#include "libdda/contact/bent_gaps.h"
#include "libdda/contact/cut_face.h"
#include "libdda/contact/face_points.h"
#include "libdda/contact/normal_stiffness.h"
#include "libdda/contact/slip_field.h"

namespace voussoir::contact
{

namespace
{

constexpr double same_plane = 0.9;            // cosine: the faces of a rough or warped joint, not its edge
constexpr double nearest_point_reach = 0.05;  // of the patch's extent
constexpr int most_cuts = 8;                  // of a face beside stones that bend
constexpr double same_slope = 1e-3;           // of what they bend by
constexpr double most_stretched = 1.5;        // times, of slip that goes over to other places

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
/// @param field of a face that gives way linearly; null: each point has its own slip
/// @param index of the point in its patch: most often that of the old one too
template <int D>
void inherit(const History<D>& history, bool same_features, double sign, double sheared, double extent,
             const SlipField<D>* field, std::size_t index, ContactPointIn<D>& point)
{
    const ContactPointIn<D>* source = nullptr;
    if (same_features && index < history.points.size() && history.points[index].feature == point.feature)
        source = &history.points[index];
    else if (same_features)
        for (const ContactPointIn<D>& old : history.points)
            if (old.feature == point.feature) source = &old;
    const bool same_label = source != nullptr;
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
        if (field && same_label)
            point.elastic_slip += sign * sheared * field->change(source->position, point.position);
    } else {
        double area = 0;
        for (const ContactPointIn<D>& old : history.points) {
            area += old.area;
            point.elastic_slip += sign * old.area * old.elastic_slip;
            point.plastic_slip += sign * old.area * old.plastic_slip;
        }
        if (area > 0) {
            if (field) point.elastic_slip = sign * area * field->at(point.position);
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
    gaps.bend(patch, points);
    patch.bending_energy = gaps.energy(patch, points);
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

/// How the face of a patch gives way: a bonded one, which does not open, on all of its points; edges on their one.
template <int D>
FaceLaw law_of(const Model& model, const ContactPatchIn<D>& patch)
{
    if (patch.edge_edge) return FaceLaw::corners;
    const FaceLaw face = model.joint_between(patch.block_a, patch.block_b).face;
    return face == FaceLaw::linear && patch.intact ? FaceLaw::points : face;
}

/// Makes the points of a patch, each with what it remembers.
template <int D>
class PointMaker
{
 public:
    PointMaker(const Model& model, const State& state, const ContactPatchIn<D>& patch,
               const ContactPolygonIn<D>& polygon, const History<D>& history, FaceLaw law, double size,
               bool forgives)
        : model_(model), state_(state), patch_(patch), history_(history), size_(size), forgives_(forgives)
    {
        double measure = 0;
        for (const PolygonPointIn<D>& corner : polygon.points) measure += corner.area;
        extent_ = D == 3 ? std::sqrt(measure) : measure;
        if (!history.patch) return;
        same_features_ = has_same_features(patch, *history.patch);
        sheared_ = sheared_share(history, patch.stiffness * measure * depth_of<D>(model));
        sign_ = history.patch->block_b != patch.block_b ? -1 : 1;
        turns_away_ = model.fit_tolerance > 0 && !patch.intact && !looks_alike(patch, *history.patch);
        has_field_ = law == FaceLaw::linear;
        if (has_field_) field_ = SlipField<D>(history.points, history.patch->normal);
    }
    double sheared() const { return sheared_; }
    void make(const std::vector<PolygonPointIn<D>>& places, std::vector<ContactPointIn<D>>& points) const
    {
        points.clear();
        points.reserve(places.size());
        for (const PolygonPointIn<D>& place : places) {
            ContactPointIn<D> point = remembering(place, points.size());
            if (turns_away_) point.rest_gap = std::min(point.rest_gap, 0.0);
            if (forgives_) point.rest_gap = std::max(point.rest_gap, 0.0);  // forgiven anew, by the energy
            if (!patch_.intact) point.rest_gap = kept_rest_gap(point.rest_gap, place.gap, model_.fit_tolerance);
            point.gap = place.gap - point.rest_gap;
            point.elastic_slip -= patch_.normal.dot(point.elastic_slip) * patch_.normal;
            points.push_back(point);
        }
    }

 private:
    ContactPointIn<D> remembering(const PolygonPointIn<D>& place, std::size_t index) const
    {
        ContactPointIn<D> point;
        point.feature = place.feature;
        point.position = place.position;
        point.area = place.area * depth_of<D>(model_);
        if (history_.patch)
            inherit(history_, same_features_, sign_, sheared_, extent_, has_field_ ? &field_ : nullptr, index,
                    point);
        else
            point.rest_gap = new_rest_gap(model_, state_, patch_, place, size_, history_);
        return point;
    }

    const Model& model_;
    const State& state_;
    const ContactPatchIn<D>& patch_;
    const History<D>& history_;
    double size_;    // m, of the smaller stone
    double extent_;  // m, of the patch
    bool forgives_, same_features_ = false, turns_away_ = false;
    double sheared_ = 1, sign_ = 1;
    bool has_field_ = false;
    SlipField<D> field_;
};

/// Of a face that gives way linearly: its points, on both sides of the line where it begins to press. Where the
/// stones beside it bend, that line and what they bend by are found together.
/// @param bend_at makes what the stones bend by: points -> BentGaps<D>, with the points' gaps bent
template <int D, class BendAt>
BentGaps<D> cut_where_it_presses(const PointMaker<D>& maker, const ContactPolygonIn<D>& polygon, double touching,
                                 const BendAt& bend_at, std::vector<ContactPointIn<D>>& points)
{
    thread_local std::vector<PolygonPointIn<D>> places;
    thread_local std::vector<double> corner_gaps, gaps;
    maker.make(polygon.points, points);
    corner_gaps.clear();
    for (const ContactPointIn<D>& corner : points) corner_gaps.push_back(corner.gap);
    BentGaps<D> bent = BentGaps<D>::none();
    for (int round = 0; round < most_cuts; ++round) {
        const VectorIn<D> before = bent.slope();
        gaps.clear();
        for (std::size_t i = 0; i < corner_gaps.size(); ++i)
            gaps.push_back(corner_gaps[i] + bent.added(polygon.points[i].position));
        for (double& gap : gaps)
            if (std::abs(gap) < touching) gap = 0;  // as faces that touch as they are drawn
        places = polygon.points;
        add_points_of_parts<D>(polygon.normal, gaps, places);
        maker.make(places, points);
        bent = bend_at(points);
        if ((bent.slope() - before).norm() <= same_slope * bent.slope().norm()) break;
    }
    return bent;
}

/// Slip that goes over to other places stores what it stored, and nothing where the face is apart: as the line
/// moves on, what it leaves and what it reaches has next to no slip, for next to nothing presses there.
/// @param sheared of inherit(): a patch that has grown keeps its force and loses energy
template <int D>
void keep_shear_energy(const History<D>& history, double sheared, double stiffness,
                       std::vector<ContactPointIn<D>>& points)
{
    if (!history.patch) return;
    double before = 0, now = 0;
    for (const ContactPointIn<D>& old : history.points) before += old.area * old.elastic_slip.squaredNorm();
    for (ContactPointIn<D>& point : points) {
        if (point.gap >= 0) point.elastic_slip.setZero();
        now += point.area * point.elastic_slip.squaredNorm();
    }
    before *= sheared * history.patch->stiffness;
    now *= stiffness;
    if (!(now > 0)) return;
    const double share = std::min(most_stretched, std::sqrt(before / now));
    for (ContactPointIn<D>& point : points) point.elastic_slip *= share;
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
    ContactPatchIn<D>& patch = found.patch;
    const bool same_features = history.patch && has_same_features(patch, *history.patch);
    patch.stiffness = same_features ? history.patch->stiffness
                                    : normal_stiffness(model, fully_held, polygon, reference, incident);
    patch.intact = history.patch ? history.patch->intact : is_bonded(model, state, patch, polygon.points, size);
    const bool forgives = overlap == NewOverlap::forgiven && !patch.intact && !same_features;

    const FaceLaw law = law_of(model, patch);
    const PointMaker<D> maker(model, state, patch, polygon, history, law, size, forgives);
    const auto bend_at = [&](std::vector<ContactPointIn<D>>& points) {
        BentGaps<D> gaps(model, fully_held, incident, reference, patch, points);
        if (overlap != NewOverlap::drawn) gaps.bend(patch, points);
        return gaps;
    };
    BentGaps<D> gaps = BentGaps<D>::none();
    switch (law) {
        case FaceLaw::corners:
            maker.make(polygon.points, found.points);
            break;
        case FaceLaw::points: {
            thread_local std::vector<PolygonPointIn<D>> places;
            places = polygon.points;
            add_inner_points(polygon.normal, places);
            maker.make(places, found.points);
            gaps = bend_at(found.points);
            break;
        }
        case FaceLaw::linear: {
            const double touching = gap_rounding * (incident.pose.centroid.norm() + size);
            gaps = cut_where_it_presses(maker, polygon, touching, bend_at, found.points);
            keep_shear_energy(history, maker.sheared(), patch.stiffness, found.points);
            break;
        }
    }
    if (same_features) gaps.keep_couple(*history.patch, history.points, patch, found.points);
    patch.bending_energy = gaps.energy(patch, found.points);
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
