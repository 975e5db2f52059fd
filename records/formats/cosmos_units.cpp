#include "records/formats/cosmos_units.h"

#include <array>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/words.h"

namespace voussoir::records::formats
{

namespace
{

struct Code {
    int code;
    const char* name;
    Quantity quantity;
    double factor;
};

constexpr std::array<Code, 10> codes{{
    {2, "g", Quantity::acceleration, standard_gravity},
    {4, "cm/s2", Quantity::acceleration, 0.01},
    {5, "cm/s", Quantity::velocity, 0.01},
    {6, "cm", Quantity::displacement, 0.01},
    {7, "in/s2", Quantity::acceleration, 0.0254},
    {8, "in/s", Quantity::velocity, 0.0254},
    {9, "in", Quantity::displacement, 0.0254},
    {10, "gal", Quantity::acceleration, 0.01},
    {11, "mg", Quantity::acceleration, 1e-3 * standard_gravity},
    {12, "micro g", Quantity::acceleration, 1e-6 * standard_gravity},
}};

}  // namespace

std::optional<Unit> find_cosmos_unit(int code)
{
    for (const Code& known : codes)
        if (known.code == code) return Unit{known.name, known.quantity, known.factor};
    return std::nullopt;
}

std::optional<double> cosmos_code_in(std::string_view line)
{
    const std::string lower = text::lower_case(line);
    const std::size_t units = lower.find("units=");
    if (units == std::string::npos) return std::nullopt;
    const std::string words = lower.substr(units, lower.find("format", units) - units);
    const std::size_t open = words.find('(');
    if (open == std::string::npos) return std::nullopt;
    double code = 0;
    const bool is_code =
        text::parse_fortran_number(words.substr(open + 1, words.find(')', open) - open - 1), code);
    return is_code ? std::optional<double>(code) : std::nullopt;
}

}  // namespace voussoir::records::formats
