// Contact of two convex outlines: a clipped segment.
#pragma once

#include <optional>

#include "libdda/contact/contact_polygon.h"
#include "libdda/contact/placed_part.h"

namespace voussoir::contact
{

/// contact_polygon of two outlines: the incident edge clipped by the ends of the reference edge, half its length
/// to each end. Segments shorter than 1e-7 L are skipped. @param margin [m] outlines further apart than this do
/// not touch
std::optional<ContactSegment> contact_polygon(const PlacedOutline& first, const PlacedOutline& second,
                                              double margin, const std::optional<LastContact>& last);

}  // namespace voussoir::contact
