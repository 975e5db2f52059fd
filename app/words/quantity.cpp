#include "app/words/quantity.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/words/nearest_word.h"
#include "libdda/model/standard_gravity.h"
#include "libdda/text/words.h"

namespace voussoir::app::words
{
namespace
{

struct Unit {
    std::string_view name;
    double si;  // value of one of it in SI
    std::array<int, 4> exponents;
};

constexpr double degree = std::numbers::pi / 180;

constexpr Unit units[] = {
    {"m", 1, {1, 0, 0, 0}},       {"km", 1e3, {1, 0, 0, 0}},     {"dm", 1e-1, {1, 0, 0, 0}},
    {"cm", 1e-2, {1, 0, 0, 0}},   {"mm", 1e-3, {1, 0, 0, 0}},    {"um", 1e-6, {1, 0, 0, 0}},
    {"ft", 0.3048, {1, 0, 0, 0}}, {"in", 0.0254, {1, 0, 0, 0}},  {"kg", 1, {0, 1, 0, 0}},
    {"t", 1e3, {0, 1, 0, 0}},     {"s", 1, {0, 0, 1, 0}},        {"ms", 1e-3, {0, 0, 1, 0}},
    {"us", 1e-6, {0, 0, 1, 0}},   {"min", 60, {0, 0, 1, 0}},     {"h", 3600, {0, 0, 1, 0}},
    {"rad", 1, {0, 0, 0, 1}},     {"deg", degree, {0, 0, 0, 1}}, {"°", degree, {0, 0, 0, 1}},
    {"Hz", 1, {0, 0, -1, 0}},     {"kHz", 1e3, {0, 0, -1, 0}},   {"g", standard_gravity, {1, 0, -2, 0}},
    {"Gal", 1e-2, {1, 0, -2, 0}}, {"N", 1, {1, 1, -2, 0}},       {"kN", 1e3, {1, 1, -2, 0}},
    {"MN", 1e6, {1, 1, -2, 0}},   {"GN", 1e9, {1, 1, -2, 0}},    {"Pa", 1, {-1, 1, -2, 0}},
    {"hPa", 1e2, {-1, 1, -2, 0}}, {"kPa", 1e3, {-1, 1, -2, 0}},  {"MPa", 1e6, {-1, 1, -2, 0}},
    {"GPa", 1e9, {-1, 1, -2, 0}}, {"bar", 1e5, {-1, 1, -2, 0}},  {"%", 1e-2, {0, 0, 0, 0}},
    {"1", 1, {0, 0, 0, 0}},
};

const Unit* find_unit(std::string_view name)
{
    for (const Unit& unit : units)
        if (unit.name == name) return &unit;
    return nullptr;
}

std::string unknown_unit(std::string_view name)
{
    std::vector<std::string> names;
    for (const Unit& unit : units) names.emplace_back(unit.name);
    const std::string nearest = name.size() > 12 ? "" : nearest_word(name, names);
    return fmt::format("unknown unit \"{}\"{}", name.substr(0, 24),
                       nearest.empty() ? "" : ", did you mean " + nearest + "?");
}

/// Splits "m3", "s^2", "s^-2" or "m³" into a name and a power.
bool split_power(std::string_view factor, std::string_view& name, int& power)
{
    power = 1;
    name = factor;
    for (const auto& [sign, value] : {std::pair{std::string_view("²"), 2}, {std::string_view("³"), 3}})
        if (factor.ends_with(sign)) {
            power = value;
            name = factor.substr(0, factor.size() - sign.size());
            return !name.empty();
        }
    std::size_t digits = factor.size();
    while (digits > 0 && factor[digits - 1] >= '0' && factor[digits - 1] <= '9') --digits;
    if (digits == factor.size() || digits == 0) return !factor.empty();  // no power, or the factor 1
    std::size_t start = digits;
    if (start > 0 && factor[start - 1] == '-') --start;
    if (std::from_chars(factor.data() + start, factor.data() + factor.size(), power).ec != std::errc{})
        return false;
    if (std::abs(power) > 9) return false;
    if (start > 0 && factor[start - 1] == '^') --start;
    name = factor.substr(0, start);
    return !name.empty();
}

/// Multiplies `quantity` by one factor such as "kN" or, dividing, "m3".
void apply_factor(std::string_view factor, bool divide, ParsedQuantity& quantity)
{
    std::string_view name;
    int power = 1;
    const Unit* unit = split_power(factor, name, power) ? find_unit(name) : nullptr;
    if (unit == nullptr) {
        quantity.problem = unknown_unit(factor);
        return;
    }
    if (divide) power = -power;
    // Divided rather than multiplied by the inverse: 2 / 1000 is 0.002 to the last bit.
    for (int i = 0; i < power; ++i) quantity.value *= unit->si;
    for (int i = 0; i > power; --i) quantity.value /= unit->si;
    for (int i = 0; i < 4; ++i) quantity.exponents[i] += power * unit->exponents[i];
}

void apply_unit(std::string_view unit, ParsedQuantity& quantity)
{
    bool divide = false;
    if (unit.front() == '/') {
        divide = true;
        unit.remove_prefix(1);
    }
    while (quantity.problem.empty()) {
        const std::size_t end = unit.find_first_of("*/");
        apply_factor(unit.substr(0, end), divide, quantity);
        if (end == std::string_view::npos) break;
        divide = unit[end] == '/';
        unit.remove_prefix(end + 1);
    }
}

}  // namespace

ParsedQuantity parse_quantity(std::string_view text)
{
    ParsedQuantity quantity;
    text = text::trim(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), quantity.value);
    const bool yaml_not_finite = text.starts_with(".inf") || text.starts_with("-.inf") || text.starts_with(".nan");
    if (yaml_not_finite || error == std::errc::result_out_of_range ||
        (error == std::errc{} && !std::isfinite(quantity.value))) {
        quantity.problem = "not a finite number";
        return quantity;
    }
    if (error != std::errc{}) {
        quantity.problem = "not a number";
        return quantity;
    }
    text.remove_prefix(end - text.data());
    text = text::trim(text);
    quantity.bare = text.empty();
    if (!quantity.bare) apply_unit(text, quantity);
    if (quantity.problem.empty() && !std::isfinite(quantity.value)) quantity.problem = "not a finite number";
    return quantity;
}

std::string in_words(double value, const Dimension& dimension)
{
    std::string text = fmt::format("{:g}", value);
    if (!dimension.si_unit.empty()) text += fmt::format(" {}", dimension.si_unit);
    if (dimension.exponents == dimension::angle.exponents) text += fmt::format(" ({:g} deg)", value / degree);
    return text;
}

bool lacks_unit(const ParsedQuantity& quantity, const Dimension& dimension)
{
    return quantity.bare && quantity.value != 0 && dimension.needs_unit();
}

std::string with_units(std::string_view number, const Dimension& dimension)
{
    return fmt::format("write {0} {1} or {0} {2}", text::trim(number), dimension.rivals[0], dimension.rivals[1]);
}

std::string in_words(const Range& range, const Dimension& dimension)
{
    const auto bound = [&](double value) { return value == 0 ? std::string("0") : in_words(value, dimension); };
    std::string text;
    if (std::isfinite(range.lower)) text += (range.includes_lower ? ">= " : "> ") + bound(range.lower);
    if (std::isfinite(range.upper))
        text +=
            (text.empty() ? "" : " and ") + std::string(range.includes_upper ? "<= " : "< ") + bound(range.upper);
    return "must be " + (text.empty() ? "finite" : text);
}

}  // namespace voussoir::app::words
