#include "app/commands/after_run.h"

#include <fmt/format.h>

#include <functional>
#include <optional>

#include "app/commands/film_progress.h"
#include "app/commands/say.h"
#include "app/render/snapshots.h"
#include "app/report/report_client.h"
#include "app/results/own_folder.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

namespace fs = std::filesystem;

/// Makes something, or tells why there is none.
void attempt(const char* what, AfterRun& after, const std::function<std::vector<fs::path>()>& make)
{
    try {
        const std::vector<fs::path> made = make();
        after.files.insert(after.files.end(), made.begin(), made.end());
    } catch (const InputError& error) {
        complain(fmt::format("the results are complete, but there {}: {}", what, error.what()));
        after.complete = false;
    }
}

}  // namespace

void expect_tools(const Case& the_case)
{
    if (the_case.output.film && !render::has_ffmpeg())
        throw InputError(the_case.file.string() + ": output.video", "there is no program ffmpeg on the PATH",
                         "install it, as scripts/install does, or remove output.video");
}

AfterRun make_after_run(const Case& the_case, const fs::path& results_file, const fs::path& folder, bool quiet)
{
    AfterRun after;
    if (const std::optional<SnapshotOptions>& pictures = the_case.output.snapshots)
        attempt("are no pictures", after, [&] {
            results::make_own_folder(folder / "snapshots");
            return render::render_snapshots(results_file, folder / "snapshots", *pictures);
        });
    if (const std::optional<FilmOptions>& film = the_case.output.film)
        attempt("is no film", after, [&] {
            FilmProgress progress(quiet);
            const fs::path file = folder / render::film_name(film->format);
            render::request_film(results_file, file, *film, [&](int done, int all) { progress.frame(done, all); });
            return std::vector<fs::path>{file};
        });
    if (the_case.output.report)
        attempt("is no report", after, [&] {
            FilmProgress progress(quiet);
            return report::request_report(results_file, folder, true,
                                          [&](int done, int all) { progress.frame(done, all); });
        });
    return after;
}

}  // namespace voussoir::app::commands
