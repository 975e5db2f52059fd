#include "app/words/look_words.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <utility>

namespace voussoir::app::words
{

const char* const view_expected = "give front, right, back, left or top, or AZIMUTH,ELEVATION in degrees: 30,20";
const char* const cut_expected = "give an axis, < or >, and a place in m: x>1.5";
const char* const whole_structure = "structure";

std::optional<ViewAngles> view_named(const std::string& words)
{
    constexpr double degree = std::numbers::pi / 180;
    static const std::map<std::string, std::pair<double, double>> named = {
        {"front", {0, 0}}, {"right", {90, 0}}, {"back", {180, 0}}, {"left", {-90, 0}}, {"top", {0, 90}}};
    if (const auto view = named.find(words); view != named.end())
        return ViewAngles{view->second.first * degree, view->second.second * degree};
    double azimuth = 0, elevation = 0;
    char rest = 0;
    const bool read = std::sscanf(words.c_str(), "%lf,%lf%c", &azimuth, &elevation, &rest) == 2;
    if (!read || !(std::abs(azimuth) <= 360) || !(std::abs(elevation) <= 90)) return std::nullopt;
    return ViewAngles{azimuth * degree, elevation * degree};
}

std::optional<Cut> cut_named(const std::string& words)
{
    char axis = 0, side = 0, rest = 0;
    double place = 0;
    const int read = std::sscanf(words.c_str(), " %c %c %lf%c", &axis, &side, &place, &rest);
    const bool good = read == 3 && axis >= 'x' && axis <= 'z' && (side == '<' || side == '>');
    if (!good || !std::isfinite(place)) return std::nullopt;
    return Cut{axis - 'x', side == '>', place};
}

}  // namespace voussoir::app::words
