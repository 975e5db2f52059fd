#include "app/commands/commands.h"
#include "app/commands/film_progress.h"
#include "app/commands/say.h"
#include "app/render/color_names.h"
#include "app/render/snapshots.h"
#include "app/results/own_folder.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

/// The film asked for, under the name asked for, or video.mp4 beside the results.
std::filesystem::path make_film(const RenderArguments& arguments)
{
    FilmOptions options;
    std::filesystem::path film = arguments.film.value();
    if (film.empty()) film = arguments.results.parent_path() / render::film_name(options.format);
    const std::string ending = film.extension().string();
    options.format = render::film_format_named(ending.empty() ? "(a file without ending)" : ending.substr(1));
    options.color = render::color_named(arguments.color);
    if (!arguments.size.empty()) {
        options.width = arguments.size.at(0);
        options.height = arguments.size.at(1);
    }
    options.frames_per_second = arguments.frames_per_second;
    options.slow_down = arguments.slow_down;
    options.deformation_scale = arguments.deformation_scale;
    options.look = arguments.look;
    options.jobs = arguments.jobs;
    FilmProgress progress(false);
    render::request_film(arguments.results, film, options, [&](int done, int all) { progress.frame(done, all); });
    return film;
}

}  // namespace

int render_command(const RenderArguments& arguments)
{
    std::error_code none;
    if (!std::filesystem::is_regular_file(arguments.results, none))
        throw InputError(arguments.results.string(), "no such file", "give the results.h5 of a run");
    if (arguments.film) {
        const std::filesystem::path film = make_film(arguments);
        say(film.string());
        return exit_done;
    }
    SnapshotOptions options;
    options.color = render::color_named(arguments.color);
    options.times = arguments.times;
    options.count = arguments.count;
    if (!arguments.size.empty()) {
        options.width = arguments.size.at(0);
        options.height = arguments.size.at(1);
    }
    options.deformation_scale = arguments.deformation_scale;
    options.look = arguments.look;
    options.jobs = arguments.jobs;
    const std::filesystem::path folder =
        arguments.folder.empty() ? arguments.results.parent_path() / "snapshots" : arguments.folder;
    if (arguments.folder.empty()) results::make_own_folder(folder);
    for (const std::filesystem::path& picture : render::render_snapshots(arguments.results, folder, options))
        say(picture.string());
    return exit_done;
}

}  // namespace voussoir::app::commands
