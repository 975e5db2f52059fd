// The heights of courses.
#include <algorithm>
#include <sstream>

#include "importers/patterns/facade.h"
#include "importers/patterns/openings.h"

namespace voussoir::importers::patterns
{
namespace
{

/// A height at which a bed joint must lie.
struct Level {
    double z;  // m
    std::string what, key;
};

std::vector<Level> levels_of(double height, const Lintel& lintel, const std::vector<Facade>& facades)
{
    std::vector<Level> levels = {{height, "the top", "height"}};
    for (const Facade& facade : facades)
        for (const NamedOpening& named : facade.openings) {
            const Patch hole = patch_of(named.opening);
            levels.push_back({hole.foot, "the sill of " + named.key, named.key});
            levels.push_back({hole.top, "the head of " + named.key, named.key});
            if (needs_lintel(named.opening, height))
                levels.push_back({patch_of(named.opening, lintel).top, "the lintel over " + named.key, named.key});
        }
    std::stable_sort(levels.begin(), levels.end(), [](const Level& a, const Level& b) { return a.z < b.z; });
    return levels;
}

[[noreturn]] void refuse(const Level& lower, const Level& upper, double course)
{
    std::ostringstream found, expected;
    found << lower.what << " and " << upper.what << " lie " << upper.z - lower.z << " m apart in height";
    expected << "give them the same level, or separate them by at least a third of a course, "
             << course * smallest_piece << " m, apart";
    throw InputError(upper.key == "height" ? lower.key : upper.key, found.str(), expected.str());
}

/// Adds the beds above `foot` up to and including `top`.
void fill(double foot, double top, double course, std::vector<double>& beds)
{
    const int whole = static_cast<int>(std::floor((top - foot) / course + same_place));
    const double rest = top - foot - whole * course;
    const bool cut = whole == 0 || rest >= (smallest_piece - same_place) * course;
    for (int i = 1; i <= whole; ++i)
        if (i < whole || cut) beds.push_back(foot + i * course);
    beds.push_back(top);
}

}  // namespace

std::vector<double> bed_levels(double height, const BlockFormat& block, const Lintel& lintel,
                               const std::vector<Facade>& facades)
{
    std::vector<double> beds = {0};
    Level last{0, "the foot", "height"};
    for (Level& level : levels_of(height, lintel, facades)) {
        if (level.z - last.z <= same_place * block.height) continue;
        if (level.z - last.z < (smallest_piece - same_place) * block.height) refuse(last, level, block.height);
        fill(last.z, level.z, block.height, beds);
        last = std::move(level);
    }
    return beds;
}

}  // namespace voussoir::importers::patterns
