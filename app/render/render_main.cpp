// voussoir-render: pictures from a results file. Without arguments it reads them from its standard input, one to a
// line: that is how voussoir asks it.
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "app/render/render_run.h"
#include "importers/process/own_limits.h"
#include "libdda/errors.h"

namespace process = voussoir::importers::process;
namespace render = voussoir::app::render;

namespace
{

using voussoir::InputError;
using voussoir::app::SnapshotColor;
using voussoir::app::SnapshotOptions;

struct Arguments {
    std::filesystem::path results, folder = "snapshots";
    std::string color = "displacement", size = "1600x900";
    double deformation_scale = 1, joint_threshold_mm = 0.1;
    SnapshotOptions options;
};

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
        ->check(CLI::IsMember({"displacement", "principal_stress"}))
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

void render(Arguments& arguments)
{
    read_size(arguments.size, arguments.options);
    arguments.options.color =
        arguments.color == "displacement" ? SnapshotColor::displacement : SnapshotColor::principal_stress;
    arguments.options.deformation_scale = arguments.deformation_scale;
    for (const std::filesystem::path& picture : render::render_run(
             arguments.results, arguments.folder, arguments.options, arguments.joint_threshold_mm * 1e-3)) {
        fmt::print("{}\n", picture.string());
    }
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
    limit_resources();
    try {
        return run(count, words);
    } catch (const InputError& error) {
        std::fprintf(stderr, "voussoir-render: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voussoir-render: %s\n", error.what());
        return 1;
    }
}
