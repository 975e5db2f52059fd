#include <fmt/core.h>

#include <Eigen/LU>
#include <cmath>

#include "app/reader/block_reading.h"
#include "importers/patterns/max_blocks.h"

namespace voussoir::app::reader
{
namespace
{

void add_stone(DrawnStone stone, const PlacedCopy& copy, const std::string& place, BlockReading& reading)
{
    const std::string name = stone.name + copy.suffix;
    for (ConvexPolyhedron& part : stone.parts) part = importers::helper::placed(std::move(part), copy, name);
    for (ConvexPolygon& outline : stone.outlines)
        outline = importers::helper::placed(std::move(outline), copy, name);
    std::vector<Block>& blocks = reading.model.blocks;
    const std::size_t before = blocks.size();
    if (stone.parts.empty())
        add_planar_block(name, place, std::move(stone.outlines), reading);
    else
        add_block(name, place, std::move(stone.parts), reading);
    if (blocks.size() == before) return;
    blocks.back().friction_factor = stone.friction_factor;
    const double scale = std::abs(copy.linear.determinant());  // a larger copy bears more of the same fill
    for (const DrawnMass& mass : stone.masses)
        attach_mass(reading.model, static_cast<int>(before), scale * mass.mass,
                    copy.linear * mass.at + copy.offset);
}

}  // namespace

void add_stones(std::vector<DrawnStone> drawn, const YamlCursor& shape, Belonging belonging, std::string naming,
                BlockReading& reading)
{
    using importers::patterns::max_blocks;
    std::vector<Block>& blocks = reading.model.blocks;
    const std::size_t first = blocks.size(), copies = belonging.copies.size(), count = drawn.size() * copies;
    if (first + count > max_blocks) {  // said before they are made: a stone takes kilobytes
        reading.is_full = true;
        return shape.fault(
            copies > 1
                ? fmt::format("{} copies of {} blocks: more than {} blocks", copies, drawn.size(), max_blocks)
                : fmt::format("more than {} blocks", max_blocks),
            copies > 1 ? "give fewer copies or larger blocks" : "give larger blocks or fewer walls");
    }
    const std::string place = shape.place();
    std::vector<std::string> own_groups;
    for (std::size_t c = 0; c < copies; ++c)
        for (const DrawnStone& stone : drawn) own_groups.push_back(stone.group);
    try {
        for (std::size_t c = 0; c < copies; ++c)
            for (DrawnStone& stone : drawn)
                add_stone(c + 1 < copies ? stone : std::move(stone), belonging.copies[c], place, reading);
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults) shape.fault(fault.place + ": " + fault.found, fault.expected);
    }
    reading.entries.push_back(
        {std::move(belonging), first, blocks.size(), std::move(naming), std::move(own_groups)});
}

}  // namespace voussoir::app::reader
