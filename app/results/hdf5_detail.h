// What the two halves of hdf5_file share. Identifiers are HDF5's, as plain 64-bit numbers.
#pragma once

#include <string>
#include <vector>

#include "app/results/hdf5_file.h"

namespace voussoir::app::results
{

std::int64_t native(ElementType type);
std::uint64_t bytes_of(ElementType type);
/// Of the extents from axis `first` on; 1 for none.
std::uint64_t product(const Extents& extents, std::size_t first);
Hdf5Id simple_space(const Extents& extents);
/// Fails with the system's own words from HDF5's stack of errors, or else with `what`.
/// The dataset that holds what would be too large for an attribute.
std::string instead_of_attribute(const std::string& object, const std::string& name);

[[noreturn]] void refuse(const std::filesystem::path& path, bool writing, const std::string& what);
/// Access without file locks, and HDF5's own printing of errors off.
Hdf5Id access_properties();

}  // namespace voussoir::app::results
