#include "app/report/report_client.h"

#include <cstdio>

#include "importers/process/child_process.h"
#include "libdda/errors.h"

namespace voussoir::app::report
{

namespace fs = std::filesystem;

namespace
{

/// @param other empty for a report
std::vector<fs::path> ask_helper(const fs::path& results_file, const fs::path& other, const fs::path& folder,
                                 bool film, const std::function<void(int done, int all)>& told)
{
    constexpr double seconds_allowed = 24 * 3600;
    constexpr std::size_t max_output = std::size_t{1} << 24;  // bytes: a line for each frame of the film
    const fs::path helper = importers::process::helper_folder() / "voussoir-report";
    if (!fs::exists(helper))
        throw InputError(helper.string(), "there is no such program", "build all programs, or ask for no report");
    for (const fs::path& path : {results_file, other, folder})
        if (path.string().find('\n') != std::string::npos)
            throw InputError(path.string(), "a name of two lines", "rename it");
    std::vector<fs::path> made;
    const auto on_line = [&](const std::string& line) {
        int done = 0, all = 0;
        if (line.starts_with("made ")) made.emplace_back(line.substr(5));
        if (told && std::sscanf(line.c_str(), "frame %d of %d", &done, &all) == 2) told(done, all);
    };
    const std::string request = fs::absolute(results_file).string() + "\n" +
                                (folder.empty() ? "." : folder.string()) + "\n" + (film ? "film" : "no film") +
                                "\n" + (other.empty() ? "" : fs::absolute(other).string() + "\n");
    const importers::process::ChildAnswer answer =
        importers::process::ask_child(helper, request, seconds_allowed, max_output, on_line);
    if (!answer.failure.empty())
        throw InputError(results_file.string(), "voussoir-report made no report: " + answer.failure,
                         "see its message");
    return made;
}

}  // namespace

std::vector<fs::path> request_report(const fs::path& results_file, const fs::path& folder, bool film,
                                     const std::function<void(int done, int all)>& told)
{
    return ask_helper(results_file, {}, folder, film, told);
}

std::vector<fs::path> request_comparison(const fs::path& a, const fs::path& b, const fs::path& folder, bool film,
                                         const std::function<void(int done, int all)>& told)
{
    return ask_helper(a, b, folder, film, told);
}

}  // namespace voussoir::app::report
