// voussoir-render: pictures from a results file. Without arguments it reads them from its standard input, one to a
// line: that is how voussoir asks it.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <numbers>

#include "app/render/color_names.h"
#include "app/render/film.h"
#include "app/render/picture_queue.h"
#include "app/render/render_run.h"
#include "app/render/time_pictures.h"
#include "importers/process/own_limits.h"
#include "importers/process/program_start.h"
#include "libdda/errors.h"

namespace process = voussoir::importers::process;
namespace render = voussoir::app::render;

namespace
{

using voussoir::InputError;
using voussoir::app::SnapshotOptions;

struct Arguments {
    std::filesystem::path results, folder = "snapshots";
    std::string color = "displacement", size = "1600x900", format = "mp4";
    std::filesystem::path film;    // empty: pictures
    std::filesystem::path beside;  // another run, on the right
    std::vector<std::string> titles;
    double frames_per_second = 25, slow_down = 1;
    double deformation_scale = 1, joint_threshold_mm = 0.1;
    SnapshotOptions options;
    render::Look look;
    std::string view;
    double orbit_degrees = 0;
    int timed = 0;
};

/// Where several pictures are drawn at once each has a core for itself: the rasteriser of each starts no threads
/// of its own. Before anything draws, as the library reads it when it begins.
void share_cores(SnapshotOptions& options)
{
    options.jobs = render::jobs_for(options.jobs, options.width, options.height);
    if (options.jobs > 1) setenv("LP_NUM_THREADS", "0", 0);
}

void read_size(const std::string& text, SnapshotOptions& options)
{
    char rest = 0;
    const int found = std::sscanf(text.c_str(), "%dx%d%c", &options.width, &options.height, &rest);
    const bool good = found == 2 && std::min(options.width, options.height) >= 200 &&
                      std::max(options.width, options.height) <= 8000;
    if (!good) throw InputError("--size", text, "give WIDTHxHEIGHT, each 200 to 8000 pixels");
}

void describe(CLI::App& app, Arguments& arguments)
{
    app.add_option("results", arguments.results, "Results file of a run")->required();
    app.add_option("-o,--output", arguments.folder, "Folder of the pictures")->capture_default_str();
    app.add_option("--color", arguments.color, "Coloured quantity")
        ->check(CLI::IsMember(render::color_names()))
        ->capture_default_str();
    app.add_option("--times", arguments.options.times, "Times of the pictures [s]")->delimiter(',');
    app.add_option("--count", arguments.options.count, "Number of pictures where no times are given")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    app.add_option("--size", arguments.size, "Size of the pictures [pixels]")->capture_default_str();
    app.add_option("--deformation-scale", arguments.deformation_scale, "Magnification of displacements")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--joint-threshold", arguments.joint_threshold_mm,
                   "Joints open or slid by more than this are marked [mm]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--video", arguments.film, "A film of this name instead of pictures");
    app.add_option("--hide", arguments.look.hidden, "Stones, or groups, of this name are left out")
        ->allow_extra_args(false);
    app.add_option("--cut", arguments.look.cuts, "Stones there are left out: x>1.5")->allow_extra_args(false);
    app.add_option("--label", arguments.look.labels, "Stones of this name are named")->allow_extra_args(false);
    app.add_option("--view", arguments.view, "front, right, back, left, top, or AZIMUTH,ELEVATION [deg]");
    app.add_option("--orbit", arguments.orbit_degrees, "Turn of the viewer in the course of a film [deg]");
    app.add_flag("--orthographic", arguments.look.orthographic, "Without perspective");
    app.add_flag("--forces", arguments.look.forces, "Contact forces and the line of thrust");
    app.add_flag("--ground", arguments.look.ground, "The acceleration of the ground, as an arrow");
    app.add_option("--follow", arguments.look.follow, "The camera goes with the stones of this name");
    app.add_option("--jobs", arguments.options.jobs, "Pictures drawn at once; 0: as many as there are cores")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_option("--timed", arguments.timed, "Draw the last frame so often and tell the CPU time of each");
    app.add_option("--beside", arguments.beside, "Results of another run, to be shown on the right");
    app.add_option("--title", arguments.titles, "Title over a run, in the order of the runs")
        ->allow_extra_args(false);
    app.add_option("--format", arguments.format, "Format of the film")
        ->check(CLI::IsMember(render::film_format_names()))
        ->capture_default_str();
    app.add_option("--fps", arguments.frames_per_second, "Frames of the film a second")
        ->check(CLI::Range(1.0, 120.0))
        ->capture_default_str();
    app.add_option("--slow-down", arguments.slow_down, "Seconds of film for a second of the run")
        ->check(CLI::Range(1e-3, 1e4))
        ->capture_default_str();
}

