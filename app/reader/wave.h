// Motions of a case that are not recorded: waves in closed form, noise, and what they are matched to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/reader/yaml_cursor.h"
#include "records/record.h"
#include "records/synthetic/target_spectrum.h"

namespace voussoir::app::reader
{

/// The keys under which a motion may name a wave.
const std::vector<std::string>& wave_keys();

/// Reads `{ricker: {acceleration: 0.3 g, frequency: 2 Hz}}` and its like: ramped_sine, sweep, ricker, pulse,
/// noise.
/// @param key one of wave_keys(), present in `map`
/// @param description what it is, added to
/// @returns nothing, with faults, when it cannot be used
std::optional<records::Channel> read_wave(const std::string& key, YamlCursor& value, std::string& description);

/// Reads `{eurocode_8: {type: 1, ground: B, acceleration: 0.25 g}}` or `{table: [[0.1 s, 0.4 g], ...]}`.
std::optional<records::synthetic::TargetSpectrum> read_target_spectrum(YamlCursor& map);

}  // namespace voussoir::app::reader
