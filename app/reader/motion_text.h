// A wave written on a command line as in a case.
#pragma once

#include <string>
#include <vector>

#include "records/record.h"

namespace voussoir::app::reader
{

/// Reads `{ricker: {acceleration: 0.3 g, frequency: 2 Hz}, processing: [...]}`.
/// @param option for messages; @param description what it is and what was done, added to
/// @throws InputError with every fault
std::vector<records::Channel> parse_wave_motion(const std::string& text, const std::string& option,
                                                std::string& description);

}  // namespace voussoir::app::reader
