#include "records/source_file.h"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

namespace voussoir
{

namespace
{

constexpr std::uintmax_t largest_file = 1'000'000'000;  // bytes; a day at 200 Hz in text is some 300 MB
constexpr std::size_t faults_named = 10;

void split_lines(SourceFile& file)
{
    std::string_view rest = file.bytes;
    if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);  // byte order mark of UTF-8
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        file.lines.push_back(line);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
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
        faults_.push_back({file, std::to_string(unnamed_) + " more faults", "mend the ones above first"});
    }
    throw InputError(std::move(faults_));
}

}  // namespace voussoir
