#include "tests/app/results/every_dataset.h"

#include <hdf5.h>

#include <stdexcept>
#include <vector>

#include "app/results/packed.h"

namespace voussoir::app::results
{
namespace
{

using Hashes = std::map<std::string, std::uint64_t>;

std::uint64_t hash_of(hid_t space, const std::vector<char>& bytes)
{
    std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    Packer packer;
    packer.list(extents);
    return fnv1a(std::string_view(bytes.data(), bytes.size()), fnv1a(packer.bytes));
}

void add_dataset(hid_t dataset, const std::string& name, Hashes& hashes)
{
    const hid_t type = H5Dget_type(dataset), space = H5Dget_space(dataset);
    std::vector<char> bytes(H5Tget_size(type) * static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    if (!bytes.empty() && H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0)
        throw std::runtime_error("cannot read " + name);
    hashes[name] = hash_of(space, bytes);
    H5Sclose(space);
    H5Tclose(type);
}

struct Place {
    std::string object;
    Hashes& hashes;
};

herr_t add_attribute(hid_t object, const char* name, const H5A_info_t*, void* place_pointer)
{
    auto& place = *static_cast<Place*>(place_pointer);
    const hid_t attribute = H5Aopen(object, name, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute), space = H5Aget_space(attribute);
    std::vector<char> bytes(H5Tget_size(type) * static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    const herr_t result = H5Aread(attribute, type, bytes.data());
    place.hashes[place.object + "@" + name] = hash_of(space, bytes);
    H5Sclose(space);
    H5Tclose(type);
    H5Aclose(attribute);
    return result < 0 ? -1 : 0;
}

herr_t add_object(hid_t root, const char* name, const H5O_info_t* info, void* hashes_pointer)
{
    auto& hashes = *static_cast<Hashes*>(hashes_pointer);
    if (std::string(name) == "summary") return 0;
    const hid_t object = H5Oopen(root, name, H5P_DEFAULT);
    if (info->type == H5O_TYPE_DATASET) add_dataset(object, name, hashes);
    Place place{name, hashes};
    hsize_t first = 0;
    const herr_t result = H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &first, add_attribute, &place);
    H5Oclose(object);
    return result;
}

}  // namespace

std::map<std::string, std::uint64_t> every_dataset(const std::filesystem::path& results)
{
    const hid_t file = H5Fopen(results.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0) throw std::runtime_error(results.string() + " does not open");
    Hashes hashes;
    const herr_t result = H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, add_object, &hashes);
    H5Fclose(file);
    if (result < 0) throw std::runtime_error(results.string() + " cannot be read to the end");
    return hashes;
}

}  // namespace voussoir::app::results
