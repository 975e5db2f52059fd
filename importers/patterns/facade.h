// One wall, alone or of a house, laid course by course.
#pragma once

#include <string>
#include <vector>

#include "importers/patterns/cells.h"
#include "libdda/errors.h"

namespace voussoir::importers::patterns
{

/// Length and height of a whole block [m], as it lies in the wall.
struct BlockFormat {
    double length = 0, height = 0;
};

/// An opening, and how faults name it: "openings[2]".
struct NamedOpening {
    Opening opening;
    std::string key;
};

/// One wall as it stands in the pattern's own axes; it begins at 0 on the axis it runs along.
struct Facade {
    std::string name;             // its blocks are NAME_c01_b01, ...
    double length = 0;            // m, corners included
    double lower = 0, upper = 0;  // m, its two faces, on the axis across it
    int along = 0;                // 0, 1: it runs along x, y
    double corner = 0;            // m, thickness of the walls it meets at both ends; 0: free ends
    int runs_through = 0;      // 0, 1: which courses, counted from 0, reach the outside of the corners: even, odd
    bool inside_above = true;  // the walls it meets stand on its upper side, not on its lower one
    int leaves = 1;            // side by side through the thickness
    std::vector<double> leaf_thickness = {};  // m, of each leaf, from the lower face; empty: all alike
    int header_every = 0;                     // every so manyth course is one block thick; 0: none
    std::vector<NamedOpening> openings;
};

/// Adds what is wrong with the openings of a wall and their lintels, and with the lintel itself.
void check_openings(const Facade& facade, double height, const Lintel& lintel, std::vector<Fault>& faults);

/// Where the bed joints lie, foot and top included [m]: whole courses upwards from every sill, head and top of a
/// lintel; the last one below the next such level is cut to fit, and a rest lower than a third of a course makes
/// it higher instead. The openings must have been checked.
/// @throws InputError when two levels lie nearer to each other than a third of a course
std::vector<double> bed_levels(double height, const BlockFormat& block, const Lintel& lintel,
                               const std::vector<Facade>& facades);

/// Adds the blocks of every course and the lintels.
///
/// Joints lie whole lengths from the beginning (at corners: from the inner corner), and half a length off in every
/// second course. A joint less than a quarter length from one in the course below, from a lintel's end or from a
/// corner is moved to a quarter length, if no piece gets shorter than a third of a length, or left out where the
/// block is then at most one and a half lengths long; else it stays. Pieces shorter than a third of a length are
/// part of their neighbour; where a piece of wall has no neighbour it is a fault.
void lay(const Facade& facade, const std::vector<double>& beds, const BlockFormat& block, const Lintel& lintel,
         std::vector<Cell>& cells, std::vector<Fault>& faults);

}  // namespace voussoir::importers::patterns
