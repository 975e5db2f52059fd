// Diagrams as data: what verify and converge hand to the helper program that draws.
#pragma once

#include <string>
#include <vector>

namespace voussoir::app::plots
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

/// A colour with its meaning.
struct TileKey {
    std::string name;
    std::vector<double> color;  // red, green, blue, 0 to 1
};

/// One square of a map; without a colour there is none.
struct Tile {
    std::string text, under;    // in the middle, and smaller below it
    std::vector<double> color;  // red, green, blue, 0 to 1
};

/// Coloured squares over two axes of names: a heat map, or a table.
struct TileMap {
    std::string x_title, y_title;
    std::vector<std::string> columns, rows;  // names along the foot, which may be none, and from the foot up
    int width = 0;                           // squares in a row
    std::vector<Tile> tiles;                 // (rows x width), row by row from the foot up
    std::vector<TileKey> keys;               // the legend
};

struct Figure {
    std::string name;  // of the file, without ending
    std::string title, subtitle;
    std::vector<Diagram> diagrams;   // side by side, or
    bool stacked = false;            // broad and low, one under another
    std::vector<std::string> notes;  // at the foot: what could not be drawn
    std::vector<TileMap> maps = {};  // one, and then no diagrams
};

/// Figures as JSON text and back, on their way to the helper program.
std::string figures_json(const std::vector<Figure>& figures);
std::vector<Figure> figures_of_json(const std::string& text);

}  // namespace voussoir::app::plots
