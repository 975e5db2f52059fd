// The header of SAC, binary of either byte order or alphanumeric: 70 reals, 40 integers, 24 words of 8 characters.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "records/source_file.h"

namespace voussoir::records::formats
{

struct SacHeader {
    std::array<float, 70> reals{};
    std::array<std::int64_t, 40> integers{};
    std::string words;           // 192 characters
    std::vector<float> numbers;  // all that follows the header, up to the file's end (version 7: to its footer)
    double delta = 0;            // s, with all the digits the file has
};

/// Places in the header. Source: [SacManual].
namespace sac
{
enum Real : std::size_t { begin = 5, azimuth = 57, inclination = 58 };
enum Integer : std::size_t {
    year = 0,
    day = 1,
    hour = 2,
    minute = 3,
    second = 4,
    millisecond = 5,
    version = 6,
    count = 9,
    file_type = 15,
    dependent = 16,
    is_even = 35
};
enum Word : std::size_t { station = 0, location = 24, component = 160, network = 168 };
constexpr double undefined = -12345;
}  // namespace sac

bool is_sac(const SourceFile& file);

/// @param file one of which is_sac is true
/// @throws InputError when numbers after an alphanumeric header cannot be read
SacHeader read_sac_header(const SourceFile& file);

/// The eight characters of a word without blanks; empty when undefined.
std::string sac_word(const SacHeader& header, sac::Word word);

}  // namespace voussoir::records::formats
