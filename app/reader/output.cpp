#include "app/reader/output.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/reader/look.h"
#include "app/reader/plane.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double default_interval = 0.02;  // s between frames: 25 frames a period of 2 Hz

constexpr double max_intervals = 1e12;  // in a stage; they are counted in 64 bits

constexpr double most_film_frames = 1e5;

/// `{bar: name}`. @returns whether it is one
bool read_bar_history(const std::string& name, YamlCursor& map, const Model& model, OutputOptions& output)
{
    if (!map.is_map()) return false;
    const std::optional<YamlCursor> given = map.find("bar");
    if (!given) return false;
    std::vector<std::string> names;
    for (const Bar& bar : model.bars) names.push_back(bar.name);
    const std::string wanted = given->as_text();
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end() && !wanted.empty())
        given->fault("no bar \"" + wanted + "\"",
                     names.empty() ? "the case has no bars" : words::suggestion(wanted, names));
    else
        output.bar_histories.push_back({name, static_cast<int>(found - names.begin())});
    map.reject_unknown_keys();
    return true;
}

HistoryPoint read_history(const std::string& name, YamlCursor& map, const Model& model,
                          const std::vector<std::string>& blocks)
{
    HistoryPoint history;
    history.name = name;
    if (!map.expect_map("a history {block: name}")) return history;
    if (const std::optional<YamlCursor> block = map.require("block", "the name of a block")) {
        history.block = block->as_text();
        const bool found = std::binary_search(blocks.begin(), blocks.end(), history.block);
        // Without blocks there are faults already, and a missing one is only their echo.
        if (!found && !blocks.empty() && !history.block.empty())
            block->fault("no block \"" + history.block + "\"", words::suggestion(history.block, blocks));
    }
    if (const std::optional<YamlCursor> point = map.find("point"))
        history.point = read_place(*point, model.kinematics);
    else
        map.took_default("point", "the block's centroid");
    map.reject_unknown_keys();
    return history;
}

SnapshotColor read_color(YamlCursor& map, const Model& model)
{
    const auto color = map.choice_or<SnapshotColor>("color",
                                                    {{"displacement", SnapshotColor::displacement},
                                                     {"principal_stress", SnapshotColor::principal_stress},
                                                     {"velocity", SnapshotColor::velocity},
                                                     {"opening", SnapshotColor::opening},
                                                     {"slip", SnapshotColor::slip},
                                                     {"friction", SnapshotColor::friction},
                                                     {"principal_strain", SnapshotColor::principal_strain},
                                                     {"group", SnapshotColor::group}},
                                                    SnapshotColor::displacement);
    if (color == SnapshotColor::principal_stress && !is_deformable(model.kinematics))
        map.find("color")->fault("principal_stress in a rigid scene, which has no stress", "use displacement");
    if (color == SnapshotColor::principal_strain && !is_deformable(model.kinematics))
        map.find("color")->fault("principal_strain in a rigid scene, which has no strain", "use displacement");
    return color;
}

/// [width, height] in pixels.
void read_size_of(const YamlCursor& value, int& pixels_across, int& pixels_down)
{
    const std::vector<YamlCursor> sides = value.items("a size in pixels, [1600, 900]");
    if (!value.is_list()) return;
    if (sides.size() != 2)
        return value.fault(fmt::format("a list of {}", sides.size()), "expected [width, height]");
    const words::Range pixels{200, 8000, true, true};
    const double width = sides[0].as_quantity(words::dimension::number, pixels);
    const double height = sides[1].as_quantity(words::dimension::number, pixels);
    if (!(width > 0) || !(height > 0)) return;
    pixels_across = static_cast<int>(width);
    pixels_down = static_cast<int>(height);
    if (pixels_across != width || pixels_down != height) value.fault("a fraction of a pixel", "whole numbers");
}

/// The same, where it is given.
template <typename Options>
void read_size(YamlCursor& map, Options& options)
{
    const std::optional<YamlCursor> size = map.find("size");
    if (!size) return map.took_default("size", fmt::format("[{}, {}]", options.width, options.height));
    read_size_of(*size, options.width, options.height);
}

