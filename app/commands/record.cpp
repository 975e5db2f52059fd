#include "records/record.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/commands/commands.h"
#include "app/commands/outputs.h"
#include "app/commands/record_set.h"
#include "app/commands/say.h"
#include "app/reader/motion_text.h"
#include "app/reader/processing.h"
#include "libdda/errors.h"
#include "records/start_time.h"

namespace voussoir::app::commands
{
namespace
{

void refuse(RecordSet& set, const InputError& error)
{
    set.reason = error.what();
    complain(error);
}

/// Says that a file is read that takes more than about a second.
void announce(const std::filesystem::path& file)
{
    constexpr double long_file = 64e6;  // bytes
    std::error_code error;
    const auto size = static_cast<double>(std::filesystem::file_size(file, error));
    if (!error && size > long_file) complain(fmt::format("{}: reading {:.0f} MB", file.string(), size / 1e6));
}

/// The name of a file without what says how it is packed and written.
std::string stem_of(const std::filesystem::path& file)
{
    return (file.extension() == ".gz" ? file.stem() : file.filename()).stem().string();
}

/// Channels of one motion, processed as asked and measured.
void finish(std::vector<records::Channel> channels, const records::processing::Processing& steps, RecordSet& set)
{
    const bool all_known = std::all_of(channels.begin(), channels.end(), records::has_unit);
    if (!steps.empty() && !all_known)
        throw InputError(set.file, "the unit of the samples is unknown", "give --unit: nothing was processed");
    if (!steps.empty()) {
        records::processing::ProcessedRecord processed = records::processing::process(channels, steps);
        channels = std::move(processed.channels);
        set.processing.insert(set.processing.end(), processed.sentences.begin(), processed.sentences.end());
    }
    measure(std::move(channels), set);
}

std::vector<RecordSet> read_one_by_one(const RecordArguments& arguments, const records::ReadOptions& options,
                                       const records::processing::Processing& steps)
{
    std::vector<RecordSet> sets;
    for (const std::filesystem::path& file : arguments.files) {
        RecordSet& set = sets.emplace_back();
        set.file = file.string();
        set.stem = stem_of(file);
        try {
            announce(file);
            records::Record record = records::read_record(file, options);
            set.format = record.format;
            set.station = record.station;
            set.event = record.event;
            set.remarks = record.remarks;
            finish(std::move(record.channels), steps, set);
        } catch (const InputError& error) {
            refuse(set, error);
        }
    }
    return sets;
}

/// All files as one motion.
RecordSet read_together(const RecordArguments& arguments, const records::ReadOptions& options,
                        const records::processing::Processing& steps)
{
    RecordSet set;
    std::vector<records::Channel> channels;
    try {
        for (const std::filesystem::path& file : arguments.files) {
            set.file += (set.file.empty() ? "" : " + ") + file.string();
            if (set.stem.empty()) set.stem = stem_of(file);
            records::Record record = records::read_record(file, options);
            set.format = record.format;
            set.station = record.station;
            set.event = record.event;
            for (const std::string& remark : record.remarks) set.remarks.push_back(file.string() + ": " + remark);
            channels.insert(channels.end(), record.channels.begin(), record.channels.end());
        }
        const bool is_even = std::all_of(channels.begin(), channels.end(),
                                         [](const records::Channel& channel) { return channel.times.empty(); });
        if (steps.empty() && is_even)
            set.processing = records::bring_into_step(channels);  // else process() does it
        finish(std::move(channels), steps, set);
    } catch (const InputError& error) {
        set.channels.clear();
        refuse(set, error);
    }
    return set;
}

RecordSet make_motion(const std::string& text, const records::processing::Processing& steps)
{
    RecordSet set;
    set.file = set.stem = "motion";
    set.format = "synthetic";
    try {
        std::string description;
        std::vector<records::Channel> channels = reader::parse_wave_motion(text, "--motion", description);
        set.processing.push_back(description);
        finish(std::move(channels), steps, set);
    } catch (const InputError& error) {
        refuse(set, error);
    }
    return set;
}

/// Two sets of one name would write over each other's files.
void make_stems_unique(std::vector<RecordSet>& sets)
{
    for (std::size_t i = 0; i < sets.size(); ++i) {
        int same = 1;
        for (std::size_t k = 0; k < i; ++k) same += sets[k].stem == sets[i].stem;
        if (same > 1) sets[i].stem += fmt::format("_{}", same);
    }
}

}  // namespace

int record_command(const RecordArguments& arguments)
{
    const bool to_stdout = arguments.json && *arguments.json == "-";
    if (arguments.files.empty() == !arguments.motion)
        throw InputError("command line", arguments.motion ? "both files and --motion" : "no file",
                         "name accelerograms, or give --motion");
    expect_writable(arguments.json, arguments.folder);
    records::processing::Processing steps;
    if (arguments.process) steps = reader::parse_processing_steps(*arguments.process, "--process");
    const records::ReadOptions options{arguments.unit, arguments.time_step, arguments.column,
                                       arguments.response.value_or(std::filesystem::path())};
    std::vector<RecordSet> sets;
    if (arguments.motion)
        sets.push_back(make_motion(*arguments.motion, steps));
    else if (arguments.together)
        sets.push_back(read_together(arguments, options, steps));
    else
        sets = read_one_by_one(arguments, options, steps);
    make_stems_unique(sets);

    bool any_refused = false;
    for (const RecordSet& set : sets) {
        any_refused = any_refused || !set.reason.empty();
        if (!to_stdout && set.reason.empty()) print(set);
    }
    if (arguments.json) write_json_text(*arguments.json, json_of(sets));
    if (arguments.folder) {
        make_output_folder(*arguments.folder);
        for (const RecordSet& set : sets) {
            if (!set.reason.empty()) continue;
            for (const std::string& file : write_files(set, *arguments.folder))
                if (!to_stdout) say(fmt::format("  {}", file));
        }
    }
    return any_refused ? exit_bad_input : exit_done;
}

}  // namespace voussoir::app::commands
