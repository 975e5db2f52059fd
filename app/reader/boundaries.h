// The parts of a case that say where the model ends in the ground: `boundaries`, `tied_sides`,
// `periodic_sides`, `incoming_wave`.
#pragma once

#include <optional>
#include <vector>

#include "app/reader/motion.h"
#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::reader
{

/// Fills model.boundaries, model.tied_sides and model.side_ties; blocks and foundations must have been read.
void read_boundaries(YamlCursor& top, Model& model);

/// The waves of a stage, `{boundary: base, motion_is: outcrop, x: {record: ...}}` or a list of them.
/// @param stage_duration as far as it is known before the motions are [s]
void read_incoming_waves(YamlCursor& value, const Model& model, std::optional<double> stage_duration,
                         MotionContext& context, Stage& stage);

/// A dynamic stage with gravity needs a static one before it, in which boundaries take up what they are to carry.
/// @param written the stage, for the fault
void refuse_unsupported(const YamlCursor& written, const Model& model, const Stage& stage, bool has_rested);

}  // namespace voussoir::app::reader
