#include "importers/helper/choose_stones.h"

#include <algorithm>

namespace voussoir::importers::helper
{

StoneChooser::StoneChooser(const MeshRequest& request)
    : has_only_(!request.choice.only.empty()),
      simplifies_(request.simplify.is_asked()),
      simplifies_all_(request.simplify.stones.empty())
{
    const auto take = [&](const char* key, const std::vector<std::string>& patterns) {
        for (const std::string& pattern : patterns) patterns_.push_back({key, pattern});
    };
    take("skip", request.choice.skip);
    take("only", request.choice.only);
    take("hull", request.choice.hull);
    take("skip_types", request.choice.skip_types);
    take("simplify.stones", request.simplify.stones);
}

bool StoneChooser::matches(const std::string& key, const std::string& name, const std::string& surface)
{
    bool any = false;
    for (Pattern& pattern : patterns_) {
        if (pattern.key != key) continue;
        // Items of a building model are named by their type, an underscore, and their own name.
        const std::string wanted = key == "skip_types" ? pattern.pattern + "_*" : pattern.pattern;
        const bool found = matches_pattern(name, wanted) || matches_pattern(surface, wanted);
        pattern.used = pattern.used || found;
        any = any || found;
    }
    return any;
}

std::string StoneChooser::left_out(const std::string& surface)
{
    if (matches("skip_types", surface, surface)) return "skip_types";
    return matches("skip", surface, surface) ? "skip" : "";
}

std::string StoneChooser::left_out(const std::string& name, const std::string& surface)
{
    if (matches("skip_types", name, surface)) return "skip_types";
    if (matches("skip", name, surface)) return "skip";
    return has_only_ && !matches("only", name, surface) ? "only" : "";
}

bool StoneChooser::wants_hull(const std::string& name, const std::string& surface)
{
    return matches("hull", name, surface);
}

bool StoneChooser::wants_simplification(const std::string& name, const std::string& surface)
{
    return simplifies_ && (simplifies_all_ || matches("simplify.stones", name, surface));
}

std::vector<UnmatchedPattern> StoneChooser::unmatched() const
{
    std::vector<UnmatchedPattern> all;
    for (const Pattern& pattern : patterns_)
        if (!pattern.used) all.push_back({pattern.key, pattern.pattern});
    return all;
}

}  // namespace voussoir::importers::helper
