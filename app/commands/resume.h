// What a folder of results holds before a run writes there: something to go on from, or something to be replaced.
#pragma once

#include <filesystem>

#include "app/results/restart_file.h"

namespace voussoir::app::commands
{

/// Is there anything of that name, be it a link that leads nowhere?
bool is_there(const std::filesystem::path& path);

/// @throws InputError when the folder has nothing to go on from
void refuse_without_restart(const std::filesystem::path& folder);

/// @param other_engine whether the run may go on though another engine began it; its warnings then say so
/// @throws InputError naming what has changed since, when the case is not the one that was running there, or the
/// engine is another one and may not be
results::Restart restart_of(const Case& the_case, const std::filesystem::path& folder, bool other_engine);

/// One line about earlier results that a run is about to replace; of an interrupted run's even when quiet.
void tell_what_is_replaced(const std::filesystem::path& folder, bool quiet);

/// "stage 'earthquake', t = 3.2 s, step 1600"
std::string place_of(const Case& the_case, const results::Restart& restart);

}  // namespace voussoir::app::commands
