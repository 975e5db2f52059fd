#include "app/reader/findings.h"

#include <algorithm>

namespace voussoir::app::reader
{

std::vector<std::string> in_words(const std::vector<TakenDefault>& defaults)
{
    std::vector<std::string> paths, lines;
    for (const TakenDefault& taken : defaults) {
        const auto known = std::find(paths.begin(), paths.end(), taken.path);
        const std::string setting = taken.key + " = " + taken.value;
        if (known != paths.end()) {
            lines[known - paths.begin()] += ", " + setting;
        } else {
            paths.push_back(taken.path);
            lines.push_back(taken.path.empty() ? setting : taken.path + ": " + setting);
        }
    }
    return lines;
}

}  // namespace voussoir::app::reader
