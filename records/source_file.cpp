#include "records/source_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <new>
#include <system_error>
#include <utility>

#include "records/content.h"

namespace voussoir::records
{

namespace
{

constexpr std::uintmax_t largest_file = 1'000'000'000;  // bytes; a day at 200 Hz in text is some 300 MB
constexpr std::size_t faults_named = 10;
constexpr int max_packings = 3;  // one inside another

void split_lines(SourceFile& file)
{
    std::string_view rest = file.bytes;
    if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);  // byte order mark of UTF-8
    // Old Macintosh programs end lines with CR alone.
    const char line_end = rest.find('\n') == std::string_view::npos ? '\r' : '\n';
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(line_end), rest.size());
        std::string_view line = rest.substr(0, end);
        while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        file.lines.push_back(line);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
}

/// Unpacks gzip, one member after another.
std::string unpack(const std::string& name, const std::string& packed)
{
    const auto damaged = [&](const char* what) {
        return InputError(name, std::string("its gzip packing ") + what, "download the file again");
    };
    z_stream stream{};
    if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> guard(&stream, inflateEnd);
    // zlib's interface is not const; it does not write there.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    std::string unpacked;
    std::array<char, 1U << 16U> piece;
    int state = Z_OK;
    while (stream.avail_in > 0) {
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END) throw damaged("is damaged");
        unpacked.append(piece.data(), piece.size() - stream.avail_out);
        if (unpacked.size() > largest_file) throw damaged("holds more than 1 GB");
        if (state == Z_STREAM_END && stream.avail_in > 0 && inflateReset(&stream) != Z_OK)
            throw damaged("is damaged");
    }
    while (state == Z_OK) {  // what the last piece had no room for
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END) throw damaged("is cut short");
        unpacked.append(piece.data(), piece.size() - stream.avail_out);
        if (unpacked.size() > largest_file) throw damaged("holds more than 1 GB");
    }
    return unpacked;
}

}  // namespace

void load_source_file(const std::filesystem::path& path, SourceFile& file)
{
    file.name = path.string();
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw InputError(file.name, "no such file", "name an existing record");
    if (!std::filesystem::is_regular_file(status)) {
        throw InputError(file.name, "not a regular file", "name a file that holds a record");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) throw InputError(file.name, "cannot be read: " + error.message(), "check its permissions");
    if (size == 0) throw InputError(file.name, "the file is empty", "a record holds at least 2 samples");
    if (size > largest_file) {
        throw InputError(file.name, "the file has " + std::to_string(size) + " bytes",
                         "a record has at most " + std::to_string(largest_file));
    }
    std::ifstream stream(path, std::ios::binary);
    file.bytes.resize(size);
    if (!stream.read(file.bytes.data(), static_cast<std::streamsize>(size))) {
        throw InputError(file.name, "cannot be read", "check its permissions");
    }
    load_source_bytes(file.name, std::move(file.bytes), file);
}

void load_source_bytes(const std::string& name, std::string bytes, SourceFile& file)
{
    file.name = name;
    // Some servers pack what was packed already.
    for (int packing = 0; packing < max_packings && bytes.starts_with("\x1F\x8B"); ++packing)
        bytes = unpack(name, bytes);
    file.bytes = decode_utf16(std::move(bytes));
    if (file.bytes.empty()) throw InputError(name, "the file is empty", "a record holds at least 2 samples");
    split_lines(file);
}

bool is_text(const SourceFile& file)
{
    return std::none_of(file.bytes.begin(), file.bytes.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r' && byte != '\f' && byte != 0x1A) ||
               byte == 0x7F;  // 0x1A ends a text of DOS
    });
}

void FaultList::add(std::string place, std::string found, std::string expected)
{
    if (faults_.size() == faults_named) {
        ++unnamed_;
        return;
    }
    faults_.push_back({std::move(place), std::move(found), std::move(expected)});
}

void FaultList::throw_if_any(const std::string& file)
{
    if (faults_.empty()) return;
    if (unnamed_ > 0) {
        faults_.push_back({file, std::to_string(unnamed_) + " more faults", "correct those above first"});
    }
    throw InputError(std::move(faults_));
}

}  // namespace voussoir::records
