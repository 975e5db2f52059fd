#include "libdda/text/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace voussoir::text
{

namespace
{

template <class Number>
std::errc parse(std::string_view word, Number& value)
{
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end != word.data() + word.size() ? std::errc::invalid_argument : error;
}

}  // namespace

std::optional<double> parse_number(std::string_view word)
{
    double value = 0;
    const std::errc error = parse(word, value);
    if (error == std::errc()) return value;
    const bool tiny = error == std::errc::result_out_of_range && word.find_first_of("eE") != word.npos &&
                      word.find('-', word.find_first_of("eE")) != word.npos;
    return tiny ? std::optional<double>(0.0) : std::nullopt;
}

std::optional<double> parse_finite(std::string_view word)
{
    const std::optional<double> value = parse_number(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<long long> parse_integer(std::string_view word)
{
    long long value = 0;
    return parse(word, value) == std::errc() ? std::optional<long long>(value) : std::nullopt;
}

std::string to_text(double value)
{
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return error == std::errc() ? std::string(buffer.data(), end) : std::string("?");
}

}  // namespace voussoir::text
