// The parameters walls and houses share.
#pragma once

#include <string>
#include <vector>

#include "importers/patterns/facade.h"
#include "importers/patterns/survey.h"

namespace voussoir::importers::patterns
{

/// Adds a fault unless the value is > 0 and finite. @param name as in the case file
void check_positive(const std::string& name, double value, std::vector<Fault>& faults);

/// Adds a fault unless the number is at least `least` and at most 9999.
void check_number(const std::string& name, int value, int least, std::vector<Fault>& faults);

/// Adds a fault when there are more than `max_blocks` stones.
void check_stones(const std::string& name, double stones, std::vector<Fault>& faults);

/// "75 deg". @param angle [rad]
std::string in_degrees(double angle);

/// @param walls how many walls, or leaves of them, of the length of the longest there are
void check_block(const BlockFormat& block, double longest, double height, double walls,
                 std::vector<Fault>& faults);

void check_lintel_size(const Lintel& lintel, std::vector<Fault>& faults);

void check_base(const MasonryBase& base, std::vector<Fault>& faults);

void check_imperfection(const Imperfection& imperfection, double thickness, std::vector<Fault>& faults);

void check_survey(const Survey& survey, std::vector<Fault>& faults);

void check_placement(const Placement& placement, std::vector<Fault>& faults);

}  // namespace voussoir::importers::patterns
