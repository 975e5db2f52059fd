// What the lines above a table of numbers tell.
#pragma once

#include <string>
#include <vector>

#include "records/source_file.h"
#include "records/units.h"

namespace voussoir::records::formats
{

/// @param first_row 0-based line of the first row of numbers
/// @throws InputError when the heading is one of response spectra: columns of periods and spectral values read
/// like times and samples
void refuse_spectra(const SourceFile& file, std::size_t first_row);

/// The 0-based column the heading calls time ("n;Time (s);a"), if it has a name for each of the `width` columns;
/// else 0.
std::size_t named_time_column(const SourceFile& file, std::size_t first_row, std::size_t width);

/// Says that a unit is not taken from the heading, when there is a heading and no unit.
void remark_on_heading(const SourceFile& file, std::size_t first_row, const Unit& unit,
                       std::vector<std::string>& remarks);

}  // namespace voussoir::records::formats
