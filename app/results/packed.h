// Plain values as bytes, for files of our own: little-endian, checked by a checksum, read without trust.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace voussoir::app::results
{

/// FNV-1a. @param hash of what came before
std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 14695981039346656037ULL);

/// Writes mark, payload, FNV-1a of the payload; the file is there whole or not at all. @throws InputError
void write_packed(const std::filesystem::path& path, std::string_view mark, const std::string& payload);

/// @param what the file should be: "a state file"
/// @returns the payload. @throws InputError when the file cannot be read, has another mark, or was damaged
std::string read_packed(const std::filesystem::path& path, std::string_view mark, const std::string& what);

/// The first `size` bytes of the payload, or as many as there are, unchecked, whatever the file's size.
/// @throws InputError when the file cannot be read or has another mark
std::string read_packed_head(const std::filesystem::path& path, std::string_view mark, const std::string& what,
                             std::size_t size);

[[noreturn]] void refuse_damaged(const std::filesystem::path& path);

class Packer
{
 public:
    template <typename T>
    void field(const T& value)
    {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }
    template <int D>
    void field(const Eigen::Matrix<double, D, 1>& v)
    {
        for (int i = 0; i < D; ++i) field(v[i]);
    }
    void field(const std::string& text)
    {
        field(static_cast<std::uint64_t>(text.size()));
        bytes += text;
    }
    template <typename T, std::size_t N>
    void field(const std::array<T, N>& values)
    {
        for (const T& value : values) field(value);
    }
    /// @param entry packs one: entry(packer, value)
    template <typename T, typename Entry>
    void list(const std::vector<T>& values, const Entry& entry)
    {
        field(static_cast<std::uint64_t>(values.size()));
        for (const T& value : values) entry(*this, value);
    }
    /// @param entry packs it: entry(packer, value)
    template <typename T, typename Entry>
    void maybe(const std::optional<T>& value, const Entry& entry)
    {
        field(value.has_value());
        if (value) entry(*this, *value);
    }
    template <typename T>
    void list(const std::vector<T>& values)
    {
        list(values, [](Packer& packer, const T& value) { packer.field(value); });
    }
    template <typename... T>
    void fields(const T&... values)
    {
        (field(values), ...);
    }
    std::string bytes;
};

/// Reads what Packer wrote. Never past the end: `whole` turns false instead.
class Unpacker
{
 public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
    template <typename T>
    void field(T& value)
    {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        whole = whole && bytes_.size() >= sizeof(T);
        if (!whole) return;
        std::memcpy(&value, bytes_.data(), sizeof(T));
        bytes_.remove_prefix(sizeof(T));
    }
    void field(bool& value)
    {
        char byte = 0;
        field(byte);
        value = byte != 0;
    }
    template <int D>
    void field(Eigen::Matrix<double, D, 1>& v)
    {
        for (int i = 0; i < D; ++i) field(v[i]);
    }
    void field(std::string& text)
    {
        std::uint64_t size = 0;
        field(size);
        whole = whole && size <= bytes_.size();
        if (!whole) return;
        text = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
    }
    template <typename T, std::size_t N>
    void field(std::array<T, N>& values)
    {
        for (T& value : values) field(value);
    }
    /// Grows with what is really there, whatever size is claimed. @param entry reads one: entry(unpacker, value)
    template <typename T, typename Entry>
    void list(std::vector<T>& values, const Entry& entry)
    {
        std::uint64_t size = 0;
        field(size);
        values.clear();
        for (; whole && size > 0; --size) entry(*this, values.emplace_back());
    }
    /// @param entry reads it: entry(unpacker, value)
    template <typename T, typename Entry>
    void maybe(std::optional<T>& value, const Entry& entry)
    {
        bool is_there = false;
        field(is_there);
        value.reset();
        if (is_there) entry(*this, value.emplace());
    }
    template <typename T>
    void list(std::vector<T>& values)
    {
        list(values, [](Unpacker& unpacker, T& value) { unpacker.field(value); });
    }
    template <typename... T>
    void fields(T&... values)
    {
        (field(values), ...);
    }
    bool done() const { return whole && bytes_.empty(); }
    bool whole = true;

 private:
    std::string_view bytes_;
};

}  // namespace voussoir::app::results
