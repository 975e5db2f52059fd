// What the engine does, in a few numbers: hashes of what the golden scenes end in.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/golden/scenes.h"
#include "libdda/model/report.h"

namespace voussoir::app::golden
{

/// Of one scene.
struct SceneHashes {
    std::string name;
    std::uint64_t state = 0;   // hash_of the last state
    std::uint64_t report = 0;  // of outcome, counts, energies, blocks that fell and joints that were crushed
};

/// @param end the scene's last state, as its stages left it
RunReport run_scene(const Scene& scene, State& end);

std::uint64_t hash_of(const RunReport& report);

/// Runs all golden scenes, within a second or two.
std::vector<SceneHashes> hashes();

/// Twelve hexadecimal digits over all hashes and names: equal when the engine does the same, whatever became of
/// its sources.
std::string behaviour(const std::vector<SceneHashes>& hashes);

/// What else the bits depend on, by name: "instruction_set", "compiler", "eigen", "libm", "cholmod", "lapack",
/// "blas".
std::vector<std::pair<std::string, std::string>> machine();

}  // namespace voussoir::app::golden
