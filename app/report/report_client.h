// The report of a run, made by the helper program voussoir-report. Nothing of it is loaded here.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace voussoir::app::report
{

/// @param folder that report.html and its companions are written into
/// @param film whether there is to be one; @param told of it, how many of how many frames are done
/// @returns what was made
/// @throws InputError when the helper is missing or fails, with the reason
std::vector<std::filesystem::path> request_report(const std::filesystem::path& results_file,
                                                  const std::filesystem::path& folder, bool film,
                                                  const std::function<void(int done, int all)>& told = {});

/// The comparison of two runs: comparison.html and its companions, by the same helper.
std::vector<std::filesystem::path> request_comparison(const std::filesystem::path& a,
                                                      const std::filesystem::path& b,
                                                      const std::filesystem::path& folder, bool film,
                                                      const std::function<void(int done, int all)>& told = {});

}  // namespace voussoir::app::report
