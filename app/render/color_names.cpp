#include "app/render/color_names.h"

#include <algorithm>
#include <array>

#include "libdda/errors.h"

namespace voussoir::app::render
{
namespace
{

constexpr std::array<const char*, 8> colors = {"displacement", "principal_stress", "velocity",         "opening",
                                               "slip",         "friction",         "principal_strain", "group"};
constexpr std::array<const char*, 3> formats = {"mp4", "gif", "webp"};

template <std::size_t N>
std::size_t place_of(const std::string& name, const std::array<const char*, N>& names, const char* what)
{
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string all;
    for (const char* known : names) all += (all.empty() ? "" : ", ") + std::string(known);
    throw InputError(what, "\"" + name + "\"", "one of " + all);
}

}  // namespace

std::vector<std::string> color_names()
{
    return {colors.begin(), colors.end()};
}

const char* name_of(SnapshotColor color)
{
    return colors.at(static_cast<std::size_t>(color));
}

SnapshotColor color_named(const std::string& name)
{
    return static_cast<SnapshotColor>(place_of(name, colors, "color"));
}

std::vector<std::string> film_format_names()
{
    return {formats.begin(), formats.end()};
}

const char* name_of(FilmFormat format)
{
    return formats.at(static_cast<std::size_t>(format));
}

FilmFormat film_format_named(const std::string& name)
{
    return static_cast<FilmFormat>(place_of(name, formats, "format of a film"));
}

}  // namespace voussoir::app::render
