// What a run was computed from, so that only the same run goes on.
#pragma once

#include <cstdint>
#include <string>

#include "app/case/case.h"
#include "app/version/version.h"

namespace voussoir::app::results
{

/// Hashes of all that decides a run.
struct Fingerprint {
    version::EngineVersion engine;
    std::uint64_t text = 0;       // of the case file
    std::uint64_t overrides = 0;  // of --set
    std::uint64_t blocks = 0;     // of the shapes, masses and names that came of patterns and mesh files
    std::uint64_t motions = 0;    // of the ground motions that came of waves and records
};

Fingerprint fingerprint_of(const Case& the_case);

/// The same case file and --set: whatever else differs is not of the user's typing.
bool same_input(const Fingerprint& before, const Fingerprint& now);

/// What differs beside the engine, in words: "the case file, a record"; empty if nothing does.
std::string differences(const Fingerprint& before, const Fingerprint& now);

}  // namespace voussoir::app::results
