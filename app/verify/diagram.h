// A log-log diagram as data, and drawing a row of them as one picture.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace voussoir
{

struct Curve {
    std::string name;  // in the legend; curves of one name share a colour
    std::vector<double> x, y;
};

struct Level {
    std::string name;  // written on the line
    double y = 0;
};

struct Diagram {
    std::string x_title, y_title;  // with units
    std::vector<Curve> curves;
    std::vector<Level> levels;  // horizontal lines
};

struct Figure {
    std::string title, subtitle;
    std::vector<Diagram> diagrams;   // side by side
    std::vector<std::string> notes;  // at the foot: what could not be drawn
};

/// @throws InputError when the file cannot be written
void draw_figure(const Figure& figure, const std::filesystem::path& file);

}  // namespace voussoir
