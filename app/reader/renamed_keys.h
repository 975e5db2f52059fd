// Keys that an earlier release called by another name: read for one release, with a warning.
#pragma once

#include <string>
#include <string_view>

namespace voussoir::app::reader
{

/// The name that `key` had in the release before, "dashpot" of "relaxation_time"; empty if it had no other.
std::string_view former_name(std::string_view key);

/// The name that a key of the release before has now; empty if it kept its name.
std::string_view present_name(std::string_view former_key);

}  // namespace voussoir::app::reader
