// Preferences of the contact search, shared by space and plane. Shares of the smaller part's size L.
#pragma once

namespace voussoir::contact
{

constexpr double face_hysteresis = 1e-3;  // in favour of last step's reference face
// In favour of last step's incident face, of the cosine to the reference face: two faces that are bent against
// each other by less than 0.8 degrees, as the triangles of a warped bed, would take turns for ever.
constexpr double incident_hysteresis = 1e-4;
constexpr double body_preference = 1e-6;  // of the first body, so that ties do not flicker
// A vertex this far outside a side plane still counts as inside. Faces of one size, as in an arch, slide over each
// other by less than this: without the tolerance their polygons gained and lost corners from step to step, and
// each change of the corners' stiffness under load pumped energy into the structure (8 % of the input in a shaken
// bridge at 1e-6 of L).
constexpr double clip_tolerance = 1e-4;
constexpr double smallest_share = 1e-7;  // of L^2 or L: smaller contacts are those of diagonal neighbours

constexpr double looks_at = 0.7;  // cosine: a face looks at another one
constexpr double thin = 0.2;      // of the smaller face: a contact that may be that of other faces

/// So much larger is a contact that takes the place of a thin one.
constexpr double times_as_large(bool was_incident)
{
    return was_incident ? 5 : 10;
}

}  // namespace voussoir::contact
