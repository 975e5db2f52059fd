// Motions of a case: records and waves, along one axis or all of them.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/reader/case_file.h"
#include "app/reader/yaml_cursor.h"
#include "libdda/model/ground_motion.h"

namespace voussoir::app::reader
{

/// What every motion of a case needs to be read.
struct MotionContext {
    std::filesystem::path folder;    // of the case file
    const Model& model;              // whose motions they are; a planar scene has none along y
    std::vector<MotionNote>& notes;  // one is added per motion
};

/// Reads `{record: path, unit: g, scale: 1.5, ...}` or `{sine: {acceleration: 0.5 g, frequency: 2.5 Hz}}`.
/// @param whose "foundation x", for the note
/// @param stage_duration of the stage it acts in [s], where a sine without duration ends
/// @returns null, with faults, when it cannot be used
std::shared_ptr<const GroundMotion> read_motion(YamlCursor& map, const std::string& whose,
                                                std::optional<double> stage_duration, MotionContext& context);

/// The axes of a motion map `{x: ..., y: ..., z: ...}` with their motions, null where unusable; or of
/// `{records: [...], ...}`, none if they are unusable. A fault if there is neither.
struct AxisMotion {
    int component = 0;  // 0, 1, 2: x, y, z
    YamlCursor written;
    std::shared_ptr<const GroundMotion> motion;
};
std::vector<AxisMotion> read_axis_motions(YamlCursor& map, const std::string& whose,
                                          std::optional<double> stage_duration, MotionContext& context);

}  // namespace voussoir::app::reader
