// Strokes and letters for pictures and diagrams, in Cairo.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "app/drawing/color_map.h"

// Cairo's own names of cairo_t and cairo_surface_t: its header stays in the .cpp files.
struct _cairo;
struct _cairo_surface;

namespace voussoir::app::drawing
{

using Cairo = _cairo;

struct Color {
    double red, green, blue;
};

void use(Cairo* pen, const Color& color, double opacity = 1);
void use(Cairo* pen, const Rgb& color);
void font(Cairo* pen, double size, bool bold = false);
double width_of(Cairo* pen, const std::string& text);
void line(Cairo* pen, double x0, double y0, double x1, double y1);

/// @param anchor 0 left, 0.5 middle, 1 right end of the text at x
void write(Cairo* pen, const std::string& text, double x, double y, double anchor = 0);

/// Text that ends at x, with a white rim that keeps it clear of the curves.
void write_on_white(Cairo* pen, const std::string& text, double x, double y);

/// "10" with a raised exponent, its right end or middle at x.
void write_power(Cairo* pen, int exponent, double x, double y, double anchor);

/// A circle, a square, a triangle, a diamond: curves are told apart without colour too.
void mark(Cairo* pen, std::size_t shape, double x, double y);

/// In the place of what has the name, be it a link. @throws InputError
void write_png(_cairo_surface* surface, const std::filesystem::path& file);

}  // namespace voussoir::app::drawing
