// The reading half of Hdf5File.
#include <hdf5.h>

#include <algorithm>
#include <system_error>

#include "app/results/hdf5_detail.h"

namespace voussoir::app::results
{

namespace
{
constexpr std::uint64_t largest_attribute = 1U << 16U;  // bytes; the format itself allows no more

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
    // A link of another kind would lead into another file.
    for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
        H5L_info_t link{};
        check(H5Lget_info(file_.get(), name.substr(0, end).c_str(), &link, H5P_DEFAULT),
              "it has no dataset " + name);
        if (link.type != H5L_TYPE_HARD) check(-1, name + " is a link to somewhere else");
        if (end == std::string::npos) break;
    }
    Hdf5Id dataset(check(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), "it has no dataset " + name));
    const Hdf5Id made(check(H5Dget_create_plist(dataset.get()), name));
    const H5D_layout_t layout = H5Pget_layout(made.get());
    if ((layout != H5D_CHUNKED && layout != H5D_CONTIGUOUS && layout != H5D_COMPACT) ||
        H5Pget_nfilters(made.get()) != 0 || H5Pget_external_count(made.get()) != 0)
        check(-1, name + " is compressed, or its values are stored elsewhere");
    return dataset;
}

const Hdf5Id& Hdf5File::dataset(const std::string& name) const
{
    const auto known = opened_.find(name);
    return known != opened_.end() ? known->second : opened_.emplace(name, open_dataset(name)).first->second;
}

Extents Hdf5File::extents(const std::string& name) const
{
    const Hdf5Id space(check(H5Dget_space(dataset(name).get()), name));
    std::vector<hsize_t> size(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.get()), name)));
    check(H5Sget_simple_extent_dims(space.get(), size.data(), nullptr), name);
    return {size.begin(), size.end()};
}

RowsInFile Hdf5File::rows_in_file(const std::string& name, std::uint64_t first, std::uint64_t row_bytes) const
{
    const Extents all = extents(name);
    if (all.empty() || first >= all[0]) check(-1, name + " is shorter than it should be");
    const Hdf5Id& opened = dataset(name);
    const Hdf5Id made(check(H5Dget_create_plist(opened.get()), name));
    if (H5Pget_layout(made.get()) == H5D_CONTIGUOUS)
        return {H5Dget_offset(opened.get()) + first * row_bytes, all[0] - first};
    std::vector<hsize_t> chunk(all.size()), corner(all.size(), 0);
    check(H5Pget_chunk(made.get(), static_cast<int>(chunk.size()), chunk.data()), name);
    if (chunk[0] == 0) check(-1, name + " has chunks without rows");
    corner[0] = first - first % chunk[0];
    unsigned filters = 0;
    haddr_t address = 0;
    hsize_t size = 0;
    check(H5Dget_chunk_info_by_coord(opened.get(), corner.data(), &filters, &address, &size), name);
    if (address == HADDR_UNDEF) check(-1, name + " has rows that were never written");
    return {address + (first - corner[0]) * row_bytes,
            std::min<std::uint64_t>(chunk[0] - (first - corner[0]), all[0] - first)};
}

std::uint64_t Hdf5File::values_in_rows(const std::string& name, std::uint64_t first, std::uint64_t count) const
{
    const Extents all = extents(name);
    const std::uint64_t rows = all.empty() ? 1 : all[0];
    if (first > rows || count > rows - first) check(-1, name + " is shorter than it should be");
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path_, error);
    std::uint64_t values = count;
    for (std::size_t axis = 1; axis < all.size(); ++axis) {
        if (all[axis] != 0 && values > bytes / all[axis]) check(-1, name + " is larger than the file");
        values *= all[axis];
    }
    if (values > bytes) check(-1, name + " is larger than the file");
    return values;
}

void Hdf5File::read_values(const std::string& name, ElementType type, std::uint64_t first, std::uint64_t count,
                           void* values) const
{
    const Hdf5Id& opened = dataset(name);
    const Hdf5Id kept_as(check(H5Dget_type(opened.get()), name));
    const H5T_class_t kind = H5Tget_class(kept_as.get());
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) check(-1, name + " holds no numbers");
    const Extents all = extents(name);
    if (all.empty()) {
        check(H5Dread(opened.get(), native(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
        return;
    }
    std::vector<hsize_t> start(all.size(), 0), size(all.begin(), all.end());
    start[0] = first;
    size[0] = count;
    if (count * product(all, 1) == 0) return;
    const Hdf5Id memory(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr));
    const Hdf5Id space(H5Dget_space(opened.get()));
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr);
    check(H5Dread(opened.get(), native(type), memory.get(), space.get(), H5P_DEFAULT, values), name);
}

namespace
{
/// Length of the texts of a type; 0: it holds none, or texts that lie elsewhere in the file.
std::size_t text_length(const Hdf5Id& type)
{
    if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0) return 0;
    return H5Tget_size(type.get());
}
}  // namespace

std::string Hdf5File::read_text(const std::string& name) const
{
    const std::vector<std::string> texts = read_texts(name);
    return texts.empty() ? std::string() : texts.front();
}

std::vector<std::string> Hdf5File::read_texts(const std::string& name) const
{
    const Hdf5Id& opened = dataset(name);
    const Hdf5Id type(check(H5Dget_type(opened.get()), name)), space(check(H5Dget_space(opened.get()), name));
    const auto count = static_cast<std::uint64_t>(check(H5Sget_simple_extent_npoints(space.get()), name));
    const std::size_t length = text_length(type);
    std::error_code error;
    if (length == 0) check(-1, name + " holds no texts");
    if (count > std::filesystem::file_size(path_, error) / length) check(-1, name + " is larger than the file");
    std::string bytes(length * count, '\0');
    if (count > 0) {
        check(H5Dread(opened.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), name);
    }
    return unpack(bytes, length);
}

std::vector<std::string> Hdf5File::texts_attribute(const std::string& object, const std::string& name) const
{
    const std::string instead = instead_of_attribute(object, name);
    if (H5Aexists_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT) == 0 && has(instead))
        return read_texts(instead);
    const Hdf5Id attribute(
        check(H5Aopen_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
              "it has no attribute " + name + " of " + object));
    const Hdf5Id type(check(H5Aget_type(attribute.get()), name)),
        space(check(H5Aget_space(attribute.get()), name));
    const auto count = static_cast<std::uint64_t>(check(H5Sget_simple_extent_npoints(space.get()), name));
    const std::size_t length = text_length(type);
    if (length == 0) check(-1, name + " of " + object + " is no text");
    if (count > largest_attribute / length) check(-1, name + " of " + object + " is too large");
    std::string bytes(length * count, '\0');
    if (count > 0) check(H5Aread(attribute.get(), type.get(), bytes.data()), name);
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
    const Hdf5Id type(check(H5Aget_type(attribute.get()), name)),
        space(check(H5Aget_space(attribute.get()), name));
    const H5T_class_t kind = H5Tget_class(type.get());
    if (H5Sget_simple_extent_npoints(space.get()) != 1 || (kind != H5T_INTEGER && kind != H5T_FLOAT))
        check(-1, name + " of " + object + " is not one number");
    double value = 0;
    check(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value), name);
    return value;
}

}  // namespace voussoir::app::results