std::vector<std::string> arguments_of(int count, char** words)
{
    std::vector<std::string> list(words + 1, words + count);
    if (list.empty()) {
        for (std::string line; std::getline(std::cin, line);) list.push_back(line);
    }
    std::reverse(list.begin(), list.end());  // as CLI11 wants them
    return list;
}

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void note_signal(int)
{
    asked_to_stop = 1;
}

std::vector<render::FilmedFile> runs_of(const Arguments& arguments)
{
    std::vector<render::FilmedFile> runs = {{arguments.results, ""}};
    if (!arguments.beside.empty()) runs.push_back({arguments.beside, ""});
    for (std::size_t i = 0; i < std::min(runs.size(), arguments.titles.size()); ++i)
        runs[i].title = arguments.titles[i];
    return runs;
}

/// A stopped film leaves nothing, so the signals that stop a program are noted, and heard between two frames.
void make_film(const Arguments& arguments)
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, note_signal);
    voussoir::app::FilmOptions film;
    film.color = arguments.options.color;
    film.format = render::film_format_named(arguments.format);
    film.width = arguments.options.width;
    film.height = arguments.options.height;
    film.frames_per_second = arguments.frames_per_second;
    film.slow_down = arguments.slow_down;
    film.deformation_scale = arguments.deformation_scale;
    film.jobs = arguments.options.jobs;
    render::render_film(runs_of(arguments), arguments.film, film, arguments.look,
                        arguments.joint_threshold_mm * 1e-3, [](std::size_t done, std::size_t all) {
                            fmt::print("frame {} of {}\n", done, all);
                            std::fflush(stdout);
                            return asked_to_stop == 0;
                        });
}

/// CPU time of all threads of a picture, in its parts, at steady state.
void tell_times(const Arguments& arguments)
{
    const render::PictureTimes times = render::time_pictures(arguments.results, arguments.options, arguments.look,
                                                             arguments.joint_threshold_mm * 1e-3, arguments.timed);
    const double pixels = 1e-6 * arguments.options.width * arguments.options.height;
    fmt::print("{} stones, {} x {}: {:.1f} ms of CPU a picture, {:.1f} ms a million pixels ({:.1f} ms wall)\n",
               times.stones, arguments.options.width, arguments.options.height, 1e3 * times.cpu,
               1e3 * times.cpu / pixels, 1e3 * times.wall);
    fmt::print("reading {:.1f} ms, scene {:.1f} ms, drawing {:.1f} ms, page {:.1f} ms\n", 1e3 * times.reading,
               1e3 * times.scene, 1e3 * times.drawing, 1e3 * times.page);
}

void render(Arguments& arguments)
{
    read_size(arguments.size, arguments.options);
    arguments.options.color = render::color_named(arguments.color);
    arguments.options.deformation_scale = arguments.deformation_scale;
    arguments.look.groups = arguments.options.color == voussoir::app::SnapshotColor::group;
    if (!arguments.view.empty()) render::set_view(arguments.view, arguments.look);
    arguments.look.orbit = arguments.orbit_degrees * std::numbers::pi / 180;
    if (arguments.timed > 0) return tell_times(arguments);
    share_cores(arguments.options);
    if (!arguments.film.empty()) return make_film(arguments);
    const double threshold = arguments.joint_threshold_mm * 1e-3;
    const std::vector<std::filesystem::path> pictures =
        arguments.beside.empty()
            ? render::render_run(arguments.results, arguments.folder, arguments.options, arguments.look, threshold)
            : render::render_beside(runs_of(arguments), arguments.folder, arguments.options, arguments.look,
                                    threshold);
    for (const std::filesystem::path& picture : pictures) fmt::print("{}\n", picture.string());
}

/// The results may be anybody's. A picture of 8000 x 8000 pixels takes 4 GB.
void limit_resources()
{
    process::limit_self(RLIMIT_CORE, 0);
    process::limit_own_memory(rlim_t{8} << 30);
}

int run(int count, char** words)
{
    CLI::App app("Draws pictures from the results of a voussoir run.", "voussoir-render");
    Arguments arguments;
    describe(app, arguments);
    try {
        app.parse(arguments_of(count, words));
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    render(arguments);
    return 0;
}

}  // namespace

int main(int count, char** words)
{
    process::begin_helper();
    limit_resources();
    try {
        return run(count, words);
    } catch (const InputError& error) {
        process::complain("voussoir-render", error.what());
        return 2;
    } catch (const std::exception& error) {
        process::complain("voussoir-render", error.what());
        return 1;
    }
}
