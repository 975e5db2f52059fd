// The part of a case that ties blocks to the ground: `foundation`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/reader/motion.h"
#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::reader
{

/// One entry of `foundation`: which of model.foundations came from it, and the motion it carries, to be read when
/// the stages are known.
struct FoundationEntry {
    std::string group;
    std::vector<int> foundations;         // into Model::foundations
    std::vector<Eigen::Vector3d> places;  // m, of their blocks, model coordinates
    std::array<bool, 3> translation_held{true, true, true};
    std::optional<YamlCursor> motion, motion_stage;
};

/// Fills model.foundations; the blocks must have been read.
std::vector<FoundationEntry> read_foundations(YamlCursor& top, Model& model);

/// Every block of the group `value` names; none, with a fault, if there is no such group.
std::vector<int> blocks_of_group(const YamlCursor& value, const Model& model);

/// The motions of a map `{x: ..., y: ..., z: ...}` for the foundations of some entries, added to a stage; with
/// `passes` each comes later where it has farther to go. A motion of a free component, and a second one for the
/// same component, are faults.
/// @param stage_duration as far as it is known before the motions are [s]
void read_foundation_motions(YamlCursor& map, const std::vector<FoundationEntry>& entries,
                             std::optional<double> stage_duration, MotionContext& context, Stage& stage);

}  // namespace voussoir::app::reader
