// A state in a file of its own, from which a run goes on bit for bit.
#pragma once

#include <filesystem>

#include "libdda/model/state.h"

namespace voussoir::app::results
{

/// Writes every bit of the state; the file is there whole or not at all. @throws InputError
void save_state(const State& state, const std::filesystem::path& path);

/// @throws InputError when the file cannot be read, is not a state file of this program, or was damaged
State load_state(const std::filesystem::path& path);

/// A state that was loaded is one of this model: as many blocks and foundations, contacts between parts it has.
/// @param path of the state, for the fault; @throws InputError
void check_fits(const State& state, const Model& model, const std::filesystem::path& path);

}  // namespace voussoir::app::results
