#include "importers/helper/stone_choice.h"

namespace voussoir::importers::helper
{

const std::vector<std::string> repair_rule_names{"refuse", "hull", "skip"};

bool matches_pattern(std::string_view name, std::string_view pattern)
{
    // The last * is remembered and takes one letter more whenever the rest does not fit: no exponential search.
    std::size_t n = 0, p = 0, star = std::string_view::npos, resume = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++n;
            ++p;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

}  // namespace voussoir::importers::helper
