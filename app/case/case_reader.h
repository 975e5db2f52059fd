// How studies are handed the way to read a case: they know no file format.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace voussoir::app
{

struct Case;

/// Reads a case from a file with `key=value` overrides: read_case of app/reader, or what stands in for it.
/// @throws InputError with all faults of the case
using CaseReader =
    std::function<Case(const std::filesystem::path& file, const std::vector<std::string>& overrides)>;

}  // namespace voussoir::app
