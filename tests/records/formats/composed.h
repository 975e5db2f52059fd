// Texts in the formats of the networks, composed for the tests.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace voussoir::records
{

/// The numbers in Fortran's way: `per_line` on a line, each by the printf format.
inline std::string in_lines(const std::vector<double>& numbers, std::size_t per_line, const char* format)
{
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        char buffer[64];
        std::snprintf(buffer, sizeof buffer, format, numbers[i]);
        text += buffer;
        if ((i + 1) % per_line == 0 || i + 1 == numbers.size()) text += "\n";
    }
    return text;
}

/// A copy of the text with the first `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    return at == std::string::npos ? "\"" + from + "\" is not in the text" : text.replace(at, from.size(), to);
}

}  // namespace voussoir::records
