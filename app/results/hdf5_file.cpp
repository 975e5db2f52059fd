#include "app/results/hdf5_file.h"

#include <hdf5.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/results/hdf5_detail.h"
#include "app/results/units.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

Hdf5Id::~Hdf5Id()
{
    close();
}

std::int64_t Hdf5Id::close()
{
    const std::int64_t id = std::exchange(id_, -1);
    return id >= 0 ? H5Idec_ref(id) : 0;
}

Hdf5Id& Hdf5Id::operator=(Hdf5Id&& other) noexcept
{
    std::swap(id_, other.id_);
    return *this;
}

namespace
{

/// Chunks of about so many bytes; at least 8 rows unless these are huge.
std::uint64_t rows_per_chunk(std::uint64_t row_bytes, std::uint64_t chunk_bytes)
{
    const std::uint64_t usual = std::clamp<std::uint64_t>(chunk_bytes / row_bytes, 8, 1024);
    return std::clamp<std::uint64_t>((1U << 24) / row_bytes, 1, usual);
}

std::vector<hsize_t> to_hsize(const Extents& extents)
{
    return {extents.begin(), extents.end()};
}

/// Files that hold no time of their making, so that two runs give the same bytes.
Hdf5Id timeless(hid_t kind)
{
    Hdf5Id properties(H5Pcreate(kind));
    H5Pset_obj_track_times(properties.get(), false);
    return properties;
}

constexpr std::size_t largest_text_attribute = 60'000;  // bytes; HDF5 has 64 kB for it and what describes it

/// Fixed-length strings, all as long as the longest: they need no heap.
struct PackedTexts {
    Hdf5Id type;
    std::string bytes;
};

PackedTexts pack(const std::vector<std::string>& texts)
{
    std::size_t length = 1;
    for (const std::string& text : texts) length = std::max(length, text.size());
    PackedTexts packed{Hdf5Id(H5Tcopy(H5T_C_S1)), {}};
    H5Tset_size(packed.type.get(), length);
    H5Tset_cset(packed.type.get(), H5T_CSET_UTF8);
    H5Tset_strpad(packed.type.get(), H5T_STR_NULLPAD);
    for (const std::string& text : texts) packed.bytes += text + std::string(length - text.size(), '\0');
    return packed;
}

}  // namespace

std::int64_t Hdf5File::check(std::int64_t result, const std::string& what) const
{
    if (result < 0) refuse(path_, writing_, what);
    return result;
}

Hdf5File Hdf5File::create(const std::filesystem::path& path)
{
    Hdf5File result;
    result.path_ = path;
    result.writing_ = true;
    const Hdf5Id access = access_properties();
    // Room is not asked for in advance: what is left of it is given back by a flush, and then the bytes of the
    // file would tell when it was flushed.
    H5Pset_meta_block_size(access.get(), 0);
    H5Pset_small_data_block_size(access.get(), 0);
    result.file_ = Hdf5Id(result.check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()),
                                       "no file can be created there"));
    return result;
}

Hdf5File Hdf5File::open(const std::filesystem::path& path)
{
    Hdf5File result;
    result.path_ = path;
    const Hdf5Id access = access_properties();
    std::error_code error;
    const std::filesystem::file_status there = std::filesystem::status(path, error);
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
        result.check(-1, "it is no file");  // HDF5 would wait for a pipe
    result.file_ = Hdf5Id(
        result.check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), "it is not a complete HDF5 file"));
    return result;
}

void Hdf5File::make_group(const std::string& name)
{
    const Hdf5Id properties = timeless(H5P_GROUP_CREATE);
    Hdf5Id group(check(H5Gcreate2(file_.get(), name.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), name));
    check(group.close(), name);
}

