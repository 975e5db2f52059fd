// The reading half of Hdf5File.
#include <hdf5.h>

#include "app/results/hdf5_detail.h"

namespace voussoir
{

using namespace hdf5_detail;

namespace
{
std::vector<std::string> unpack(const std::string& bytes, std::size_t length)
{
    std::vector<std::string> texts;
    for (std::size_t start = 0; start < bytes.size(); start += length) {
        const std::string text = bytes.substr(start, length);
        texts.push_back(text.substr(0, text.find('\0')));
    }
    return texts;
}
}  // namespace

bool Hdf5File::has(const std::string& name) const
{
    std::size_t end = 0;
    while (end != std::string::npos) {  // every group on the way must exist, else HDF5 calls it an error
        end = name.find('/', end + 1);
        if (H5Lexists(file_.get(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    }
    return true;
}

Hdf5Id Hdf5File::open_dataset(const std::string& name) const
{
    return Hdf5Id(check(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), "it has no dataset " + name));
}

Extents Hdf5File::extents(const std::string& name) const
{
    const Hdf5Id dataset = open_dataset(name), space(H5Dget_space(dataset.get()));
    std::vector<hsize_t> size(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.get()), name)));
    H5Sget_simple_extent_dims(space.get(), size.data(), nullptr);
    return {size.begin(), size.end()};
}

std::uint64_t Hdf5File::row_size(const std::string& name) const
{
    return product(extents(name), 1);
}

void Hdf5File::read_values(const std::string& name, ElementType type, std::uint64_t first, std::uint64_t count,
                           void* values) const
{
    const Hdf5Id dataset = open_dataset(name);
    const Extents all = extents(name);
    if (all.empty()) {
        check(H5Dread(dataset.get(), native(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
        return;
    }
    std::vector<hsize_t> start(all.size(), 0), size(all.begin(), all.end());
    if (first + count > all[0]) check(-1, name + " is shorter than it should be");
    start[0] = first;
    size[0] = count;
    if (count * product(all, 1) == 0) return;
    const Hdf5Id memory(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr));
    const Hdf5Id space(H5Dget_space(dataset.get()));
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr);
    check(H5Dread(dataset.get(), native(type), memory.get(), space.get(), H5P_DEFAULT, values), name);
}

std::string Hdf5File::read_text(const std::string& name) const
{
    const std::vector<std::string> texts = read_texts(name);
    return texts.empty() ? std::string() : texts.front();
}

std::vector<std::string> Hdf5File::read_texts(const std::string& name) const
{
    const Hdf5Id dataset = open_dataset(name), type(H5Dget_type(dataset.get())),
                 space(H5Dget_space(dataset.get()));
    const auto count = static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space.get()), name));
    const std::size_t length = H5Tget_size(type.get());
    std::string bytes(length * count, '\0');
    if (count > 0) {
        check(H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), name);
    }
    return unpack(bytes, length);
}

std::vector<std::string> Hdf5File::texts_attribute(const std::string& object, const std::string& name) const
{
    const Hdf5Id attribute(
        check(H5Aopen_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
              "it has no attribute " + name + " of " + object));
    const Hdf5Id type(H5Aget_type(attribute.get())), space(H5Aget_space(attribute.get()));
    const std::size_t length = H5Tget_size(type.get());
    std::string bytes(length * static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())), '\0');
    check(H5Aread(attribute.get(), type.get(), bytes.data()), name);
    return unpack(bytes, length);
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const
{
    const std::vector<std::string> texts = texts_attribute(object, name);
    return texts.empty() ? std::string() : texts.front();
}

double Hdf5File::number_attribute(const std::string& object, const std::string& name) const
{
    const Hdf5Id attribute(
        check(H5Aopen_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
              "it has no attribute " + name + " of " + object));
    double value = 0;
    check(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value), name);
    return value;
}

}  // namespace voussoir
