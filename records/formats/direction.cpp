#include "records/formats/direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/words.h"

namespace voussoir::records::formats
{

namespace
{

struct NamedAzimuth {
    std::string_view name;
    double azimuth;
};

constexpr std::array<NamedAzimuth, 24> named_azimuths{{
    {"n", 0},          {"s", 180},         {"e", 90},          {"w", 270},         {"north", 0},
    {"south", 180},    {"east", 90},       {"west", 270},      {"ns", 0},          {"sn", 0},
    {"ew", 90},        {"we", 90},         {"ne", 45},         {"se", 135},        {"sw", 225},
    {"nw", 315},       {"northsouth", 0},  {"eastwest", 90},   {"northward", 0},   {"eastward", 90},
    {"northeast", 45}, {"southeast", 135}, {"southwest", 225}, {"northwest", 315},
}};
constexpr std::array<std::string_view, 9> upward{"up",   "upward",   "upwards", "v", "ver",
                                                 "vert", "vertical", "z",       "ud"};
constexpr std::array<std::string_view, 5> downward{"down", "downward", "downwards", "dn", "dwn"};

/// The words that name the direction, without what follows them, blanks and hyphens: "n28w", "90deg", "up".
std::string bare(std::string_view text)
{
    text = text::trim(text);
    text =
        text::trim(text.substr(0, std::min({text.find("  "), text.find('('), text.find(','), text.find('\t')})));
    std::string word;
    for (const char c : text::lower_case(text)) {
        if (c != ' ' && c != '_' && !(c == '-' && !word.empty())) word += c;
    }
    if (word.ends_with('.')) word.pop_back();
    return word;
}

std::optional<double> in_circle(double azimuth)
{
    if (!(std::abs(azimuth) <= 360)) return std::nullopt;
    const double turned = std::fmod(azimuth + 360, 360);
    return turned == 0 ? 0 : turned;
}

/// "28w" after "n" or "s": an angle from that pole towards east or west.
std::optional<double> parse_bearing(char pole, std::string_view rest)
{
    double angle = 0;
    if (rest.size() < 2 || !text::parse_fortran_number(rest.substr(0, rest.size() - 1), angle))
        return std::nullopt;
    if (!(angle >= 0) || angle > 90) return std::nullopt;
    const double towards_east = pole == 'n' ? angle : 180 - angle;
    if (rest.back() == 'e') return in_circle(towards_east);
    if (rest.back() == 'w') return in_circle(-towards_east);
    return std::nullopt;
}

std::optional<double> parse_azimuth(std::string_view word)
{
    for (const NamedAzimuth& named : named_azimuths) {
        if (word == named.name) return named.azimuth;
    }
    if (word.front() == 'n' || word.front() == 's') return parse_bearing(word.front(), word.substr(1));
    double azimuth = 0;
    const std::size_t used = text::parse_leading_number(word, azimuth);
    const std::string_view unit = word.substr(used);
    const bool in_degrees = unit.empty() || unit == "deg" || unit == "degree" || unit == "degrees" ||
                            unit == "\xC2\xB0" || unit == "\xB0";
    return used > 0 && in_degrees ? in_circle(azimuth) : std::nullopt;
}

}  // namespace

Direction parse_direction(std::string_view text)
{
    const std::string word = bare(text);
    Direction direction;
    if (word.empty()) return direction;
    direction.is_vertical = std::find(upward.begin(), upward.end(), word) != upward.end();
    direction.points_down = std::find(downward.begin(), downward.end(), word) != downward.end();
    if (!direction.is_vertical && !direction.points_down) direction.azimuth = parse_azimuth(word);
    return direction;
}

void set_direction(Channel& channel, const Direction& direction, std::vector<std::string>& remarks)
{
    channel.azimuth = direction.azimuth;
    channel.is_vertical = direction.is_vertical;
    if (direction.points_down) {
        remarks.push_back("component \"" + channel.component +
                          "\" is positive downwards: it is left without a direction, since a vertical is positive "
                          "upwards here");
    }
}

}  // namespace voussoir::records::formats
