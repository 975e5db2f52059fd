// Accelerograms as they come from a network: what a file holds, in SI units.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "libdda/model/ground_motion.h"

namespace voussoir::records
{

/// What a channel measures.
enum class Quantity {
    acceleration,  // m/s2
    velocity,      // m/s
    displacement,  // m
};

/// Of a sample: UTC.
using Instant = std::chrono::sys_time<std::chrono::microseconds>;

/// One component of a record.
struct Channel {
    std::string component;                       // as the file names it; empty if it does not
    Quantity quantity = Quantity::acceleration;  // what it measures
    double time_step = 0;                        // s; 0 when the samples are unevenly spaced
    std::vector<double> samples;  // m/s2, m/s or m: as stored times the unit, nothing removed; in the file's own
                                  // numbers when the unit is not known
    std::vector<double> times;    // s, of the samples, when they are unevenly spaced; else empty
    std::string unit_in_file;     // "g", "cm/s2", "counts x 2000(gal)/8388608", ...; empty: not known
    std::optional<double>
        azimuth;                   // deg clockwise from north, of positive samples; nothing: not known or vertical
    bool is_vertical = false;      // positive upwards
    std::optional<Instant> start;  // of the first sample; nothing: the file does not say it
};

/// What a file holds.
struct Record {
    std::string file;                      // its name
    std::string format;                    // "PEER AT2", "two-column text", ...
    std::vector<Channel> channels;         // in the order of the file
    std::string station = {}, event = {};  // as the file names them; empty if it does not
    std::vector<std::string> remarks =
        {};  // what the reader had to decide and the user should know, a sentence each
};

/// What a file does not carry and only the user can know. Never guessed.
struct ReadOptions {
    std::optional<std::string> unit = {};  // "g", "m/s2", "cm/s2", "m/s", "cm/s", "m", "cm", "mm", ...
    std::optional<double> time_step = {};  // s
    std::optional<int> column = {};        // 1-based, of a text table
    std::filesystem::path response = {};   // StationXML with the sensitivity of counts; empty: none
};

/// Reads an accelerogram, gzipped or not; the format is found from the content. A channel whose unit neither the
/// file nor the options give is returned without one.
/// @throws InputError (place: file and line) when the file cannot be read, is not a record (response spectra are
/// not), holds NaN, or lacks a time step
Record read_record(const std::filesystem::path& file, const ReadOptions& options);

/// The same from memory. @param name for messages; @param bytes whole content, gzipped or not
Record parse_record(const std::string& name, std::string bytes, const ReadOptions& options);

/// Whether the unit of its samples is known.
inline bool has_unit(const Channel& channel)
{
    return !channel.unit_in_file.empty();
}

/// Even samples from uneven ones, by straight lines between them, at the smallest step between two samples, or at
/// a tenth of the mean one if that is more. A channel that is even already is returned as it is.
Channel resampled_evenly(const Channel& channel);

/// The channel as a motion of the ground, integrated exactly; uneven samples are resampled.
/// @throws InputError when its unit is not known
GroundMotion to_ground_motion(const Channel& channel, const std::string& source);

/// Largest |sample| of a channel [its SI unit].
double peak(const Channel& channel);

}  // namespace voussoir::records
