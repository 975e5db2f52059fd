#include "app/reader/findings.h"

#include <string_view>
#include <unordered_map>

namespace voussoir::app::reader
{

std::vector<std::string> in_words(const std::vector<TakenDefault>& defaults)
{
    std::vector<std::string> lines;
    std::unordered_map<std::string_view, std::size_t> line_of_path;
    for (const TakenDefault& taken : defaults) {
        const auto [known, is_new] = line_of_path.emplace(taken.path, lines.size());
        const std::string setting = taken.key + " = " + taken.value;
        if (is_new)
            lines.push_back(taken.path.empty() ? setting : taken.path + ": " + setting);
        else
            lines[known->second] += ", " + setting;
    }
    return lines;
}

}  // namespace voussoir::app::reader
