// Units in which accelerograms are written.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "libdda/model/standard_gravity.h"
#include "records/record.h"

namespace voussoir::records
{

/// A unit of a channel.
struct Unit {
    std::string name;   // as we print it: "g", "cm/s2"
    Quantity quantity;  // that it measures
    double factor;      // SI value of one unit
};

/// A unit by any of its usual spellings ("G", "cm/sec/sec", "cm/s^2", "gal"); nothing when unknown.
std::optional<Unit> find_unit(std::string_view text);

/// "g, m/s2, ...", for messages.
std::string known_units();

/// "acceleration" and so on.
const char* to_text(Quantity quantity);

}  // namespace voussoir::records
