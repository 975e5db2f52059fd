// Generated scenes read in this process, and what is counted over many of them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "app/case/case.h"
#include "tests/app/properties/generated_scene.h"

namespace voussoir::app::properties
{

/// The seeds of this run: VOUSSOIR_SEEDS="100 200", else the first `usual`.
std::pair<std::uint64_t, std::uint64_t> seeds(std::uint64_t usual = 1000);

/// The case and its files, in a folder that goes away. @throws InputError
Case read(const GeneratedScene& scene, const Telling& telling);

/// The damaged case of a seed, unless it is refused, which must be in sentences with a place and a remedy.
std::optional<Case> read_damaged(std::uint64_t seed);

/// Tells scripts/generated_cases how many cases ended how.
void count(const std::map<std::string, int>& ends);

}  // namespace voussoir::app::properties
