#include "importers/patterns/cells.h"

#include <algorithm>
#include <cmath>

#include "importers/patterns/even_numbers.h"

namespace voussoir::importers::patterns
{
namespace
{

/// The five numbers of one block.
struct Draw {
    double length, thickness, place_along, place_across, friction;
};

Draw draw(EvenNumbers& generator)
{
    Draw numbers{};
    numbers.length = generator.share();
    numbers.thickness = generator.share();
    numbers.place_along = generator.deviation();
    numbers.place_across = generator.deviation();
    numbers.friction = generator.deviation();
    return numbers;
}

/// Makes the extent of a block along one axis smaller by `share` and moves it by at most `shift`, not beyond a
/// side that is held. Sides that do not move keep their coordinates bit for bit.
void disturb(double& lower, double& upper, double share, double shift, bool held_below, bool held_above)
{
    const double margin = share * (upper - lower) / 2;
    if (held_below) shift = std::max(shift, -margin);
    if (held_above) shift = std::min(shift, margin);
    const double new_lower = lower + (margin + shift), new_upper = upper - (margin - shift);
    lower = held_below ? std::max(lower, new_lower) : new_lower;
    upper = held_above ? std::min(upper, new_upper) : new_upper;
}

void disturb(Cell& cell, const Imperfection& amount, const Draw& numbers, bool flat)
{
    const int along = cell.along, across = 1 - along;
    disturb(cell.lower[along], cell.upper[along], amount.size * numbers.length, amount.joint * numbers.place_along,
            true, true);
    if (flat) return;
    disturb(cell.lower[across], cell.upper[across], amount.size * numbers.thickness,
            amount.joint * numbers.place_across, cell.held_below, cell.held_above);
}

/// Cosine and sine, exact for quarter turns: walls along y then have coordinates as exact as walls along x.
Eigen::Vector2d exact_direction(double angle)
{
    const auto cleaned = [](double x) { return std::abs(x) < 1e-15 ? 0 : x; };
    return {cleaned(std::cos(angle)), cleaned(std::sin(angle))};
}

}  // namespace

std::vector<MasonryBlock> blocks_in(const std::vector<Cell>& cells, const Imperfection& imperfection, bool flat,
                                    const Placement& placement)
{
    EvenNumbers generator(imperfection.seed);
    const Eigen::Vector2d x_axis = exact_direction(placement.direction);
    std::vector<MasonryBlock> blocks;
    blocks.reserve(cells.size());
    for (Cell cell : cells) {
        const Draw numbers = draw(generator);
        if (cell.kind == Cell::Kind::stone) disturb(cell, imperfection, numbers, flat);
        MasonryBlock block{std::move(cell.name), {}, 1};
        if (cell.kind != Cell::Kind::base) block.friction_factor += imperfection.friction * numbers.friction;
        for (int i = 0; i < 8; ++i) {
            const double x = i & 1 ? cell.upper.x() : cell.lower.x(), y = i & 2 ? cell.upper.y() : cell.lower.y();
            const Eigen::Vector3d turned(x_axis.x() * x - x_axis.y() * y, x_axis.y() * x + x_axis.x() * y,
                                         i & 4 ? cell.upper.z() : cell.lower.z());
            block.corners[i] = placement.origin + turned;
        }
        blocks.push_back(std::move(block));
    }
    return blocks;
}

void add_base(const std::string& name, const MasonryBase& base, const Eigen::Vector2d& size, bool flat,
              std::vector<Cell>& cells)
{
    if (base.height == 0) return;
    const double x = base.projection, y = flat ? 0 : base.projection;
    Cell slab{name + "_base", {-x, -y, -base.height}, {size.x() + x, size.y() + y, 0}, 0, Cell::Kind::base};
    cells.insert(cells.begin(), std::move(slab));
}

}  // namespace voussoir::importers::patterns
