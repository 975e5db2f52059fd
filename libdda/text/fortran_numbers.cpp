#include "libdda/text/fortran_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "libdda/text/words.h"

namespace voussoir::text
{

namespace
{

bool is_space(char c)
{
    return trim({&c, 1}).empty();
}
bool is_delimiter(char c)
{
    return c == ',' || c == ';';
}
bool is_sign(char c)
{
    return c == '+' || c == '-';
}

/// Fortran writes double precision as 1.5D-03; std::from_chars wants an E.
std::size_t parse_with_exponent_d(std::string_view text, std::size_t mantissa, double& value)
{
    const std::size_t exponent = mantissa + 1;
    const std::size_t digits = exponent + (exponent < text.size() && is_sign(text[exponent]) ? 1 : 0);
    const std::size_t end = std::min(text.find_first_not_of("0123456789", digits), text.size());
    if (end == digits) return 0;
    std::string with_e(text.substr(0, end));
    with_e[mantissa] = 'e';
    const auto [stop, error] = std::from_chars(with_e.data(), with_e.data() + with_e.size(), value);
    return error == std::errc() && stop == with_e.data() + with_e.size() ? end : 0;
}

/// Fortran leaves the letter out where the exponent has three digits: 1.234-105. Without a decimal point it would
/// rather be a number and the next one. @returns characters of the exponent; 0 when there is none
std::size_t parse_bare_exponent(std::string_view text, std::size_t mantissa, double& value)
{
    constexpr std::size_t length = 4;  // sign and digits
    const std::string_view exponent = text.substr(mantissa);
    if (exponent.size() < length || !is_sign(exponent[0])) return 0;
    if (text.substr(0, mantissa).find('.') == std::string_view::npos) return 0;
    const std::size_t end = std::min(exponent.find_first_not_of("0123456789", 1), exponent.size());
    if (end != length || (end < exponent.size() && exponent[end] == '.')) return 0;
    const std::string with_e =
        std::string(text.substr(0, mantissa)) + "e" + std::string(exponent.substr(0, length));
    const auto [stop, error] = std::from_chars(with_e.data(), with_e.data() + with_e.size(), value);
    return error == std::errc() && stop == with_e.data() + with_e.size() ? length : 0;
}

}  // namespace

std::size_t parse_leading_number(std::string_view text, double& value)
{
    const std::size_t skipped = text.size() > 1 && text[0] == '+' && !is_sign(text[1]) ? 1 : 0;
    const std::string_view digits = text.substr(skipped);
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument) return 0;
    auto used = static_cast<std::size_t>(stop - digits.data());
    if (error == std::errc::result_out_of_range) {
        // Below the smallest number is as good as zero; above the largest is as bad as infinity.
        const bool tiny = lower_case(digits.substr(0, used)).find("e-") != std::string::npos;
        value = tiny ? 0 : std::numeric_limits<double>::infinity();
    } else if (used < digits.size() && (digits[used] == 'D' || digits[used] == 'd')) {
        const std::size_t with_exponent = parse_with_exponent_d(digits, used, value);
        if (with_exponent > 0) used = with_exponent;
    } else if (used < digits.size() && digits.substr(0, used).find_first_of("eE") == std::string_view::npos) {
        used += parse_bare_exponent(digits, used, value);
    }
    return skipped + used;
}

bool parse_fortran_number(std::string_view text, double& value)
{
    text = trim(text);
    return !text.empty() && parse_leading_number(text, value) == text.size();
}

bool parse_separated(std::string_view line, std::vector<double>& values)
{
    values.clear();
    bool by_space = false;
    char delimiter = 0;
    std::string_view rest = trim(line);
    while (!rest.empty()) {
        double value = 0;
        const std::size_t used = parse_leading_number(rest, value);
        if (used == 0) return false;
        values.push_back(value);
        const std::string_view after = trim(rest.substr(used));
        if (after.empty()) return true;
        if (is_delimiter(after.front())) {
            if (by_space || (delimiter != 0 && delimiter != after.front())) return false;
            delimiter = after.front();
            rest = trim(after.substr(1));
            if (rest.empty()) return false;  // nothing after the last comma: a cell is missing
        } else {
            if (delimiter != 0 || !is_space(rest[used])) return false;
            by_space = true;
            rest = after;
        }
    }
    return !values.empty();
}

bool parse_fortran(std::string_view line, std::vector<double>& values)
{
    values.clear();
    std::string_view rest = trim(line);
    while (!rest.empty()) {
        double value = 0;
        const std::size_t used = parse_leading_number(rest, value);
        if (used == 0) return false;
        const std::string_view number = rest.substr(0, used);
        rest.remove_prefix(used);
        // Only a complete number, exponent included, may be touched by the sign of the next.
        const bool complete = number.find_first_of("eEdD+-", 1) != std::string_view::npos;
        if (!rest.empty() && !is_space(rest.front()) && !(complete && is_sign(rest.front()))) return false;
        values.push_back(value);
        rest = trim(rest);
    }
    return !values.empty();
}

}  // namespace voussoir::text
