#include "records/formats/sac_header.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"

namespace voussoir::records::formats
{

namespace
{

constexpr std::size_t real_count = 70, integer_count = 40, word_bytes = 192;
constexpr std::size_t header_bytes = 4 * (real_count + integer_count) + word_bytes;
constexpr std::size_t footer_bytes = 22 * 8;  // of version 7: 22 doubles, the first is delta
constexpr std::size_t real_lines = 14, integer_lines = 8, word_lines = 8;

std::uint32_t read_bits(const std::string& bytes, std::size_t at, std::endian order)
{
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[at + i]);
        bits |= static_cast<std::uint32_t>(byte) << (8 * (order == std::endian::little ? i : 3 - i));
    }
    return bits;
}

std::int32_t read_integer(const std::string& bytes, std::size_t index, std::endian order)
{
    return static_cast<std::int32_t>(read_bits(bytes, 4 * (real_count + index), order));
}

double read_double(const std::string& bytes, std::size_t at, std::endian order)
{
    const bool is_little = order == std::endian::little;
    const std::uint64_t low = read_bits(bytes, at + (is_little ? 0 : 4), order);
    const std::uint64_t high = read_bits(bytes, at + (is_little ? 4 : 0), order);
    return std::bit_cast<double>(high << 32U | low);
}

bool is_version(double version)
{
    return version == 6 || version == 7;
}

/// A version, and logical values that are: narrow enough for any other binary file to fail.
bool is_binary_of(const std::string& bytes, std::endian order)
{
    if (bytes.size() < header_bytes || !is_version(read_integer(bytes, sac::version, order))) return false;
    for (std::size_t logical = sac::is_even; logical < sac::is_even + 4; ++logical) {
        const std::int32_t value = read_integer(bytes, logical, order);
        if (value != 0 && value != 1 && value != -12345) return false;
    }
    const std::int32_t type = read_integer(bytes, sac::file_type, order);
    return type == -12345 || (type > 0 && type < 200);
}

bool is_alphanumeric(const SourceFile& file)
{
    if (file.lines.size() <= real_lines + integer_lines + word_lines || !is_text(file)) return false;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < real_lines + integer_lines; ++i) {
        if (!text::parse_fortran(file.lines[i], numbers) || numbers.size() != 5) return false;
        if (i == real_lines + 1 && !is_version(numbers[1])) return false;
    }
    return true;
}

/// A step of 0.02 s is stored as 0.0199999996: the shortest decimal that is stored so is what was meant.
double shortest_decimal(float value)
{
    std::array<char, 40> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    double decimal = 0;
    const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    return error == std::errc() && text::parse_fortran_number(text, decimal) ? decimal : value;
}

SacHeader read_binary(const SourceFile& file, std::endian order)
{
    SacHeader header;
    const std::string& bytes = file.bytes;
    for (std::size_t i = 0; i < real_count; ++i)
        header.reals[i] = std::bit_cast<float>(read_bits(bytes, 4 * i, order));
    for (std::size_t i = 0; i < integer_count; ++i) header.integers[i] = read_integer(bytes, i, order);
    header.words = bytes.substr(4 * (real_count + integer_count), word_bytes);
    header.delta = shortest_decimal(header.reals[0]);
    std::size_t end = bytes.size();
    if (header.integers[sac::version] == 7 && end >= header_bytes + footer_bytes) {
        end -= footer_bytes;
        header.delta = read_double(bytes, end, order);
    }
    header.numbers.reserve((end - header_bytes) / 4);
    for (std::size_t at = header_bytes; at + 4 <= end; at += 4)
        header.numbers.push_back(std::bit_cast<float>(read_bits(bytes, at, order)));
    return header;
}

SacHeader read_alphanumeric(const SourceFile& file)
{
    SacHeader header;
    std::vector<double> on_line;
    for (std::size_t i = 0; i < real_lines + integer_lines; ++i) {
        text::parse_fortran(file.lines[i], on_line);
        for (std::size_t k = 0; k < 5; ++k) {
            const std::size_t index = 5 * i + k;
            if (i < real_lines) {
                header.reals[index] = static_cast<float>(on_line[k]);
            } else {
                const bool fits = std::abs(on_line[k]) < 1e15;
                header.integers[index - real_count] = fits ? static_cast<std::int64_t>(on_line[k]) : 0;
            }
        }
    }
    text::parse_fortran(file.lines.front(), on_line);
    header.delta = on_line.front();
    for (std::size_t i = real_lines + integer_lines; i < real_lines + integer_lines + word_lines; ++i) {
        std::string line(file.lines[i].substr(0, 24));
        line.resize(24, ' ');
        header.words += line;
    }
    FaultList faults;
    for (std::size_t i = real_lines + integer_lines + word_lines; i < file.lines.size(); ++i) {
        if (text::trim(file.lines[i]).empty()) continue;
        if (!text::parse_fortran(file.lines[i], on_line))
            add_row_fault(file, i, "every line after the header holds samples only", faults);
        else
            for (const double number : on_line) header.numbers.push_back(static_cast<float>(number));
    }
    faults.throw_if_any(file.name);
    return header;
}

}  // namespace

bool is_sac(const SourceFile& file)
{
    return is_binary_of(file.bytes, std::endian::little) || is_binary_of(file.bytes, std::endian::big) ||
           is_alphanumeric(file);
}

SacHeader read_sac_header(const SourceFile& file)
{
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        if (is_binary_of(file.bytes, order)) return read_binary(file, order);
    }
    return read_alphanumeric(file);
}

std::string sac_word(const SacHeader& header, sac::Word word)
{
    std::string_view text = std::string_view(header.words).substr(word, 8);
    text = text::trim(text.substr(0, text.find('\0')));
    return text.starts_with("-12345") ? "" : std::string(text);
}

}  // namespace voussoir::records::formats
