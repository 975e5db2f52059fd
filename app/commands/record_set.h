// What `voussoir record` has read, processed and measured, on its way to the table, the figures and the files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "records/measures/measures.h"
#include "records/measures/response_spectrum.h"
#include "records/record.h"

namespace voussoir::app::commands
{

struct MeasuredChannel {
    records::Channel channel;
    double residual_velocity = 0, residual_displacement = 0;  // m/s, m
    double peak_acceleration = 0;                             // m/s2, of the motion, whatever it was recorded as
    std::optional<records::measures::Measures> measures;      // of accelerations whose unit is known
    std::optional<records::measures::ResponseSpectrum> spectrum;  // 5 %, likewise
};

/// Channels that were read together: of one file, or of several.
struct RecordSet {
    std::string file;    // name, or names
    std::string stem;    // of the files written for it
    std::string format;  // empty when it was refused
    std::string station, event;
    std::vector<std::string> remarks;
    std::vector<std::string> processing;  // a sentence for each thing done
    std::vector<MeasuredChannel> channels;
    std::optional<records::measures::RotatedSpectrum> rotd;  // of two horizontal channels at right angles
    std::string reason;                                      // why it was refused
};

/// Fills in measures and spectra. @param channels of one motion
/// @throws InputError when a channel cannot be a motion
void measure(std::vector<records::Channel> channels, RecordSet& set);

void print(const RecordSet& set);

/// The list that `--json` writes.
std::string json_of(const std::vector<RecordSet>& sets);

/// Writes STEM.csv (time and channels), STEM_COMPONENT.at2, STEM_spectra.csv, STEM_series.png and
/// STEM_spectra.png.
/// @returns the files written, and a line when no pictures could be drawn
std::vector<std::string> write_files(const RecordSet& set, const std::filesystem::path& folder);

}  // namespace voussoir::app::commands
