#include "app/render/snapshots.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "app/render/color_names.h"
#include "app/words/lines.h"
#include "importers/process/child_process.h"
#include "libdda/errors.h"

namespace voussoir::app::render
{

namespace
{

namespace fs = std::filesystem;

constexpr double seconds_allowed = 600;
constexpr std::size_t max_output = std::size_t{1} << 24;  // bytes, a list of paths

/// The helper's command line, an argument to a line.
std::string request(const fs::path& results_file, const fs::path& folder, const SnapshotOptions& options)
{
    std::string text = fs::absolute(results_file).string() + "\n-o\n" + folder.string() + "\n--color\n" +
                       name_of(options.color) + "\n";
    text += fmt::format("--count\n{}\n--size\n{}x{}\n", options.count, options.width, options.height);
    if (!options.times.empty()) text += fmt::format("--times\n{}\n", fmt::join(options.times, ","));
    if (options.deformation_scale) text += fmt::format("--deformation-scale\n{}\n", *options.deformation_scale);
    text += fmt::format("--jobs\n{}\n", options.jobs);
    return text;
}

/// What asks for a second run. A title stays one line and is never an option.
std::string beside_request(const Beside* beside)
{
    if (beside == nullptr) return "";
    std::string text = "--beside\n" + fs::absolute(beside->results).string() + "\n";
    for (std::string title : {beside->title, beside->other_title}) {
        std::replace(title.begin(), title.end(), '\n', ' ');
        text += "--title\n" + title + "\n";
    }
    return text;
}

/// The look as options of the helper. @throws InputError for a text of two lines
std::string look_request(const LookOptions& look)
{
    std::string text;
    const auto add = [&](const char* option, const std::string& value) {
        if (value.find('\n') != std::string::npos) throw InputError(option, value, "a text of one line");
        if (!value.empty()) text += std::string(option) + "=" + value + "\n";
    };
    for (const std::string& pattern : look.hidden) add("--hide", pattern);
    for (const std::string& cut : look.cuts) add("--cut", cut);
    for (const std::string& pattern : look.labels) add("--label", pattern);
    add("--view", look.view);
    add("--follow", look.follow);
    if (look.orbit != 0) add("--orbit", fmt::format("{}", look.orbit));
    if (look.orthographic) text += "--orthographic\n";
    if (look.forces) text += "--forces\n";
    if (look.ground) text += "--ground\n";
    return text;
}

/// The helper, which must be there. @param paths that it is told of, an argument to a line
fs::path helper_for(const std::vector<fs::path>& paths)
{
    const fs::path helper = importers::process::helper_folder() / "voussoir-render";
    if (!fs::exists(helper)) {
        throw InputError(helper.string(), "there is no such program",
                         "build voussoir with VOUSSOIR_RENDER=ON, or ask for no snapshots and no video");
    }
    for (const fs::path& path : paths)
        if (path.string().find('\n') != std::string::npos)
            throw InputError(path.string(), "a name of two lines", "rename it");
    return helper;
}

/// Pictures of an earlier rendering would be taken for this one's.
void remove_other_snapshots(const fs::path& folder, const std::vector<fs::path>& pictures)
{
    std::error_code none;
    std::vector<fs::path> stale;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("snapshot_") || !name.ends_with("s.png")) continue;
        if (std::find(pictures.begin(), pictures.end(), entry.path()) == pictures.end()) {
            stale.push_back(entry.path());
        }
    }
    for (const fs::path& path : stale) fs::remove(path, none);
}

}  // namespace

bool has_renderer()
{
    return fs::exists(importers::process::helper_folder() / "voussoir-render");
}

bool has_ffmpeg()
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return true;
    return false;
}

std::vector<fs::path> render_snapshots(const fs::path& results_file, const fs::path& asked_folder,
                                       const SnapshotOptions& options, const Beside* beside)
{
    // A name that begins with a dash would be taken for an option.
    const fs::path folder = asked_folder.string().starts_with('-') ? "." / asked_folder : asked_folder;
    const fs::path helper = helper_for({results_file, folder});
    const importers::process::ChildAnswer answer = importers::process::ask_child(
        helper, request(results_file, folder, options) + beside_request(beside) + look_request(options.look),
        seconds_allowed, max_output);
    if (!answer.failure.empty()) {
        throw InputError(results_file.string(), "voussoir-render drew no pictures: " + answer.failure,
                         "see its message");
    }
    const std::vector<std::string> names = words::lines_of(answer.output);
    std::vector<fs::path> pictures(names.begin(), names.end());
    remove_other_snapshots(folder, pictures);
    return pictures;
}

std::string film_name(FilmFormat format)
{
    return std::string("video.") + name_of(format);
}

void request_film(const fs::path& results_file, const fs::path& asked_film, const FilmOptions& options,
                  const std::function<void(int done, int all)>& told, const Beside* beside)
{
    constexpr double hours_allowed = 24;
    const fs::path film = fs::absolute(asked_film), helper = helper_for({results_file, film});
    std::string text = fmt::format("{}\n--video\n{}\n--format\n{}\n--color\n{}\n--size\n{}x{}\n",
                                   fs::absolute(results_file).string(), film.string(), name_of(options.format),
                                   name_of(options.color), options.width, options.height);
    text += fmt::format("--fps\n{}\n--slow-down\n{}\n--jobs\n{}\n", options.frames_per_second, options.slow_down,
                        options.jobs);
    if (options.deformation_scale) text += fmt::format("--deformation-scale\n{}\n", *options.deformation_scale);
    text += beside_request(beside) + look_request(options.look);
    const auto on_line = [&](const std::string& line) {
        int done = 0, all = 0;
        if (told && std::sscanf(line.c_str(), "frame %d of %d", &done, &all) == 2) told(done, all);
    };
    const importers::process::ChildAnswer answer =
        importers::process::ask_child(helper, text, 3600 * hours_allowed, max_output, on_line);
    if (!answer.failure.empty())
        throw InputError(results_file.string(), "voussoir-render made no film: " + answer.failure,
                         "see its message");
}

}  // namespace voussoir::app::render
