// Two runs side by side: what is alike, what differs, and what came of it.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace voussoir::app::report
{

/// Writes comparison.html, comparison.md and comparison.json into a folder, and comparison/ with tables, diagrams,
/// pictures and the film of both. Stones and joints are compared by name.
/// @param a, b results files; @param film whether one is made; @param told of it, how many of how many frames
/// @returns comparison.html, comparison.md, comparison.json and the folder comparison
/// @throws InputError when results cannot be read or the folder cannot be written
std::vector<std::filesystem::path> make_comparison(const std::filesystem::path& a, const std::filesystem::path& b,
                                                   const std::filesystem::path& folder, bool film,
                                                   const std::function<void(int done, int all)>& told);

/// Lines of the one text that the other has not, in their order; equal lines count as often as they stand there.
std::vector<std::string> lines_only_in(const std::string& one, const std::string& other);

}  // namespace voussoir::app::report
