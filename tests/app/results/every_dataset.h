// Everything that a results file holds, to compare two of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace voussoir::app::results
{

/// FNV-1a of the bytes of every dataset and attribute, with their extents, by name; /summary, which tells times,
/// is left out.
std::map<std::string, std::uint64_t> every_dataset(const std::filesystem::path& results);

}  // namespace voussoir::app::results
