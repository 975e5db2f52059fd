#include "importers/patterns/wall.h"

#include <algorithm>
#include <cmath>

#include "importers/patterns/parameter_checks.h"

namespace voussoir::importers::patterns
{
namespace
{

Facade facade_of(const Wall& wall)
{
    Facade facade{.name = wall.name,
                  .length = wall.length,
                  .lower = 0,
                  .upper = wall.thickness,
                  .leaves = wall.leaves,
                  .leaf_thickness = wall.leaf_thickness,
                  .header_every = wall.header_every,
                  .openings = {}};
    for (std::size_t i = 0; i < wall.openings.size(); ++i)
        facade.openings.push_back({wall.openings[i], "openings[" + std::to_string(i) + "]"});
    return facade;
}

void check_leaves(const Wall& wall, std::vector<Fault>& faults)
{
    if (wall.leaves < 1 || wall.leaves > 99)
        faults.push_back({"leaves", std::to_string(wall.leaves), "must be 1 to 99"});
    double sum = 0;
    for (const double leaf : wall.leaf_thickness) {
        check_positive("leaves", leaf, faults);
        sum += leaf;
    }
    if (!wall.leaf_thickness.empty() && std::abs(sum - wall.thickness) > 1e-9)
        faults.push_back({"leaves", std::to_string(sum) + " m in all",
                          "must add up to the thickness of the wall, " + std::to_string(wall.thickness) + " m"});
}

double thinnest_leaf(const Wall& wall)
{
    return wall.leaf_thickness.empty() ? wall.thickness / wall.leaves
                                       : *std::min_element(wall.leaf_thickness.begin(), wall.leaf_thickness.end());
}

void check(const Wall& wall, const Facade& facade)
{
    std::vector<Fault> faults;
    if (wall.name.empty()) faults.push_back({"name", "no name", "its blocks are named NAME_c01_b01"});
    check_positive("length", wall.length, faults);
    check_positive("height", wall.height, faults);
    check_positive("thickness", wall.thickness, faults);
    check_leaves(wall, faults);
    if (wall.header_every < 0 || (wall.header_every > 0 && wall.leaves == 1))
        faults.push_back(
            {"header_every", std::to_string(wall.header_every), "must be > 0, in a wall of several leaves"});
    check_lintel_size(wall.lintel, faults);
    check_base(wall.base, faults);
    check_placement(wall.placement, faults);
    if (!faults.empty()) throw InputError(faults);
    check_block({wall.block_length, wall.block_height}, wall.length, wall.height, wall.leaves, faults);
    check_imperfection(wall.imperfection, thinnest_leaf(wall), faults);
    if (wall.flat && wall.leaves > 1)
        faults.push_back({"leaves", std::to_string(wall.leaves), "a planar scene has one leaf"});
    if (!faults.empty()) throw InputError(faults);
    check_openings(facade, wall.height, wall.lintel, faults);
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace

std::vector<MasonryBlock> wall(const Wall& wall)
{
    const Facade facade = facade_of(wall);
    check(wall, facade);
    const BlockFormat block{wall.block_length, wall.block_height};
    const std::vector<double> beds = bed_levels(wall.height, block, wall.lintel, {facade});
    std::vector<Cell> cells;
    std::vector<Fault> faults;
    add_base(wall.name, wall.base, {wall.length, wall.thickness}, wall.flat, cells);
    lay(facade, beds, block, wall.lintel, cells, faults);
    if (faults.empty() && cells.size() <= (wall.base.height > 0 ? 1U : 0U))
        faults.push_back({"openings", "no wall remains", "leave some wall beside or above the openings"});
    if (!faults.empty()) throw InputError(faults);
    return blocks_in(cells, wall.imperfection, wall.flat, wall.placement);
}

}  // namespace voussoir::importers::patterns
