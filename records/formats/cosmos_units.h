// The units of COSMOS files, which are named in words, as a code, or both.
#pragma once

#include <optional>
#include <string_view>

#include "records/units.h"

namespace voussoir::records::formats
{

/// Table 2 of the COSMOS format, of motions; nothing for other codes.
std::optional<Unit> find_cosmos_unit(int code);

/// The code of "13400 acceleration pts, units=g. (02) Format=(8F10.5)"; nothing when the line has none: the
/// bracket behind "Format" is no code.
std::optional<double> cosmos_code_in(std::string_view line);

}  // namespace voussoir::records::formats
