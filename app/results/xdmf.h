// results.xdmf: the description of results.h5 by which ParaView opens it.
#pragma once

#include <filesystem>

namespace voussoir::app::results
{

/// Describes every whole frame of a results file, of a finished or a killed run: one mesh of polygons, its
/// vertices moving, with the block's number, its displacement relative to the foot and, in deformable scenes,
/// its least and greatest principal stress. Refers to the results file by name: both stay in one folder.
/// @throws InputError when the results cannot be read or the description not written
void write_xdmf(const std::filesystem::path& results_file, const std::filesystem::path& xdmf_file);

}  // namespace voussoir::app::results
