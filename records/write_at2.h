// Writing an acceleration in PEER's AT2 format.
#pragma once

#include <string>

#include "records/record.h"

namespace voussoir::records
{

/// The text of an AT2 file: two lines of title, unit (g), count and step, five samples on a line with eight
/// digits.
/// @param second_title ends ", component" by PEER's custom
/// @param channel an acceleration [m/s2]
std::string format_at2(const std::string& first_title, const std::string& second_title, const Channel& channel);

}  // namespace voussoir::records
