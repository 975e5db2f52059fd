// Records of a case: the files, what they do not carry, and what is done to them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/reader/yaml_cursor.h"
#include "records/processing/processing.h"
#include "records/record.h"

namespace voussoir::app::reader
{

/// The keys `unit`, `time_step`, `column` and `response`.
records::ReadOptions read_record_options(YamlCursor& map, const std::filesystem::path& folder);

/// The file a cursor names, read; nothing, with faults there, when it cannot be.
std::optional<records::Record> read_named_record(const YamlCursor& file, const std::filesystem::path& folder,
                                                 const records::ReadOptions& options);

/// The channel that the key `component` names, by its name or its number from 1; it may stay away when there is
/// only one. Null, with a fault, when there is none such.
const records::Channel* choose_channel(YamlCursor& map, const YamlCursor& file, const records::Record& record);

/// Channels after the steps of the key `processing`, if there is one; what was done is added to `description`.
/// @param channels none, with faults, when they could not be read: the steps are still checked
/// @returns nothing, with faults, when it cannot be done
std::optional<records::processing::ProcessedRecord> process_as_written(
    YamlCursor& map, std::vector<records::Channel> channels, const records::processing::Processing& afterwards,
    std::string& description);

/// "aqv.acc (ESM, 0.005 s, 6.51 m/s2)".
std::string in_words(const records::Record& record, const records::Channel& channel, const std::string& name);

/// The three components of one place, along the axes of the scene: `{records: [...], x_azimuth: 30 deg}`.
/// @param map in which `records` is present
/// @returns channels named x, y, z; none, with faults, when one of them cannot be used
std::vector<records::Channel> read_joint_records(YamlCursor& map, const std::filesystem::path& folder,
                                                 std::string& description);

}  // namespace voussoir::app::reader
