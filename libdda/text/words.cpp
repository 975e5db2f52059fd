#include "libdda/text/words.h"

#include <algorithm>

namespace voussoir::text
{

namespace
{

constexpr const char* white_space = " \t\r\n\v\f\x1A";

}  // namespace

std::string_view trim(std::string_view text)
{
    const auto first = text.find_first_not_of(white_space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(white_space) - first + 1);
}

std::string lower_case(std::string_view text)
{
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

bool equal_ignoring_case(std::string_view a, std::string_view b)
{
    return lower_case(a) == lower_case(b);
}

std::vector<std::string_view> words(std::string_view line)
{
    std::vector<std::string_view> found;
    for (line = trim(line); !line.empty(); line = trim(line)) {
        const std::size_t end = std::min(line.find_first_of(white_space), line.size());
        found.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return found;
}

}  // namespace voussoir::text
