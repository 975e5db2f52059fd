// The parameters walls and houses share.
#pragma once

#include <string>
#include <vector>

#include "importers/patterns/facade.h"

namespace voussoir::importers::patterns
{

/// Adds a fault unless the value is > 0 and finite. @param name as in the case file
void check_positive(const std::string& name, double value, std::vector<Fault>& faults);

/// @param walls how many walls, or leaves of them, of the length of the longest there are
void check_block(const BlockFormat& block, double longest, double height, double walls,
                 std::vector<Fault>& faults);

void check_lintel_size(const Lintel& lintel, std::vector<Fault>& faults);

void check_base(const MasonryBase& base, std::vector<Fault>& faults);

void check_imperfection(const Imperfection& imperfection, double thickness, std::vector<Fault>& faults);

void check_placement(const Placement& placement, std::vector<Fault>& faults);

}  // namespace voussoir::importers::patterns
