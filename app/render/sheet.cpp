#include "app/render/sheet.h"

#include <cairo.h>

#include <algorithm>
#include <memory>

#include "app/drawing/pen.h"

namespace voussoir::app::render
{

namespace
{

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void paint_background(cairo_t* pen, double width, double height)
{
    cairo_pattern_t* shade = cairo_pattern_create_linear(0, 0, 0, height);
    cairo_pattern_add_color_stop_rgb(shade, 0, 1, 1, 1);
    cairo_pattern_add_color_stop_rgb(shade, 0.45, 0.985, 0.988, 0.992);
    cairo_pattern_add_color_stop_rgb(shade, 1, 0.90, 0.92, 0.94);
    cairo_set_source(pen, shade);
    cairo_rectangle(pen, 0, 0, width, height);
    cairo_fill(pen);
    cairo_pattern_destroy(shade);
}

Surface surface_of(const Image& image)
{
    Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height),
                    &cairo_surface_destroy);
    cairo_surface_flush(surface.get());
    unsigned char* bytes = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = 0; y < image.height && bytes != nullptr; ++y) {
        const std::uint32_t* row = image.pixels.data() + static_cast<std::size_t>(y) * image.width;
        std::copy_n(row, image.width,
                    reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::size_t>(y) * stride));
    }
    cairo_surface_mark_dirty(surface.get());
    return surface;
}

}  // namespace

const drawing::Rgb ink(0.13F, 0.14F, 0.17F), faint_ink(0.38F, 0.40F, 0.44F);

Sheet::Sheet(const Image& drawing, double pixel) : width(drawing.width / pixel), height(drawing.height / pixel)
{
    surface_ = cairo_image_surface_create(CAIRO_FORMAT_RGB24, drawing.width, drawing.height);
    pen = cairo_create(surface_);
    paint_background(pen, drawing.width, drawing.height);
    const Surface layer = surface_of(drawing);
    cairo_set_source_surface(pen, layer.get(), 0, 0);
    cairo_paint(pen);
    cairo_scale(pen, pixel, pixel);
}

Sheet::~Sheet()
{
    cairo_destroy(pen);
    cairo_surface_destroy(surface_);
}

void Sheet::write(const std::filesystem::path& path) const
{
    cairo_surface_flush(surface_);
    drawing::write_png(surface_, path);
}

std::vector<std::uint32_t> Sheet::pixels() const
{
    cairo_surface_flush(surface_);
    const int columns = cairo_image_surface_get_width(surface_), rows = cairo_image_surface_get_height(surface_),
              stride = cairo_image_surface_get_stride(surface_);
    const unsigned char* bytes = cairo_image_surface_get_data(surface_);
    std::vector<std::uint32_t> pixels;
    pixels.reserve(static_cast<std::size_t>(columns) * rows);
    for (int y = 0; y < rows; ++y) {
        const auto* row = reinterpret_cast<const std::uint32_t*>(bytes + static_cast<std::size_t>(y) * stride);
        pixels.insert(pixels.end(), row, row + columns);
    }
    return pixels;
}

void write_head(const Sheet& sheet, const std::string& title, const std::string& subtitle, double margin)
{
    drawing::font(sheet.pen, 25, true);
    const double share = (sheet.width - 2 * margin) / std::max(drawing::width_of(sheet.pen, title), 1.0);
    drawing::font(sheet.pen, 25 * std::clamp(share, 0.66, 1.0), true);
    drawing::use(sheet.pen, ink);
    drawing::write(sheet.pen, title, margin, 52);
    drawing::font(sheet.pen, 18);
    drawing::use(sheet.pen, faint_ink);
    drawing::write(sheet.pen, subtitle, margin, 82);
}

double legend_entry(cairo_t* pen, const std::string& words, const drawing::Rgb& color, bool area, double x,
                    double y)
{
    drawing::use(pen, color);
    cairo_rectangle(pen, x, area ? y - 12 : y - 7, 26, area ? 14 : 4);
    cairo_fill_preserve(pen);
    drawing::use(pen, area ? ink : color);
    cairo_set_line_width(pen, area ? 1 : 0.1);
    cairo_stroke(pen);
    drawing::use(pen, ink);
    drawing::write(pen, words, x + 35, y);
    return x + 35 + drawing::width_of(pen, words) + 30;
}

}  // namespace voussoir::app::render
