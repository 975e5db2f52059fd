// Physical quantities as people write them: "4.5 GPa", "30 deg", "0.3 g", "24 kN/m3". Bare numbers are SI where
// nobody would take them for anything else.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>

namespace voussoir::app::words
{

/// Exponents of metre, kilogram, second and radian, with a name and an example for messages.
struct Dimension {
    std::array<int, 4> exponents{};
    std::string_view name;     // "a pressure"
    std::string_view si_unit;  // "Pa"
    std::string_view example;  // "4.5 GPa"
    /// Units that people write of it in turn, SI among them: a number without unit is then none, but for 0. Empty
    /// where a bare number can only be SI.
    std::array<std::string_view, 2> rivals{};

    bool needs_unit() const { return !rivals[0].empty(); }
};

namespace dimension
{
inline constexpr Dimension number{{0, 0, 0, 0}, "a number without unit", "", "0.25"};
inline constexpr Dimension length{{1, 0, 0, 0}, "a length", "m", "1.5 m"};
inline constexpr Dimension area{{2, 0, 0, 0}, "an area", "m2", "5 cm2"};
inline constexpr Dimension time{{0, 0, 1, 0}, "a time", "s", "2 ms"};
inline constexpr Dimension angle{{0, 0, 0, 1}, "an angle", "rad", "30 deg", {"deg", "rad"}};
inline constexpr Dimension frequency{{0, 0, -1, 0}, "a frequency", "Hz", "2.5 Hz"};
inline constexpr Dimension rate{{0, 0, -1, 0}, "a rate", "1/s", "0.5 1/s"};
inline constexpr Dimension spin{{0, 0, -1, 1}, "an angular velocity", "rad/s", "2 rad/s", {"rad/s", "deg/s"}};
inline constexpr Dimension velocity{{1, 0, -1, 0}, "a velocity", "m/s", "0.2 m/s"};
inline constexpr Dimension peak_velocity{{1, 0, -1, 0}, "a velocity", "m/s", "20 cm/s", {"cm/s", "m/s"}};
inline constexpr Dimension acceleration{{1, 0, -2, 0}, "an acceleration", "m/s2", "0.3 g", {"g", "m/s2"}};
inline constexpr Dimension mass{{0, 1, 0, 0}, "a mass", "kg", "500 kg"};
inline constexpr Dimension density{{-3, 1, 0, 0}, "a density", "kg/m3", "2400 kg/m3", {"kg/m3", "kN/m3"}};
inline constexpr Dimension unit_weight{{-2, 1, -2, 0}, "a weight per volume", "N/m3", "24 kN/m3"};
inline constexpr Dimension pressure{{-1, 1, -2, 0}, "a pressure", "Pa", "4.5 GPa", {"MPa", "Pa"}};
inline constexpr Dimension stiffness_per_point{
    {0, 1, -2, 0}, "a stiffness per contact point", "N/m", "1e8 N/m", {"kN/m", "N/m"}};
inline constexpr Dimension stiffness_per_area{{-2, 1, -2, 0}, "a stiffness per area", "Pa/m", "50 MPa/m"};
}  // namespace dimension

/// A text read as a quantity.
struct ParsedQuantity {
    double value = std::numeric_limits<double>::quiet_NaN();  // SI
    std::array<int, 4> exponents{};
    bool bare = false;    // no unit was written
    std::string problem;  // why it could not be read; empty if it could

    bool has(const Dimension& dimension) const { return exponents == dimension.exponents; }
};

/// Reads a finite number and, after it, a unit: names with powers, multiplied and divided ("kN/m3", "m/s^2").
/// g is the standard gravity 9.80665 m/s2; masses are kg and t.
ParsedQuantity parse_quantity(std::string_view text);

/// Allowed values of a quantity, SI.
struct Range {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool includes_lower = true, includes_upper = true;

    static Range any() { return {}; }
    static Range positive() { return {0, std::numeric_limits<double>::infinity(), false, true}; }
    static Range non_negative() { return {0, std::numeric_limits<double>::infinity(), true, true}; }
    bool contains(double value) const
    {
        return (includes_lower ? value >= lower : value > lower) &&
               (includes_upper ? value <= upper : value < upper);
    }
};

/// "must be > 0", "must be >= 0 and < 1.5708 rad (90 deg)".
std::string in_words(const Range& range, const Dimension& dimension);

/// "0.002 s", "1.5708 rad (90 deg)".
std::string in_words(double value, const Dimension& dimension);

/// Is it a number without a unit that could be one thing or another?
bool lacks_unit(const ParsedQuantity& quantity, const Dimension& dimension);

/// "write 0.35 g or 0.35 m/s2". @param number as it was written, without a unit
std::string with_units(std::string_view number, const Dimension& dimension);

}  // namespace voussoir::app::words
