// Ribs under the groins of a cross vault.
#pragma once

#include <string>
#include <vector>

#include "importers/patterns/pattern.h"
#include "importers/patterns/vaults.h"
#include "libdda/errors.h"

namespace voussoir::importers::patterns
{

/// Adds what makes no ribs.
void check_ribs(const CrossVault& vault, std::vector<Fault>& faults);

/// Adds "support_rib_ne" (group foundation), "rib_ne_c01" ... from the springing up and, where the four ribs meet,
/// "boss" (ribs).
///
/// A rib stone lies under its course: its beds are those of the groin stone above it, drawn on through the
/// intrados; its back fits the intrados on both sides of the groin, whose arris it leaves free, its faces are
/// upright and parallel to the diagonal. It is of two convex parts, glued under the groin; the boss of eight.
/// Joints of webs and ribs are shared, nothing overlaps. @pre the vault has been checked; its ribs have a width
void add_ribs(const CrossVault& vault, const std::string& prefix, Pattern& pattern);

}  // namespace voussoir::importers::patterns