void Hdf5File::write_dataset(const std::string& name, std::int64_t type, const Hdf5Id& space, const void* values)
{
    const Hdf5Id properties = timeless(H5P_DATASET_CREATE);
    Hdf5Id dataset(
        check(H5Dcreate2(file_.get(), name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
              name));
    write_unit(name);
    if (H5Sget_simple_extent_npoints(space.get()) != 0)
        check(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
    check(dataset.close(), name);  // a small one is written only here
}

void Hdf5File::write_unit(const std::string& dataset)
{
    if (const std::string_view unit = unit_of(dataset); !unit.empty())
        attribute(dataset, "unit", std::string(unit));
}

void Hdf5File::write_values(const std::string& name, ElementType type, const void* values, const Extents& extents)
{
    write_dataset(name, native(type), simple_space(extents), values);
}

void Hdf5File::write_text(const std::string& name, const std::string& text)
{
    const PackedTexts packed = pack({text});
    write_dataset(name, packed.type.get(), Hdf5Id(H5Screate(H5S_SCALAR)), packed.bytes.data());
}

void Hdf5File::write_texts(const std::string& name, const std::vector<std::string>& texts)
{
    const PackedTexts packed = pack(texts);
    write_dataset(name, packed.type.get(), simple_space({texts.size()}), packed.bytes.data());
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, std::int64_t type,
                               const Hdf5Id& space, const void* value)
{
    Hdf5Id attribute(check(H5Acreate_by_name(file_.get(), object.c_str(), name.c_str(), type, space.get(),
                                             H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                           name));
    check(H5Awrite(attribute.get(), type, value), name);
    check(attribute.close(), name);
}

void Hdf5File::attribute(const std::string& object, const std::string& name, const std::string& text)
{
    const PackedTexts packed = pack({text});
    if (packed.bytes.size() > largest_text_attribute) return write_text(instead_of_attribute(object, name), text);
    write_attribute(object, name, packed.type.get(), Hdf5Id(H5Screate(H5S_SCALAR)), packed.bytes.data());
}

void Hdf5File::attribute(const std::string& object, const std::string& name, const std::vector<std::string>& texts)
{
    const PackedTexts packed = pack(texts);
    if (packed.bytes.size() > largest_text_attribute)
        return write_texts(instead_of_attribute(object, name), texts);
    write_attribute(object, name, packed.type.get(), simple_space({texts.size()}), packed.bytes.data());
}

void Hdf5File::attribute(const std::string& object, const std::string& name, double value)
{
    write_attribute(object, name, H5T_NATIVE_DOUBLE, Hdf5Id(H5Screate(H5S_SCALAR)), &value);
}

void Hdf5File::attribute(const std::string& object, const std::string& name, std::int64_t value)
{
    write_attribute(object, name, H5T_NATIVE_INT64, Hdf5Id(H5Screate(H5S_SCALAR)), &value);
}

Hdf5Series Hdf5File::make_series(const std::string& name, ElementType type, const Extents& row,
                                 std::uint64_t chunk_bytes)
{
    Extents extents{0}, chunk{1}, limit{H5S_UNLIMITED};
    for (const std::uint64_t size : row) {
        extents.push_back(size);
        chunk.push_back(std::max<std::uint64_t>(size, 1));
        limit.push_back(size);
    }
    chunk[0] = rows_per_chunk(product(chunk, 1) * bytes_of(type), chunk_bytes);
    const std::vector<hsize_t> size = to_hsize(extents), chunk_size = to_hsize(chunk), max_size = to_hsize(limit);
    const Hdf5Id space(H5Screate_simple(static_cast<int>(size.size()), size.data(), max_size.data()));
    const Hdf5Id create = timeless(H5P_DATASET_CREATE);
    H5Pset_chunk(create.get(), static_cast<int>(chunk_size.size()), chunk_size.data());
    const Hdf5Id access(
        H5Pcreate(H5P_DATASET_ACCESS));  // rows go straight to the file, not chunks again and again
    H5Pset_chunk_cache(access.get(), H5D_CHUNK_CACHE_NSLOTS_DEFAULT, 0, H5D_CHUNK_CACHE_W0_DEFAULT);
    Hdf5Series series{name, {}, type, extents, chunk[0]};
    series.dataset = Hdf5Id(check(
        H5Dcreate2(file_.get(), name.c_str(), native(type), space.get(), H5P_DEFAULT, create.get(), access.get()),
        name));
    write_unit(name);
    return series;
}

void Hdf5File::append_values(Hdf5Series& series, ElementType type, const void* values, std::size_t count,
                             std::uint64_t rows)
{
    DDA_ASSERT(type == series.type && count == rows * product(series.extents, 1));
    static_cast<void>(count);
    if (rows == 0) return;
    std::vector<hsize_t> start(series.extents.size(), 0), size = to_hsize(series.extents);
    start[0] = size[0];
    size[0] += rows;
    check(H5Dset_extent(series.dataset.get(), size.data()), series.name);
    series.extents[0] += rows;
    size[0] = rows;
    if (product(series.extents, 1) == 0) return;
    const Hdf5Id memory(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr));
    const Hdf5Id space(H5Dget_space(series.dataset.get()));
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr);
    check(H5Dwrite(series.dataset.get(), native(type), memory.get(), space.get(), H5P_DEFAULT, values),
          series.name);
}

void Hdf5File::overwrite(const std::string& name, std::int64_t value)
{
    Hdf5Id dataset = open_dataset(name);
    check(H5Dwrite(dataset.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value), name);
    check(dataset.close(), name);
}

void Hdf5File::flush()
{
    check(H5Fflush(file_.get(), H5F_SCOPE_LOCAL), "what was written could not be stored");
}

void Hdf5File::close()
{
    if (file_.get() < 0) return;
    opened_.clear();
    flush();
    check(file_.close(), "what was written could not be stored");
}

void Hdf5File::close(Hdf5Series& series) const
{
    check(series.dataset.close(), series.name);
}

}  // namespace voussoir::app::results
