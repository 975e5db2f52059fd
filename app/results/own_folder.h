// Folders of ours inside a folder that the user named.
#pragma once

#include <filesystem>

namespace voussoir::app::results
{

/// Makes a folder whose name is ours (`snapshots`, `report`, ...). A link of that name would lead elsewhere: it is
/// removed, and what it led to stays as it is. @throws InputError when it cannot be made
void make_own_folder(const std::filesystem::path& folder);

/// Is there a folder, not a link to one?
bool is_own_folder(const std::filesystem::path& folder);

}  // namespace voussoir::app::results
