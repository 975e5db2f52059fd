// Our own thin, owning wrapper of an HDF5 file. The library itself is known only to hdf5_file.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace voussoir::app::results
{

enum class ElementType { float32, float64, int32, int64 };

template <typename T>
constexpr ElementType element_type_of();
template <>
constexpr ElementType element_type_of<float>()
{
    return ElementType::float32;
}
template <>
constexpr ElementType element_type_of<double>()
{
    return ElementType::float64;
}
template <>
constexpr ElementType element_type_of<std::int32_t>()
{
    return ElementType::int32;
}
template <>
constexpr ElementType element_type_of<std::int64_t>()
{
    return ElementType::int64;
}

using Extents = std::vector<std::uint64_t>;

/// Rows of a dataset that lie in the file byte after byte.
struct RowsInFile {
    std::uint64_t address = 0, count = 0;  // of the first byte; rows
};

/// An HDF5 identifier that closes itself. The kind is known to the library.
class Hdf5Id
{
 public:
    Hdf5Id() = default;
    explicit Hdf5Id(std::int64_t id) : id_(id) {}
    ~Hdf5Id();
    Hdf5Id(Hdf5Id&& other) noexcept : id_(other.id_) { other.id_ = -1; }
    Hdf5Id& operator=(Hdf5Id&& other) noexcept;
    Hdf5Id(const Hdf5Id&) = delete;
    Hdf5Id& operator=(const Hdf5Id&) = delete;
    std::int64_t get() const { return id_; }
    /// What was held back in memory is written now. @returns negative when it could not be, which the destructor,
    /// where it closes, cannot tell
    std::int64_t close();

 private:
    std::int64_t id_ = -1;
};

/// A dataset that grows along its first axis, kept open while it grows.
struct Hdf5Series {
    std::string name;
    Hdf5Id dataset;
    ElementType type = ElementType::float64;
    Extents extents;               // extents[0]: rows so far
    std::uint64_t chunk_rows = 1;  // rows by which the file grows
};

/// A file in the oldest HDF5 format, which every reader opens. No file is locked: a run may be looked at while it
/// writes. Every function throws InputError with the file's name and the system's reason.
///
/// What is read is not trusted: datasets are plain ones of this very file (no filters, no links elsewhere), texts
/// are texts and numbers numbers, and nothing larger than the file itself is ever asked for.
class Hdf5File
{
 public:
    static Hdf5File create(const std::filesystem::path& path);  // replaces a file of that name
    static Hdf5File open(const std::filesystem::path& path);    // read only

    void make_group(const std::string& name);
    void write_text(const std::string& name, const std::string& text);
    void write_texts(const std::string& name, const std::vector<std::string>& texts);
    template <typename T>
    void write(const std::string& name, const std::vector<T>& values, const Extents& extents)
    {
        write_values(name, element_type_of<T>(), values.data(), extents);
    }
    template <typename T>
    void write(const std::string& name, const std::vector<T>& values)
    {
        write(name, values, {values.size()});
    }
    /// Attributes of the group or dataset `object`. HDF5 has no room for more than 64 kB in one: texts that are
    /// larger become a dataset `object.name` (of the root `/name`), which text_attribute() finds as well.
    void attribute(const std::string& object, const std::string& name, const std::string& text);
    void attribute(const std::string& object, const std::string& name, const std::vector<std::string>& texts);
    void attribute(const std::string& object, const std::string& name, double value);
    void attribute(const std::string& object, const std::string& name, std::int64_t value);

    /// @param row extents of one row; empty for one number per row; @param chunk_bytes by which the file grows
    Hdf5Series make_series(const std::string& name, ElementType type, const Extents& row,
                           std::uint64_t chunk_bytes);
    template <typename T>
    void append(Hdf5Series& series, const std::vector<T>& values, std::uint64_t rows = 1)
    {
        append_values(series, element_type_of<T>(), values.data(), values.size(), rows);
    }
    /// Replaces the one number of a dataset, in its place.
    void overwrite(const std::string& name, std::int64_t value);
    /// All that was written reaches the operating system: it survives the death of this process.
    void flush();
    /// No more rows come.
    void close(Hdf5Series& series) const;
    /// Flushes and closes, so that a failure is heard; without it the destructor closes silently.
    void close();

    bool has(const std::string& name) const;
    Extents extents(const std::string& name) const;
    /// Where row `first` lies, and how many rows from it on follow without a gap. @param row_bytes of one row
    RowsInFile rows_in_file(const std::string& name, std::uint64_t first, std::uint64_t row_bytes) const;
    std::string read_text(const std::string& name) const;
    std::vector<std::string> read_texts(const std::string& name) const;
    std::string text_attribute(const std::string& object, const std::string& name) const;
    std::vector<std::string> texts_attribute(const std::string& object, const std::string& name) const;
    double number_attribute(const std::string& object, const std::string& name) const;
    template <typename T>
    std::vector<T> read(const std::string& name) const
    {
        const Extents size = extents(name);
        return read_rows<T>(name, 0, size.empty() ? 1 : size[0]);
    }
    /// Rows [first, first + count) along the first axis, flat.
    template <typename T>
    std::vector<T> read_rows(const std::string& name, std::uint64_t first, std::uint64_t count) const
    {
        std::vector<T> values(values_in_rows(name, first, count));
        read_values(name, element_type_of<T>(), first, count, values.data());
        return values;
    }

 private:
    void write_unit(const std::string& dataset);
    void write_dataset(const std::string& name, std::int64_t type, const Hdf5Id& space, const void* values);
    void write_attribute(const std::string& object, const std::string& name, std::int64_t type,
                         const Hdf5Id& space, const void* value);
    void write_values(const std::string& name, ElementType type, const void* values, const Extents& extents);
    void append_values(Hdf5Series& series, ElementType type, const void* values, std::size_t count,
                       std::uint64_t rows);
    std::uint64_t values_in_rows(const std::string& name, std::uint64_t first, std::uint64_t count) const;
    void read_values(const std::string& name, ElementType type, std::uint64_t first, std::uint64_t count,
                     void* values) const;
    Hdf5Id open_dataset(const std::string& name) const;
    const Hdf5Id& dataset(const std::string& name) const;
    std::int64_t check(std::int64_t result, const std::string& what) const;

    std::filesystem::path path_;
    bool writing_ = false;
    Hdf5Id file_;
    // What was read from stays open: a run's frames are read one by one, and to open is dearer than to read.
    mutable std::map<std::string, Hdf5Id> opened_;
};

}  // namespace voussoir::app::results
