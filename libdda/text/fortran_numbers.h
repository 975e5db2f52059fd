// Numbers as Fortran programs write them, alone and in rows; the same in every locale.
#pragma once

#include <string_view>
#include <vector>

namespace voussoir::text
{

/// The number at the start of `text` (Fortran's "+.5", "1.E-3" and "1.D-3" included; "nan" and "inf" are numbers
/// here, so that they can be refused as such). @returns characters used, 0 when there is none
std::size_t parse_leading_number(std::string_view text, double& value);

/// The whole of `text`, trimmed, is one number.
bool parse_fortran_number(std::string_view text, double& value);

/// Numbers of a line separated by white space, or each by one comma or semicolon; a line that mixes both (decimal
/// commas do) is not accepted. @returns false when anything on the line is not a number
bool parse_separated(std::string_view line, std::vector<double>& values);

/// Numbers written by a Fortran format, which may touch: "-1.3724600E-07-2.6835700E-07".
/// @returns false when anything on the line is not a number
bool parse_fortran(std::string_view line, std::vector<double>& values);

}  // namespace voussoir::text
