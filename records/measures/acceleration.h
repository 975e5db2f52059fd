// What every measure asks of a channel.
#pragma once

#include <string>

#include "records/record.h"

namespace voussoir::records::measures
{

/// The channel with even samples. @param measure for the message: "response spectrum"
/// @throws InputError when it is not an acceleration with a unit, two samples, and a time step
Channel even_acceleration(const Channel& channel, const std::string& measure);

}  // namespace voussoir::records::measures
