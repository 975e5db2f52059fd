#include "app/commands/commands.h"
#include "app/commands/film_progress.h"
#include "app/commands/say.h"
#include "app/report/report_client.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{

int report_command(const ReportArguments& arguments)
{
    namespace fs = std::filesystem;
    std::error_code none;
    const fs::path results =
        fs::is_directory(arguments.results, none) ? arguments.results / "results.h5" : arguments.results;
    if (!fs::is_regular_file(results, none))
        throw InputError(results.string(), "no such file", "give the results.h5 of a run, or its folder");
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

}  // namespace voussoir::app::commands
