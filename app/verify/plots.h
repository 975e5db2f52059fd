// Work-precision diagrams, drawn by the helper program voussoir-plot: voussoir itself does not load Cairo.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace voussoir
{

/// Draws FOLDER/NAME.png for every benchmark of `verify_json` that has a sweep.
/// @returns the benchmarks' names
/// @throws InputError when there is no helper or it fails
std::vector<std::string> draw_plots(const std::string& verify_json, const std::filesystem::path& folder);

}  // namespace voussoir
