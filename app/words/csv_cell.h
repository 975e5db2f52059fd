// Text of others in tables that spreadsheets open.
#pragma once

#include <string>
#include <string_view>

namespace voussoir::app::words
{

/// A cell of a CSV file: in quotation marks where it holds a comma, a quotation mark or a line end. A spreadsheet
/// takes what begins with = + - @, a tab or a line end for a formula, and runs it: such a cell gets an apostrophe
/// in front, unless it is a number.
std::string csv_cell(std::string_view text);

}  // namespace voussoir::app::words
