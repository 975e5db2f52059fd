#include "importers/patterns/openings.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

#include "importers/patterns/facade.h"

namespace voussoir::importers::patterns
{
namespace
{

std::string metres(double value)
{
    std::ostringstream text;
    text << value << " m";
    return text.str();
}

bool positive(double value)
{
    return std::isfinite(value) && value > 0;
}

/// A patch and how to name it: "the lintel over openings[2]".
struct NamedPatch {
    Patch patch;
    std::string name, key;
};

bool overlap(const Patch& a, const Patch& b)
{
    const double margin = 1e-9 * (a.right - a.left + a.top - a.foot);
    return a.left < b.right - margin && b.left < a.right - margin && a.foot < b.top - margin &&
           b.foot < a.top - margin;
}

/// Each patch that overlaps earlier ones, after one of them: (earlier, later), in the order of the later. Patches
/// are met from left to right; one that overlaps does not stay for the next to be compared with, so that equal
/// ones, however many, are compared with the first alone.
std::vector<std::pair<std::size_t, std::size_t>> overlaps_of(const std::vector<NamedPatch>& patches)
{
    std::vector<std::size_t> by_left(patches.size());
    std::iota(by_left.begin(), by_left.end(), 0);
    std::stable_sort(by_left.begin(), by_left.end(),
                     [&](std::size_t a, std::size_t b) { return patches[a].patch.left < patches[b].patch.left; });
    std::vector<std::pair<std::size_t, std::size_t>> found;
    std::vector<std::size_t> open;  // those that reach to where the next one begins
    for (const std::size_t next : by_left) {
        std::erase_if(open, [&](std::size_t k) { return patches[k].patch.right <= patches[next].patch.left; });
        const auto other = std::find_if(open.begin(), open.end(), [&](std::size_t k) {
            return overlap(patches[k].patch, patches[next].patch);
        });
        if (other == open.end())
            open.push_back(next);
        else
            found.push_back(std::minmax(*other, next));
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return std::pair(a.second, a.first) < std::pair(b.second, b.first);
    });
    return found;
}

bool check_place(const NamedOpening& named, const Facade& facade, double height, std::vector<Fault>& faults)
{
    const Opening& opening = named.opening;
    const Patch hole = patch_of(opening);
    const std::size_t before = faults.size();
    if (!positive(opening.width) || !positive(opening.height))
        faults.push_back({named.key, metres(opening.width) + " by " + metres(opening.height),
                          "an opening has a width and a height > 0 m"});
    if (!(hole.left >= facade.corner && hole.right <= (facade.length - facade.corner) * (1 + 1e-9)))
        faults.push_back(
            {named.key, "from " + metres(hole.left) + " to " + metres(hole.right) + " along " + facade.name,
             "it must lie between " + metres(facade.corner) + " and " + metres(facade.length - facade.corner)});
    if (!(hole.foot >= 0 && hole.top <= height * (1 + 1e-9)))
        faults.push_back({named.key, "from " + metres(hole.foot) + " to " + metres(hole.top) + " above the foot",
                          "it must lie between 0 m and " + metres(height)});
    return faults.size() == before;
}

void check_lintel(const NamedPatch& lintel, const Facade& facade, double height, std::vector<Fault>& faults)
{
    const Patch& patch = lintel.patch;
    const double margin = 1e-9 * facade.length;
    if (patch.left < facade.corner - margin || patch.right > facade.length - facade.corner + margin)
        faults.push_back({lintel.key,
                          "its lintel would reach from " + metres(patch.left) + " to " + metres(patch.right) +
                              " along " + facade.name,
                          "both bearings must lie between " + metres(facade.corner) + " and " +
                              metres(facade.length - facade.corner)});
    if (patch.top > height * (1 + 1e-9))
        faults.push_back({lintel.key, "its lintel would reach up to " + metres(patch.top),
                          "it must end at the top, " + metres(height) + ", or below"});
}

}  // namespace

void check_openings(const Facade& facade, double height, const Lintel& lintel, std::vector<Fault>& faults)
{
    std::vector<NamedPatch> patches;
    for (const NamedOpening& named : facade.openings) {
        if (!check_place(named, facade, height, faults)) continue;
        patches.push_back({patch_of(named.opening), named.key, named.key});
        if (!needs_lintel(named.opening, height)) continue;
        patches.push_back({patch_of(named.opening, lintel), "the lintel over " + named.key, named.key});
        check_lintel(patches.back(), facade, height, faults);
    }
    for (const auto& [a, b] : overlaps_of(patches))
        faults.push_back({patches[b].key, patches[a].name + " and " + patches[b].name + " overlap",
                          "leave some wall between them"});
}

}  // namespace voussoir::importers::patterns
