// What a contact remembers from one step to the next: its slip, its stiffness, its bond, what it was forgiven.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "libdda/contact/contact_polygon.h"
#include "libdda/contact/placed_part.h"

namespace voussoir::contact
{

/// What rounding leaves of a gap, over the distances that it is made of: faces that touch as drawn.
constexpr double gap_rounding = 16 * std::numeric_limits<double>::epsilon();

/// Of the size of what touches: a smaller gap is a joint that is closed when the run begins.
constexpr double closed_at_start = 1e-4;

/// What becomes of an overlap that no force has made: of a contact that goes over to another face, or is found
/// late.
enum class NewOverlap {
    presses,   // the contact springs push the stones apart
    forgiven,  // they store no more than before; what is too much is kept as the points' rest_gap until the stones
               // part
    drawn,     // nothing has moved yet: gaps are those of the drawing, and no stone bends by them
};

/// The old patch of a pair of parts and its points; none if they did not touch.
template <int D>
struct History {
    const ContactPatchIn<D>* patch = nullptr;
    std::span<const ContactPointIn<D>> points;
    const ContactSetIn<D>* all = nullptr;  // old contacts
    std::span<const int> of_stones = {};   // the patches of the two stones, whichever their parts; of those that
                                           // fit as drawn none are listed
};

/// How deep two stones are within one another at a point [m], beyond what the drawing may be wrong by; < 0: not at
/// all.
template <int D>
double depth_beyond_fit(const Model& model, const ContactPointIn<D>& point)
{
    const double drawn = std::clamp(point.rest_gap, -model.fit_tolerance, model.fit_tolerance);
    return -(point.gap + (point.rest_gap - drawn));
}

template <int D>
struct FoundPatch {
    ContactPatchIn<D> patch;  // without place in a set of points
    std::vector<ContactPointIn<D>> points;
};

/// The contact of two parts with what it remembers, in place of what `found` was; its memory is used again. Every
/// point takes over the slip of the point of the same feature, or of the nearest old point of its pair, or the
/// pair's area-weighted mean, in this order; slips are projected on the new tangent plane. Rest gaps go the same
/// way. Of a dry joint they last until the stones part, of one that was drawn to fit within the model's tolerance
/// until it is out of touch; a positive one does not go over to a face that looks elsewhere.
/// @param polygon of the two parts, as contact_polygon found it
/// @param fully_held (blocks)
template <int D>
void attach_history(const Model& model, const State& state, const std::vector<bool>& fully_held,
                    const PlacedPartIn<D>& first, const PlacedPartIn<D>& second,
                    const ContactPolygonIn<D>& polygon, const History<D>& history, NewOverlap overlap,
                    FoundPatch<D>& found);

}  // namespace voussoir::contact
