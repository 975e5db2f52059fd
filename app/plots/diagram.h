// Diagrams as data: what verify and converge hand to the helper program that draws.
#pragma once

#include <string>
#include <vector>

namespace voussoir
{

struct Curve {
    std::string name;  // in the legend; curves of one name share a colour
    std::vector<double> x, y;
    bool is_reference = false;  // drawn broad and grey under the others
};

struct Level {
    std::string name;  // written on the line
    double y = 0;
    bool tolerance = false;  // green: what is to be met; red: what was reached elsewhere
};

struct Diagram {
    std::string x_title, y_title;  // with units
    std::vector<Curve> curves;
    std::vector<Level> levels;                        // horizontal lines
    bool logarithmic_x = true, logarithmic_y = true;  // values are then > 0
    bool marks = true;                                // on the points of curves; else lines alone
};

struct Figure {
    std::string name;  // of the file, without ending
    std::string title, subtitle;
    std::vector<Diagram> diagrams;   // side by side, or
    bool stacked = false;            // broad and low, one under another
    std::vector<std::string> notes;  // at the foot: what could not be drawn
};

/// Figures as JSON text and back, on their way to the helper program.
std::string figures_json(const std::vector<Figure>& figures);
std::vector<Figure> figures_of_json(const std::string& text);

}  // namespace voussoir
