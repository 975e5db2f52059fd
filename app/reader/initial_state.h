// How the run begins: `initial_state`, blocks that stand turned and blocks that move.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/reader/placing.h"
#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// One entry of `initial_state` as it is written.
struct InitialEntry {
    YamlCursor written;
    std::optional<YamlCursor> blocks, group;        // a pattern of names, or the name of a group
    std::optional<Rotation> turn;                   // its `about` in the user's coordinates
    bool turns_about_itself = false;                // each block about its centre of mass, not about turn->about
    std::optional<Eigen::Vector3d> velocity, spin;  // m/s; rad/s, in a planar scene along y
    std::optional<Eigen::Vector3d> spin_about;      // m, user's coordinates
};

/// `initial_state: [{blocks: "drum_*", rotate: {axis: y, angle: 3 deg}, velocity: [...], spin: [...]}]`.
std::vector<InitialEntry> read_initial_state(YamlCursor& top, Kinematics kinematics);

/// Turns the blocks in the model, entry by entry, so that whatever is judged of the geometry is judged of the
/// blocks as the run begins with them. Blocks and groups must have been read.
void turn_blocks(const std::vector<InitialEntry>& entries, Model& model);

/// Fills model.initial_motions; masses and foundations must have been read. Held components that are to move, and
/// blocks that are given a motion twice, are faults.
void give_initial_motions(const std::vector<InitialEntry>& entries, Model& model);

/// Names of the blocks that begin turned or moving.
std::vector<std::string> blocks_named_in(const std::vector<InitialEntry>& entries, const Model& model);

}  // namespace voussoir::app::reader
