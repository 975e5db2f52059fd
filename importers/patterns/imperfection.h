// How far real stones of a pattern differ from drawn ones.
#pragma once

#include <cstdint>
#include <vector>

#include "importers/patterns/pattern.h"
#include "libdda/errors.h"

namespace voussoir::importers::patterns
{

/// Every number is drawn evenly from its range, five for each stone in the order of the stones, by generators of
/// our own: the same seed gives the same stones on every machine, and one amount does not change what the others
/// draw. Stones are never larger than drawn and stay in the space they were drawn in, on their own beds: nothing
/// overlaps, and only joints that carry by touch of sides open.
struct StoneImperfection {
    std::uint64_t seed = 1;  // of the generator
    double size = 0;         // -, stones are smaller by 0 to this share along their beds: joints of that thickness
    double joint = 0;        // m, and by 0 to this length: joints of that thickness, whatever the stone's length
    double position = 0;     // -, 0 to 1: how far from the middle of its space a smaller stone may lie; at 1 it
                             // touches the one side or the other
    double friction = 0;     // -, friction factor from 1 - friction to 1 + friction
};

/// Adds every amount that is out of its range.
void check_stone_imperfection(const StoneImperfection& imperfection, std::vector<Fault>& faults);

/// Makes the stones of a pattern imperfect. Those of the foundation stay as drawn.
void disturb(Pattern& pattern, const StoneImperfection& imperfection);

/// Both. @throws InputError with every amount that is out of its range
void check_and_disturb(Pattern& pattern, const StoneImperfection& imperfection);

}  // namespace voussoir::importers::patterns
