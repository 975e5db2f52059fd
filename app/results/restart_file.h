// From which a run that was stopped or killed goes on as if nothing had happened.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/results/fingerprint.h"
#include "libdda/analysis/trust.h"
#include "libdda/run/run.h"

namespace voussoir::app::results
{

/// All that a run carries from one step to the next, and how much of its results was written by then.
struct Restart {
    Fingerprint computed_from;
    std::vector<std::string> remarks;  // warnings beside those of the engine: other engines that took part
    bool ended = false;                // the run came to its end and all of it is written: nothing is left to do
    State state;
    RunPosition position;                // position.frames: frames of results.h5 that belong to the run
    std::int64_t history_rows = 0;       // lines of histories.csv that do
    double wall_time = 0, cpu_time = 0;  // s, of all commands that took part
    std::optional<TrustStart> trust;     // as it was when the motion began, if it has
};

/// Where a folder of results has it.
std::filesystem::path restart_file_in(const std::filesystem::path& folder);

/// What its first bytes tell, which is all that is read of a file that is about to be replaced.
struct RestartHead {
    bool ended = false;
    double time = 0;  // s, of the state
};

/// @throws InputError when the file cannot be read, is none of this version, or has another length than it says
RestartHead read_restart_head(const std::filesystem::path& path);

/// Written, synced and renamed: the file is there whole or not at all. @throws InputError
void save_restart(const Restart& restart, const std::filesystem::path& path);

/// @throws InputError when the file cannot be read, is none of this version, or was damaged
Restart load_restart(const std::filesystem::path& path);

/// A restart that was loaded is one of this case. @param path of the restart, for the fault; @throws InputError
void check_fits(const Restart& restart, const Case& the_case, const std::filesystem::path& path);

}  // namespace voussoir::app::results
