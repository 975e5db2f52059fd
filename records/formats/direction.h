// Where a component points, from the ways in which networks write it.
#pragma once

#include <optional>
#include <string_view>

#include "records/record.h"

namespace voussoir::records::formats
{

struct Direction {
    std::optional<double> azimuth;  // deg clockwise from north, in [0, 360)
    bool is_vertical = false;       // positive upwards
    bool points_down = false;       // vertical, positive downwards
};

/// "90 DEG", "360", "N28W", "S 90 E", "NS", "EW", "NE", "North", "UP", "V", "Down"; what stands after two blanks,
/// a comma or a parenthesis is not read. A pair of letters is positive towards north or east, as is the custom.
/// @returns nothing set when the text names no direction
Direction parse_direction(std::string_view text);

/// Azimuth and vertical of a channel. A component that points down is not a vertical of ours (positive upwards):
/// it stays without a direction, and a remark says so.
void set_direction(Channel& channel, const Direction& direction, std::vector<std::string>& remarks);

}  // namespace voussoir::records::formats
