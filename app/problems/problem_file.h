// Many step problems in one HDF5 file.
#pragma once

#include <filesystem>

#include "app/problems/problem.h"

namespace voussoir::app::problems
{

/// Writes every bit of them; equal problems give equal files. @throws InputError
void save(const Corpus& corpus, const std::filesystem::path& path);

/// @throws InputError when the file cannot be read, has no step problems of this program, or was damaged
Corpus load(const std::filesystem::path& path);

}  // namespace voussoir::app::problems