void read_times(YamlCursor& map, const std::vector<Stage>& stages, SnapshotOptions& snapshots)
{
    const std::optional<YamlCursor> times = map.find("times");
    if (!times) {
        snapshots.count = map.integer_or("count", 1, 10'000, snapshots.count);
        return;
    }
    map.forbid("count", "the number follows from times");
    double end = 0;
    for (const Stage& stage : stages) end += stage.type == StageType::dynamic ? stage.duration : 0;
    for (const YamlCursor& time : times->items("a list of times, [0 s, 2.5 s]")) {
        snapshots.times.push_back(time.as_quantity(words::dimension::time, words::Range::non_negative()));
        if (end > 0 && snapshots.times.back() > end)
            time.fault(time.found(), fmt::format("the run ends at {:g} s", end));
    }
    if (snapshots.times.empty() && times->is_list()) times->fault("no time", "give at least one");
}

SnapshotOptions read_snapshots(YamlCursor& map, const Model& model, const std::vector<Stage>& stages)
{
    SnapshotOptions snapshots;
    if (!map.expect_map("snapshots {color: displacement}")) return snapshots;
    snapshots.color = read_color(map, model);
    snapshots.look = read_look(map, model, stages, false);
    read_times(map, stages, snapshots);
    read_size(map, snapshots);
    snapshots.deformation_scale =
        map.find_quantity("deformation_scale", words::dimension::number, words::Range::positive());
    if (!snapshots.deformation_scale) map.took_default("deformation_scale", "1");
    map.reject_unknown_keys();
    return snapshots;
}

FilmOptions read_film(YamlCursor& map, const Model& model, const std::vector<Stage>& stages)
{
    FilmOptions film;
    film.color = read_color(map, model);
    film.look = read_look(map, model, stages, true);
    film.format = map.choice_or<FilmFormat>(
        "format", {{"mp4", FilmFormat::mp4}, {"gif", FilmFormat::gif}, {"webp", FilmFormat::webp}}, film.format);
    read_size(map, film);
    if (film.width % 2 != 0 || film.height % 2 != 0)
        map.find("size")->fault(fmt::format("[{}, {}]", film.width, film.height),
                                "a film needs an even width and height");
    film.frames_per_second = map.integer_or("fps", 1, 120, static_cast<int>(film.frames_per_second));
    film.slow_down = map.quantity_or("slow_down", words::dimension::number, words::Range{1e-3, 1e4, true, true},
                                     film.slow_down);
    film.deformation_scale =
        map.find_quantity("deformation_scale", words::dimension::number, words::Range::positive());
    if (!film.deformation_scale) map.took_default("deformation_scale", "1");
    map.reject_unknown_keys();
    return film;
}

/// `video: true`, or a map of wishes. A film needs time that passes.
void read_video(YamlCursor& output, const Model& model, const std::vector<Stage>& stages, OutputOptions& options)
{
    std::optional<YamlCursor> video = output.find("video");
    if (!video) return;
    if (video->is_map())
        options.film = read_film(*video, model, stages);
    else if (output.boolean_or("video", false))
        options.film = FilmOptions{};
    if (!options.film || stages.empty()) return;
    double time = 0;
    for (const Stage& stage : stages) time += stage.type == StageType::dynamic ? stage.duration : 0;
    if (!(time > 0)) video->fault("a film of static stages alone, in which no time passes", "ask for snapshots");
    const double frames = time * options.film->frames_per_second * options.film->slow_down;
    if (frames > most_film_frames)
        video->fault(fmt::format("a film of {:.0f} frames", frames),
                     fmt::format("at most {:g}: a lower fps or slow_down", most_film_frames));
}

std::vector<std::string> sorted_block_names(const Model& model)
{
    std::vector<std::string> names;
    for (const Block& block : model.blocks) names.push_back(block.name);
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

OutputOptions read_output(YamlCursor& top, const Model& model, const std::vector<Stage>& stages)
{
    OutputOptions output;
    output.every = default_interval;
    std::optional<YamlCursor> map = top.find("output");
    if (!map) {
        top.took_default("output", fmt::format("every {:g} s, no histories, no snapshots", default_interval));
        return output;
    }
    if (!map->expect_map("output {every: 20 ms}")) return output;
    output.every = map->quantity_or("every", words::dimension::time, words::Range::positive(), default_interval);
    for (const Stage& stage : stages)
        if (stage.type == StageType::dynamic && stage.duration / output.every > max_intervals)
            map->fault(fmt::format("{:.3g} intervals in {}", stage.duration / output.every, stage.name),
                       "give a longer interval");
    output.trust = map->choice_or<TrustFigures>(
        "trust",
        {{"automatic", TrustFigures::automatic}, {"always", TrustFigures::always}, {"never", TrustFigures::never}},
        output.trust);
    output.error_estimate = map->boolean_or("error_estimate", output.error_estimate);
    const std::vector<std::string> blocks = sorted_block_names(model);
    if (std::optional<YamlCursor> histories = map->find("histories"))
        for (auto& [name, history] : histories->named_entries("histories by name, {crown: {block: voussoir_47}}"))
            if (!read_bar_history(name, history, model, output))
                output.histories.push_back(read_history(name, history, model, blocks));
    if (std::optional<YamlCursor> snapshots = map->find("snapshots"))
        output.snapshots = read_snapshots(*snapshots, model, stages);
    read_video(*map, model, stages, output);
    if (map->find("report")) output.report = map->boolean_or("report", false);
    map->reject_unknown_keys();
    return output;
}

}  // namespace voussoir::app::reader
