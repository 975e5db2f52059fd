// Accelerograms as they come from a network: what a file holds, in SI units.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "libdda/model/ground_motion.h"

namespace voussoir
{

enum class Quantity { acceleration, velocity, displacement };

struct Channel {
    std::string component;  // as the file names it; empty if it does not
    Quantity quantity = Quantity::acceleration;
    double time_step = 0;         // s
    std::vector<double> samples;  // m/s2, m/s or m, as stored times the unit: nothing removed
    std::string unit_in_file;     // "g", "cm/s2", ...
};

struct Record {
    std::string file;
    std::string format;  // "PEER AT2", "two-column text", ...
    std::vector<Channel> channels;
};

/// What a file does not carry and only the user can know. Never guessed.
struct ReadOptions {
    std::optional<std::string> unit;  // "g", "m/s2", "cm/s2", "m/s", "cm/s", "m", "cm", "mm", ...
    std::optional<double> time_step;  // s
    std::optional<int> column;        // 1-based, of a text table
};

/// Reads an accelerogram; the format is found from the content.
/// @throws InputError (place: file and line) when the file cannot be read, is not a record, holds NaN, lacks a
/// unit or a time step, or is unevenly sampled
Record read_record(const std::filesystem::path& file, const ReadOptions& options);

/// The channel as a motion of the ground, integrated exactly.
GroundMotion to_ground_motion(const Channel& channel, const std::string& source);

/// Largest |sample| of a channel [its SI unit].
double peak(const Channel& channel);

}  // namespace voussoir
