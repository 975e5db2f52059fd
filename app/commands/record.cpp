#include "records/record.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/commands/outputs.h"
#include "libdda/errors.h"

namespace voussoir
{
namespace
{

using nlohmann::json;

std::string_view name_of(Quantity quantity)
{
    if (quantity == Quantity::acceleration) return "acceleration";
    return quantity == Quantity::velocity ? "velocity" : "displacement";
}

json to_json(const Channel& channel, const GroundMotion& motion)
{
    return {{"component", channel.component},
            {"quantity", name_of(channel.quantity)},
            {"npts", channel.samples.size()},
            {"dt_s", channel.time_step},
            {"duration_s", motion.duration()},
            {"pga_m_s2", motion.peak_acceleration()},
            {"peak", peak(channel)},
            {"units_in_file", has_unit(channel) ? json(channel.unit_in_file) : json()},
            {"residual_velocity_m_s", motion.residual_velocity()},
            {"residual_displacement_m", motion.residual_displacement()}};
}

void print_channel(const Channel& channel, const GroundMotion& motion)
{
    fmt::print(
        "  {}: {} in {}, {} samples at {:g} s = {:g} s, peak acceleration {:.4g} m/s2; "
        "at the end {:.3g} m/s and {:.3g} m\n",
        channel.component.empty() ? "(no name)" : channel.component, name_of(channel.quantity),
        channel.unit_in_file, channel.samples.size(), channel.time_step, motion.duration(),
        motion.peak_acceleration(), motion.residual_velocity(), motion.residual_displacement());
}

/// One file, described; its reason if it is refused.
json describe(const std::filesystem::path& file, const ReadOptions& options, bool in_words)
{
    json description = {{"file", file.string()}, {"format", ""}, {"channels", json::array()}, {"reason", ""}};
    try {
        const Record record = read_record(file, options);
        description["format"] = record.format;
        if (in_words) fmt::print("{}: {}\n", file.string(), record.format);
        for (const Channel& channel : record.channels) {
            const GroundMotion motion = to_ground_motion(channel, file.string());
            description["channels"].push_back(to_json(channel, motion));
            if (in_words) print_channel(channel, motion);
        }
    } catch (const InputError& error) {
        description["channels"] = json::array();
        description["reason"] = error.what();
        fmt::print(stderr, "{}\n", error.what());
    }
    return description;
}

}  // namespace

int record_command(const RecordArguments& arguments)
{
    const ReadOptions options{arguments.unit, arguments.time_step, arguments.column};
    const bool to_stdout = arguments.json && *arguments.json == "-";
    json descriptions = json::array();
    bool any_refused = false;
    for (const std::filesystem::path& file : arguments.files) {
        descriptions.push_back(describe(file, options, !to_stdout));
        any_refused = any_refused || !descriptions.back()["reason"].get_ref<const std::string&>().empty();
    }
    if (arguments.json) write_json_text(*arguments.json, descriptions.dump(2));
    return any_refused ? exit_bad_input : exit_done;
}

}  // namespace voussoir
