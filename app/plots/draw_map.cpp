#include "app/plots/draw_map.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/drawing/pen.h"

namespace voussoir::app::plots
{
namespace
{

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr drawing::Color ink{0.13, 0.14, 0.17}, faint_ink{0.42, 0.44, 0.48}, white{1, 1, 1};

// Logical pixels; the picture has `sharpness` pixels to each.
constexpr double sharpness = 2, head = 74, margin = 24, tile_height = 34, gap = 2, axis_height = 50;
constexpr double least_tile = 92, max_tile = 170, legend_line = 20, note_line = 15, text_room = 10;
constexpr double title_height = 30;  // of the axis title on the left

struct Sheet {
    double left, tile_width, width, foot, height;
};

drawing::Color color_of(const std::vector<double>& color)
{
    return {color.at(0), color.at(1), color.at(2)};
}

/// As wide as the longest words need.
Sheet sheet_of(cairo_t* pen, const Figure& figure, const TileMap& map)
{
    drawing::font(pen, 12);
    double names = 0, words = least_tile;
    for (const std::string& row : map.rows) names = std::max(names, drawing::width_of(pen, row));
    drawing::font(pen, 11);
    for (const Tile& tile : map.tiles)
        words = std::max({words, drawing::width_of(pen, tile.text) + text_room,
                          drawing::width_of(pen, tile.under) + text_room});
    drawing::font(pen, 17, true);
    Sheet sheet{};
    sheet.left = margin + (map.y_title.empty() ? 0 : title_height) + names + 10;
    sheet.tile_width = std::min(words, max_tile);
    drawing::font(pen, 12);
    double least = drawing::width_of(pen, figure.subtitle);
    drawing::font(pen, 17, true);
    least = std::max(least, drawing::width_of(pen, figure.title)) + 2 * margin;
    sheet.width = std::max(sheet.left + sheet.tile_width * map.width + margin, least);
    sheet.foot = head + tile_height * static_cast<double>(map.rows.size());
    sheet.height = sheet.foot + (map.columns.empty() ? 16 : axis_height) + 14 +
                   legend_line * static_cast<double>((map.keys.size() + 2) / 3) +
                   note_line * static_cast<double>(figure.notes.size()) + 6;
    return sheet;
}

/// Dark words on pale squares, white ones on dark squares.
drawing::Color ink_on(const drawing::Color& ground)
{
    return 0.30 * ground.red + 0.59 * ground.green + 0.11 * ground.blue < 0.5 ? white : ink;
}

/// Words too long for the square are written narrower.
void write_within(cairo_t* pen, const std::string& text, double x, double y, double room, double size)
{
    drawing::font(pen, size);
    const double wide = drawing::width_of(pen, text);
    if (wide > room) drawing::font(pen, size * room / wide);
    drawing::write(pen, text, x, y, 0.5);
}

void draw_tile(cairo_t* pen, const Tile& tile, double left, double top, double width)
{
    const drawing::Color ground = color_of(tile.color);
    drawing::use(pen, ground);
    cairo_rectangle(pen, left, top, width - gap, tile_height - gap);
    cairo_fill(pen);
    drawing::use(pen, ink_on(ground));
    const double middle = left + (width - gap) / 2, room = width - text_room / 2;
    if (tile.under.empty()) return write_within(pen, tile.text, middle, top + tile_height / 2 + 3, room, 11);
    write_within(pen, tile.text, middle, top + 14, room, 11);
    write_within(pen, tile.under, middle, top + 27, room, 9.5);
}

void draw_axes(cairo_t* pen, const TileMap& map, const Sheet& sheet)
{
    drawing::use(pen, ink);
    drawing::font(pen, 12);
    for (std::size_t i = 0; i < map.rows.size(); ++i)
        drawing::write(pen, map.rows[i], sheet.left - 8,
                       sheet.foot - tile_height * (static_cast<double>(i) + 0.5) + 4, 1);
    for (std::size_t i = 0; i < map.columns.size(); ++i)
        drawing::write(pen, map.columns[i], sheet.left + sheet.tile_width * (static_cast<double>(i) + 0.5),
                       sheet.foot + 18, 0.5);
    drawing::font(pen, 13);
    drawing::write(pen, map.x_title, sheet.left + sheet.tile_width * map.width / 2, sheet.foot + 42, 0.5);
    cairo_save(pen);
    cairo_translate(pen, margin + 8, (head + sheet.foot) / 2);
    cairo_rotate(pen, -1.5707963267948966);
    drawing::write(pen, map.y_title, 0, 0, 0.5);
    cairo_restore(pen);
}

void draw_legend(cairo_t* pen, const Figure& figure, const TileMap& map, const Sheet& sheet)
{
    double y = sheet.foot + (map.columns.empty() ? 16 : axis_height) + 14;
    const double column = (sheet.width - 2 * margin) / 3;
    for (std::size_t i = 0; i < map.keys.size(); ++i) {
        const double x = margin + column * static_cast<double>(i % 3);
        drawing::use(pen, color_of(map.keys[i].color));
        cairo_rectangle(pen, x, y - 11, 22, 14);
        cairo_fill(pen);
        drawing::use(pen, ink);
        drawing::font(pen, 11);
        drawing::write(pen, map.keys[i].name, x + 30, y);
        if (i % 3 == 2 || i + 1 == map.keys.size()) y += legend_line;
    }
    drawing::use(pen, faint_ink);
    drawing::font(pen, 11);
    for (const std::string& note : figure.notes) {
        drawing::write(pen, note, margin, y);
        y += note_line;
    }
}

void draw_sheet(cairo_t* pen, const Figure& figure, const TileMap& map, const Sheet& sheet)
{
    cairo_scale(pen, sharpness, sharpness);
    drawing::use(pen, white);
    cairo_paint(pen);
    drawing::font(pen, 17, true);
    drawing::use(pen, ink);
    drawing::write(pen, figure.title, margin, 32);
    drawing::font(pen, 12);
    drawing::use(pen, faint_ink);
    drawing::write(pen, figure.subtitle, margin, 54);
    for (std::size_t i = 0; i < map.tiles.size(); ++i) {
        const auto row = static_cast<double>(i / static_cast<std::size_t>(map.width));
        const auto column = static_cast<double>(i % static_cast<std::size_t>(map.width));
        if (!map.tiles[i].color.empty())
            draw_tile(pen, map.tiles[i], sheet.left + sheet.tile_width * column,
                      sheet.foot - tile_height * (row + 1), sheet.tile_width);
    }
    draw_axes(pen, map, sheet);
    draw_legend(pen, figure, map, sheet);
}

Surface image(double width, double height)
{
    return {cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(sharpness * width)),
                                       static_cast<int>(std::ceil(sharpness * height))),
            &cairo_surface_destroy};
}

}  // namespace

void draw_map(const Figure& figure, const std::filesystem::path& file)
{
    const TileMap& map = figure.maps.at(0);
    Sheet sheet{};
    {
        const Surface scratch = image(1, 1);
        const Pen pen(cairo_create(scratch.get()), &cairo_destroy);
        sheet = sheet_of(pen.get(), figure, map);
    }
    const Surface surface = image(sheet.width, sheet.height);
    {
        const Pen pen(cairo_create(surface.get()), &cairo_destroy);
        draw_sheet(pen.get(), figure, map, sheet);
    }
    drawing::write_png(surface.get(), file);
}

}  // namespace voussoir::app::plots
