#include "records/units.h"

#include <array>

#include "libdda/text/numbers.h"
#include "libdda/text/words.h"

namespace voussoir::records
{

namespace
{

struct KnownUnit {
    const char* name;
    Quantity quantity;
    double factor;
};

constexpr std::array<KnownUnit, 12> units{{
    {"g", Quantity::acceleration, standard_gravity},
    {"g/10", Quantity::acceleration, standard_gravity / 10},
    {"m/s2", Quantity::acceleration, 1},
    {"cm/s2", Quantity::acceleration, 0.01},
    {"mm/s2", Quantity::acceleration, 0.001},
    {"gal", Quantity::acceleration, 0.01},
    {"m/s", Quantity::velocity, 1},
    {"cm/s", Quantity::velocity, 0.01},
    {"mm/s", Quantity::velocity, 0.001},
    {"m", Quantity::displacement, 1},
    {"cm", Quantity::displacement, 0.01},
    {"mm", Quantity::displacement, 0.001},
}};

void replace_all(std::string& text, std::string_view from, std::string_view to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// "CM/SEC/SEC", "cm / s^2", "cm/s**2" and "gals" -> "cm/s2", "gal".
std::string normal_form(std::string_view text)
{
    std::string unit = text::lower_case(text::trim(text));
    for (const char* dropped : {" ", "\t", "**", "^"}) replace_all(unit, dropped, "");
    replace_all(unit, "sec", "s");
    replace_all(unit, "/s/s", "/s2");
    if (unit == "gals") unit = "gal";
    return unit;
}

}  // namespace

std::optional<Unit> find_unit(std::string_view text)
{
    const std::string wanted = normal_form(text);
    for (const KnownUnit& unit : units) {
        if (wanted == unit.name) return Unit{unit.name, unit.quantity, unit.factor};
    }
    return std::nullopt;
}

std::string known_units()
{
    std::string names;
    for (const KnownUnit& unit : units) names += (names.empty() ? "" : ", ") + std::string(unit.name);
    return names;
}

const char* to_text(Quantity quantity)
{
    switch (quantity) {
        case Quantity::acceleration:
            return "acceleration";
        case Quantity::velocity:
            return "velocity";
        case Quantity::displacement:
            return "displacement";
    }
    return "?";
}

}  // namespace voussoir::records
