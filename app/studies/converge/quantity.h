// What of a run is compared with the other runs.
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"

namespace voussoir::app::studies::converge
{

/// What is followed through a run.
enum class Field {
    displacement,   // u: of a history's point, as in histories.csv
    drift,          // d: the same relative to the foot, since the motion began
    velocity,       // v
    largest_drift,  // largest: the largest drift of a block's centroid
};

/// What is taken of it: the whole history, the largest size, the value at the end.
enum class Measure { history, peak, end };

struct Quantity {
    Field field = Field::largest_drift;
    int point = -1;      // index into the case's histories; -1 with largest_drift
    int component = -1;  // 0, 1, 2: x, y, z; -1: the vector
    Measure measure = Measure::history;
    int channel = 0;  // index into Recording::values

    bool operator==(const Quantity&) const = default;
};

/// "crown.dx:peak".
std::string name_of(const Quantity& quantity, const Case& the_case);

/// "m" or "m/s".
std::string unit_of(const Quantity& quantity);

/// Reads "crown.dx", "crown.u:peak", "largest:end". Without words: the drift of every history's point, or, where
/// the case has none, peak and end of the largest drift.
/// @throws InputError with every word that is none, and the nearest that is one
std::vector<Quantity> read_quantities(const std::vector<std::string>& words, const Case& the_case);

}  // namespace voussoir::app::studies::converge
