#include "app/results/hdf5_detail.h"

#include <hdf5.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "libdda/errors.h"

namespace voussoir::app::results
{

static_assert(sizeof(hid_t) == sizeof(std::int64_t), "HDF5 identifiers are 64 bits wide since 1.10");

namespace
{
/// The system's own words are deep in HDF5's stack of errors: "..., errno = 28, error message = 'No space ...'".
herr_t find_system_message(unsigned, const H5E_error2_t* error, void* found)
{
    const std::string text = error->desc != nullptr ? error->desc : "", key = "error message = '";
    const std::size_t start = text.find(key);
    if (start == std::string::npos) return 0;
    const std::size_t end = text.find('\'', start + key.size());
    *static_cast<std::string*>(found) = text.substr(start + key.size(), end - start - key.size());
    return 0;
}
}  // namespace

std::int64_t native(ElementType type)
{
    switch (type) {
        case ElementType::float32:
            return H5T_NATIVE_FLOAT;
        case ElementType::float64:
            return H5T_NATIVE_DOUBLE;
        case ElementType::int32:
            return H5T_NATIVE_INT32;
        case ElementType::int64:
            return H5T_NATIVE_INT64;
    }
    return -1;
}

std::uint64_t bytes_of(ElementType type)
{
    return type == ElementType::float32 || type == ElementType::int32 ? 4 : 8;
}

std::uint64_t product(const Extents& extents, std::size_t first)
{
    return std::accumulate(extents.begin() + static_cast<std::ptrdiff_t>(std::min(first, extents.size())),
                           extents.end(), std::uint64_t{1}, std::multiplies<>());
}

std::string instead_of_attribute(const std::string& object, const std::string& name)
{
    return object == "/" ? "/" + name : object + "." + name;
}

Hdf5Id simple_space(const Extents& extents)
{
    const std::vector<hsize_t> size{extents.begin(), extents.end()};
    return Hdf5Id(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr));
}

[[noreturn]] void refuse(const std::filesystem::path& path, bool writing, const std::string& what)
{
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_system_message, &reason);
    H5Eclear2(H5E_DEFAULT);
    if (reason.empty()) reason = what;
    throw InputError(
        path.string(), (writing ? "cannot be written: " : "cannot be read: ") + reason,
        writing ? "give a writable folder on a disk with free space" : "give a results file of voussoir");
}

Hdf5Id access_properties()
{
    // Every file is closed by its owner. At exit HDF5 would try once more to flush what a full disk refused, and
    // crash.
    H5dont_atexit();
    H5PLset_loading_state(0);  // no code is loaded for what a file asks
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    Hdf5Id properties(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_file_locking(properties.get(), false, true);
    return properties;
}

}  // namespace voussoir::app::results
