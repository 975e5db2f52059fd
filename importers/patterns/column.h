// Multidrum columns, alone or as the front of a temple.
#pragma once

#include "importers/patterns/imperfection.h"

namespace voussoir::importers::patterns
{

/// A column of drums with an echinus and an abacus. Lengths in m.
struct Column {
    double height = 6;           // of the shaft
    double diameter = 1;         // across the flats, at the foot
    double top_diameter = 0.8;   // at the top of the shaft
    double entasis = 0;          // by which the shaft is thicker half way up than a straight one
    int drums = 6;               // of equal height
    int sides = 16;              // of the drums: flutes without their hollows
    double capital_height = 0;   // of echinus and abacus together; 0: none
    double capital_width = 1.2;  // of the abacus, a square
};

/// A row of columns with what they carry. Lengths in m.
struct TempleFront {
    Column column;
    int columns = 4;             // number
    double spacing = 3;          // between axes
    double architrave = 0.8;     // height; 0: nothing lies on the columns
    double frieze = 0;           // height; 0: none
    double pediment = 0;         // rise at the middle; 0: none
    double pediment_edge = 0.3;  // its height at the ends
    double depth = 0;            // of all that lies on the columns, along y; 0: four fifths of the abacus
};

/// One column: "slab" (group foundation), "drum_1" ... (drums), "echinus" and "abacus" (capital). z is up, its
/// axis x = y = 0, its foot z = 0. @param name before all names @throws InputError with what makes no column
Pattern column(const Column& column, const std::string& name);

/// "stylobate" (foundation), "column_1_drum_1" ..., "column_1_abacus", "architrave_1" ... from axis to axis,
/// "frieze_1" ... with joints over the middles between columns, "pediment_1" ...: upright stones between the
/// same joints and the axes, their backs on two slopes that meet over the middle. x is along the front, its middle
/// at 0. @throws InputError with what makes no temple front
Pattern temple_front(const TempleFront& front, const std::string& name);

}  // namespace voussoir::importers::patterns
