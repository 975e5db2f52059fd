#include "app/plots/diagram.h"

#include <nlohmann/json.hpp>

namespace voussoir::app::plots
{

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Curve, name, x, y, is_reference)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Level, name, y, tolerance)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Diagram, x_title, y_title, curves, levels, logarithmic_x, logarithmic_y, marks)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TileKey, name, color)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Tile, text, under, color)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TileMap, x_title, y_title, columns, rows, width, tiles, keys)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Figure, name, title, subtitle, diagrams, stacked, notes, maps)

std::string figures_json(const std::vector<Figure>& figures)
{
    // Titles come from case files: what is no UTF-8 in them is replaced.
    return nlohmann::json(figures).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<Figure> figures_of_json(const std::string& text)
{
    return nlohmann::json::parse(text).get<std::vector<Figure>>();
}

}  // namespace voussoir::app::plots
