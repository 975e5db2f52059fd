#include "importers/patterns/house.h"

#include <algorithm>
#include <sstream>

#include "importers/patterns/parameter_checks.h"

namespace voussoir::importers::patterns
{
namespace
{

/// The wall of one side, in the house's own axes.
Facade facade_of(const House& house, Side side)
{
    const bool along_y = side == Side::east || side == Side::west;
    const bool far = side == Side::east || side == Side::north;  // from the origin
    const double depth = along_y ? house.length : house.width;
    Facade facade{.name = house.name + "_" + side_names[static_cast<int>(side)],
                  .length = along_y ? house.width : house.length,
                  .lower = far ? depth - house.wall_thickness : 0,
                  .upper = far ? depth : house.wall_thickness,
                  .along = along_y ? 1 : 0,
                  .corner = house.wall_thickness,
                  .runs_through = along_y ? 1 : 0,
                  .inside_above = !far,
                  .openings = {}};
    for (std::size_t i = 0; i < house.openings.size(); ++i)
        if (house.openings[i].side == side)
            facade.openings.push_back({house.openings[i].opening, "openings[" + std::to_string(i) + "]"});
    return facade;
}

/// Between two opposite walls at least one block must find room.
void check_room(const char* name, double value, const House& house, std::vector<Fault>& faults)
{
    const double least = 2 * house.wall_thickness + house.block_length;
    if (value >= least) return;
    std::ostringstream found, expected;
    found << value << " m";
    expected << "must be at least two wall thicknesses and a block, " << least << " m";
    faults.push_back({name, found.str(), expected.str()});
}

void check(const House& house, const std::vector<Facade>& facades)
{
    std::vector<Fault> faults;
    if (house.name.empty()) faults.push_back({"name", "no name", "its blocks are named NAME_south_c01_b01"});
    check_positive("length", house.length, faults);
    check_positive("width", house.width, faults);
    check_positive("height", house.height, faults);
    check_positive("wall_thickness", house.wall_thickness, faults);
    check_lintel_size(house.lintel, faults);
    check_base(house.base, faults);
    check_placement(house.placement, faults);
    if (!faults.empty()) throw InputError(faults);
    const double longest = std::max(house.length, house.width);
    check_block({house.block_length, house.block_height}, longest, house.height,
                2 * (house.length + house.width) / longest, faults);
    check_imperfection(house.imperfection, house.wall_thickness, faults);
    if (!faults.empty()) throw InputError(faults);
    check_room("length", house.length, house, faults);
    check_room("width", house.width, house, faults);
    for (const Facade& facade : facades) check_openings(facade, house.height, house.lintel, faults);
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace

std::vector<MasonryBlock> house(const House& house)
{
    std::vector<Facade> facades;
    for (const Side side : {Side::south, Side::north, Side::east, Side::west})
        facades.push_back(facade_of(house, side));
    check(house, facades);
    const BlockFormat block{house.block_length, house.block_height};
    const std::vector<double> beds = bed_levels(house.height, block, house.lintel, facades);
    std::vector<Cell> cells;
    std::vector<Fault> faults;
    add_base(house.name, house.base, {house.length, house.width}, false, cells);
    for (const Facade& facade : facades) lay(facade, beds, block, house.lintel, cells, faults);
    if (faults.empty() && cells.size() <= (house.base.height > 0 ? 1U : 0U))
        faults.push_back({"openings", "no wall remains", "leave some wall beside or above the openings"});
    if (!faults.empty()) throw InputError(faults);
    return blocks_in(cells, house.imperfection, false, house.placement);
}

}  // namespace voussoir::importers::patterns
