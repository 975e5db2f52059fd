// Domes and vaults of stones that share their joints.
#pragma once

#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{

/// A small tower of posts over the oculus of a dome. Lengths in m.
struct Lantern {
    double height = 0;  // of the posts; 0: no lantern
    double ring = 0.3;  // height of the rings below and above the posts
    double cap = 1;     // rise of the cap, one stone
};

/// A spherical dome. Angles are measured at the centre of the sphere, from the axis.
struct Dome {
    double radius = 5;         // m, of the intrados
    double thickness = 0.5;    // m
    double oculus = 0.2618;    // rad, to the upper edge of the last course
    double springing = 1.309;  // rad, to the lower bed of the first course; at most a right angle
    int courses = 6;           // number
    int stones = 15;           // number in each course
    bool bonded = true;        // every other course is turned by half a stone; else the head joints are meridians
    bool keystone = false;     // one stone closes the oculus
    double support = 0.5;      // m, depth of the supports below the springing of the intrados
    bool half = false;         // the half at y > 0, behind an arch; `stones` are those of half a course
    double front = 0.5;        // m, depth along y of the arch before a half dome
    Lantern lantern = {};
};

/// A barrel vault over a circular arc.
struct BarrelVault {
    double span = 5;         // m, of the intrados
    double rise = 2;         // m, of the intrados; at most half the span
    double thickness = 0.4;  // m
    double length = 5;       // m
    int courses = 15;        // number, from springing to springing
    int stones = 8;          // number along a course
    bool bonded = true;      // every other course begins and ends with half a stone
    double support = 0.5;    // m, depth of the supports below the springing of the intrados
};

/// A groin vault over a square bay: two barrel vaults, cut along the diagonals. The stones at the groins belong to
/// both barrels.
struct CrossVault {
    double span = 5;         // m, of the intrados of the arches at the four sides
    double rise = 2;         // m, of the intrados; at most half the span
    double thickness = 0.3;  // m
    double margin = 0.2;     // m, from the outermost point of the extrados to the side of the bay
    int courses = 8;         // number, from springing to crown
    int stones = 6;          // number along the crown, from the centre to the side
    double support = 0.5;    // m, depth of the supports below the springing of the intrados
    double rib_width = 0;    // m, of the ribs under the groins; 0: none
    double rib_depth = 0.3;  // m, by which they stand out of the intrados, along the beds
};

/// Courses from the springing up, each counter-clockwise from the x axis as seen from above: support_01 ...,
/// dome_c01_b01 ..., keystone. z is up, the axis of the dome is x = y = 0, the springing of the intrados z = 0.
///
/// Beds lie on cones about the axis, head joints in planes through it; a course is a polygon of as many sides as
/// it has stones, of twice as many when bonded. All faces are flat; a bonded stone has two to each bed, and is
/// concave. A half dome ends at y = 0 against an arch of its own thickness: front_east_c01 ..., front_keystone,
/// front_west_c01, support_front_east, ...; every other of its courses ends with half stones.
/// A lantern is no part of the grid. @throws InputError with every parameter that makes no dome
StoneGrid dome(const Dome& dome);

/// Courses from left to right, each from the front to the back: support_left_01 ..., vault_c01_b01 ...,
/// support_right_01 .... x is along the span, y along the vault, z up; the middle is x = y = 0, the springing of
/// the intrados z = 0. Bed joints are radial and cut the arc into equal angles.
/// @throws InputError with every parameter that makes no vault
StoneGrid barrel_vault(const BarrelVault& vault);

/// By quadrants (ne, nw, sw, se), courses from the springing up: support_ne, groin_ne_c01 ..., web_ne_x_c01_b01
/// ... from the groin to the side of the bay: the half web whose stones lie along x. z is up, the middle of the
/// bay is x = y = 0, the springing of the intrados z = 0.
///
/// Bed joints are radial to the barrels and cut their arcs into equal angles. Head joints lie half a stone off in
/// neighbouring courses, counted from the side of the bay; the stone at the groin reaches to the first one that
/// leaves it a leg of a quarter of a stone. Ribs are no part of the grid.
/// @throws InputError with every parameter that makes no vault
StoneGrid cross_vault(const CrossVault& vault);

}  // namespace voussoir::importers::patterns
