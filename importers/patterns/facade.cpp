#include "importers/patterns/facade.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>

#include "importers/patterns/max_blocks.h"
#include "importers/patterns/openings.h"

namespace voussoir::importers::patterns
{
namespace
{

/// A stretch of wall in one course, from joint to joint [m].
struct Stretch {
    double begin, end;
};

/// What laying a wall needs at every course.
struct Laying {
    const Facade& facade;
    const std::vector<double>& beds;
    const BlockFormat& block;
    const Lintel& lintel;
    std::vector<Cell>& cells;
    std::vector<Fault>& faults;

    int courses() const { return static_cast<int>(beds.size()) - 1; }
    double middle(int course) const { return (beds[course] + beds[course + 1]) / 2; }
    double height() const { return beds.back(); }
    bool runs_through(int course) const { return facade.corner == 0 || course % 2 == facade.runs_through; }
};

std::string padded(int number, int largest)
{
    const std::string digits = std::to_string(number);
    const std::size_t width = std::max<std::size_t>(2, std::to_string(largest).size());
    return std::string(width - std::min(width, digits.size()), '0') + digits;
}

/// The holes a course has: openings, and lintels, which are blocks of their own.
std::vector<Patch> holes_in(const Laying& laying, int course)
{
    std::vector<Patch> holes;
    for (const NamedOpening& named : laying.facade.openings) {
        const Patch hole = patch_of(named.opening), lintel = patch_of(named.opening, laying.lintel);
        if (hole.has_height(laying.middle(course))) holes.push_back(hole);
        if (needs_lintel(named.opening, laying.height()) && lintel.has_height(laying.middle(course)))
            holes.push_back(lintel);
    }
    std::sort(holes.begin(), holes.end(), [](const Patch& a, const Patch& b) { return a.left < b.left; });
    return holes;
}

std::vector<Stretch> stretches_in(const Laying& laying, int course)
{
    const Facade& facade = laying.facade;
    const double set_back = laying.runs_through(course) ? 0 : facade.corner;
    const double length = laying.block.length;
    std::vector<Stretch> stretches;
    double begin = set_back;
    const auto add = [&](double end) {
        if (end - begin > same_place * length) stretches.push_back({begin, end});
    };
    for (const Patch& hole : holes_in(laying, course)) {
        add(hole.left);
        begin = hole.right;
    }
    add(facade.length - set_back);
    return stretches;
}

/// Vertical joints of a course that its bond cannot move: at corners and at the ends of lintels.
std::vector<double> fixed_joints(const Laying& laying, int course)
{
    std::vector<double> joints;
    if (course < 0 || course >= laying.courses()) return joints;
    if (!laying.runs_through(course)) joints = {laying.facade.corner, laying.facade.length - laying.facade.corner};
    for (const NamedOpening& named : laying.facade.openings) {
        const Patch lintel = patch_of(named.opening, laying.lintel);
        if (!needs_lintel(named.opening, laying.height()) || !lintel.has_height(laying.middle(course))) continue;
        joints.insert(joints.end(), {lintel.left, lintel.right});
    }
    return joints;
}

/// The place nearest to `wanted` that is a quarter block away from the joints to avoid and inside `room`, if there
/// is one at most a quarter block away.
std::optional<double> place_joint(double wanted, const Stretch& room, double length,
                                  const std::vector<double>& avoid)
{
    const double quarter = length / 4, margin = same_place * length;
    const auto good = [&](double x) {
        return x >= room.begin - margin && x <= room.end + margin &&
               std::none_of(avoid.begin(), avoid.end(),
                            [&](double other) { return std::abs(x - other) < quarter - margin; });
    };
    if (good(wanted)) return wanted;
    std::optional<double> best;
    double best_shift = quarter + margin;
    for (const double other : avoid)
        for (const double x : {other - quarter, other + quarter}) {
            if (std::abs(x - wanted) >= best_shift || !good(x)) continue;
            best = x;
            best_shift = std::abs(x - wanted);
        }
    return best;
}

/// All joints of a stretch, its ends included. @param origin one of the places a whole number of lengths apart
std::vector<double> joints_of(const Stretch& stretch, double origin, double length,
                              const std::vector<double>& avoid)
{
    const double piece = (smallest_piece - same_place) * length, longest = (1.5 + same_place) * length;
    std::vector<double> joints = {stretch.begin};
    for (double number = std::ceil((stretch.begin + piece - origin) / length);; ++number) {
        const double wanted = origin + number * length;
        if (wanted > stretch.end - piece) break;
        const std::optional<double> bonded =
            place_joint(wanted, {joints.back() + piece, stretch.end - piece}, length, avoid);
        // Near an end a joint without bond is better left out; elsewhere there must be one.
        const double next = wanted + length > stretch.end - piece ? stretch.end : wanted + length;
        if (!bonded && next - joints.back() <= longest) continue;
        const double joint = bonded.value_or(wanted);
        if (joint - joints.back() >= piece) joints.push_back(joint);
    }
    joints.push_back(stretch.end);
    return joints;
}

void refuse_sliver(const Laying& laying, const Stretch& stretch)
{
    std::ostringstream found, expected;
    found << "only " << stretch.end - stretch.begin << " m of " << laying.facade.name << " between "
          << stretch.begin << " m and " << stretch.end << " m";
    expected << "leave no wall, or at least a third of a block, " << laying.block.length * smallest_piece << " m";
    const Fault fault{"openings", found.str(), expected.str()};
    const bool known = std::any_of(laying.faults.begin(), laying.faults.end(),
                                   [&](const Fault& other) { return other.found == fault.found; });
    if (!known) laying.faults.push_back(fault);
}

/// One leaf of one course.
struct Row {
    int course, parity;   // parity 1: the joints lie half a block off
    std::string name;     // of the blocks, without their number
    double lower, upper;  // m, faces
    bool held_below, held_above;
};

/// The leaves of a course from the lower face to the upper one.
std::vector<Row> rows_of(const Laying& laying, int course)
{
    const Facade& facade = laying.facade;
    const std::string name = facade.name + "_c" + padded(course + 1, laying.courses());
    const int parity = facade.corner == 0 ? course % 2 : static_cast<int>(laying.runs_through(course));
    const bool header = facade.header_every > 0 && (course + 1) % facade.header_every == 0;
    const int leaves = header ? 1 : facade.leaves;
    const auto face = [&](int i) {
        if (i == leaves) return facade.upper;
        if (facade.leaf_thickness.empty()) return facade.lower + (facade.upper - facade.lower) * i / leaves;
        return std::accumulate(facade.leaf_thickness.begin(), facade.leaf_thickness.begin() + i, facade.lower);
    };
    std::vector<Row> rows;
    rows.reserve(leaves);
    for (int leaf = 0; leaf < leaves; ++leaf)
        rows.push_back({course, (parity + leaf) % 2,
                        leaves == 1 ? name : name + "_l" + padded(leaf + 1, leaves).substr(leaves < 10 ? 1 : 0),
                        face(leaf), face(leaf + 1), leaf > 0, leaf + 1 < leaves});
    return rows;
}

/// Does another wall stand across the stretch?
bool at_corner(const Facade& facade, const Stretch& piece)
{
    return facade.corner > 0 && (piece.begin < facade.corner || piece.end > facade.length - facade.corner);
}

Cell cell_of(const Laying& laying, const Row& row, const Stretch& piece, int number)
{
    const Facade& facade = laying.facade;
    const int largest = static_cast<int>(facade.length / laying.block.length) + 1;
    Cell cell{row.name + "_b" + padded(number, largest), {}, {}, facade.along, Cell::Kind::stone};
    cell.lower[facade.along] = piece.begin;
    cell.upper[facade.along] = piece.end;
    cell.lower[1 - facade.along] = row.lower;
    cell.upper[1 - facade.along] = row.upper;
    cell.lower.z() = laying.beds[row.course];
    cell.upper.z() = laying.beds[row.course + 1];
    const bool corner = at_corner(facade, piece);
    cell.held_below = row.held_below || (corner && !facade.inside_above);
    cell.held_above = row.held_above || (corner && facade.inside_above);
    return cell;
}

/// @param avoid joints of the courses below and above; @returns the joints between the blocks of the row
std::vector<double> lay_row(const Laying& laying, const Row& row, const std::vector<double>& avoid)
{
    const double length = laying.block.length;
    const double origin = laying.facade.corner + (row.parity == 1 ? length / 2 : 0);
    std::vector<double> between;
    int number = 0;
    for (const Stretch& stretch : stretches_in(laying, row.course)) {
        if (stretch.end - stretch.begin < (smallest_piece - same_place) * length) refuse_sliver(laying, stretch);
        const std::vector<double> joints = joints_of(stretch, origin, length, avoid);
        for (std::size_t i = 0; i + 1 < joints.size(); ++i)
            laying.cells.push_back(cell_of(laying, row, {joints[i], joints[i + 1]}, ++number));
        between.insert(between.end(), joints.begin() + 1, joints.end() - 1);
    }
    return between;
}

/// The bed nearest to a height.
double bed_at(const std::vector<double>& beds, double z)
{
    return *std::min_element(beds.begin(), beds.end(),
                             [&](double a, double b) { return std::abs(a - z) < std::abs(b - z); });
}

/// The lintels that lie on the bed below a course.
void lay_lintels(const Laying& laying, int course)
{
    const Facade& facade = laying.facade;
    for (std::size_t i = 0; i < facade.openings.size(); ++i) {
        const Patch patch = patch_of(facade.openings[i].opening, laying.lintel);
        if (!needs_lintel(facade.openings[i].opening, laying.height())) continue;
        if (bed_at(laying.beds, patch.foot) != laying.beds[course]) continue;
        Cell cell{facade.name + "_lintel_" + std::to_string(i + 1), {}, {}, facade.along, Cell::Kind::lintel};
        cell.lower[facade.along] = patch.left;
        cell.upper[facade.along] = patch.right;
        cell.lower[1 - facade.along] = facade.lower;
        cell.upper[1 - facade.along] = facade.upper;
        cell.lower.z() = laying.beds[course];
        cell.upper.z() = bed_at(laying.beds, patch.top);
        laying.cells.push_back(cell);
    }
}

}  // namespace

void lay(const Facade& facade, const std::vector<double>& beds, const BlockFormat& block, const Lintel& lintel,
         std::vector<Cell>& cells, std::vector<Fault>& faults)
{
    const Laying laying{facade, beds, block, lintel, cells, faults};
    std::vector<std::vector<double>> below;  // joints of each leaf of the last course
    for (int course = 0; course < laying.courses(); ++course) {
        const std::vector<Row> rows = rows_of(laying, course);
        const std::vector<double> fixed_here = fixed_joints(laying, course);
        const std::vector<double> fixed_above = fixed_joints(laying, course + 1);
        std::vector<std::vector<double>> here;
        for (std::size_t leaf = 0; leaf < rows.size(); ++leaf) {
            std::vector<double> avoid = fixed_above;
            for (std::size_t other = 0; other < below.size(); ++other)
                if (rows.size() != below.size() || other == leaf)
                    avoid.insert(avoid.end(), below[other].begin(), below[other].end());
            here.push_back(lay_row(laying, rows[leaf], avoid));
            here.back().insert(here.back().end(), fixed_here.begin(), fixed_here.end());
        }
        lay_lintels(laying, course);
        if (cells.size() > max_blocks)  // halves of blocks and headers, which no estimate knows beforehand
            throw InputError("block", "more than " + std::to_string(max_blocks) + " blocks",
                             "give a larger block or a smaller wall");
        below = std::move(here);
    }
}

}  // namespace voussoir::importers::patterns
