#include <system_error>

#include "app/commands/commands.h"
#include "app/commands/film_progress.h"
#include "app/commands/say.h"
#include "app/report/report_client.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{

namespace
{

namespace fs = std::filesystem;

/// The results file of a run that is named by it or by its folder. @throws InputError when there is none
fs::path results_in(const fs::path& named)
{
    std::error_code none;
    const fs::path results = fs::is_directory(named, none) ? named / "results.h5" : named;
    if (!fs::is_regular_file(results, none))
        throw InputError(results.string(), "no such file", "give the results.h5 of a run, or its folder");
    return results;
}

}  // namespace

int report_command(const ReportArguments& arguments)
{
    const fs::path results = results_in(arguments.results);
    const fs::path folder = arguments.folder.empty() ? results.parent_path() : arguments.folder;
    std::vector<fs::path> made;
    {
        FilmProgress progress(arguments.quiet);
        made = report::request_report(results, folder, !arguments.no_film,
                                      [&](int done, int all) { progress.frame(done, all); });
    }
    for (const fs::path& file : made) say(file.string());
    return exit_done;
}

int compare_command(const CompareArguments& arguments)
{
    const fs::path a = results_in(arguments.a), b = results_in(arguments.b);
    std::error_code none;
    if (fs::equivalent(a, b, none))
        throw InputError(b.string(), "the same run twice", "give two runs that are to be compared");
    std::vector<fs::path> made;
    {
        FilmProgress progress(arguments.quiet);
        made =
            report::request_comparison(a, b, arguments.folder.empty() ? "comparison" : arguments.folder,
                                       !arguments.no_film, [&](int done, int all) { progress.frame(done, all); });
    }
    for (const fs::path& file : made) say(file.string());
    return exit_done;
}

}  // namespace voussoir::app::commands
