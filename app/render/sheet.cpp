#include "app/render/sheet.h"

#include <cairo.h>

#include <algorithm>
#include <memory>
#include <system_error>

#include "libdda/errors.h"

namespace voussoir
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

const Rgb ink(0.13F, 0.14F, 0.17F), faint_ink(0.38F, 0.40F, 0.44F);

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
    std::error_code none;
    std::filesystem::remove(path, none);  // a link there may lead anywhere
    const cairo_status_t status = cairo_surface_write_to_png(surface_, path.c_str());
    if (status != CAIRO_STATUS_SUCCESS) {
        throw InputError(path.string(), std::string("cannot be written: ") + cairo_status_to_string(status),
                         "give a writable folder on a disk with free space");
    }
}

void set_color(cairo_t* pen, const Rgb& color)
{
    cairo_set_source_rgb(pen, color.x(), color.y(), color.z());
}

void set_font(cairo_t* pen, double size, bool bold)
{
    cairo_select_font_face(pen, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(pen, size);
}

double text_width(cairo_t* pen, const std::string& text)
{
    cairo_text_extents_t extents;
    cairo_text_extents(pen, text.c_str(), &extents);
    return extents.x_advance;
}

void show(cairo_t* pen, const std::string& text, double x, double y)
{
    cairo_move_to(pen, x, y);
    cairo_show_text(pen, text.c_str());
}

void write_head(const Sheet& sheet, const std::string& title, const std::string& subtitle, double margin)
{
    set_font(sheet.pen, 25, true);
    const double share = (sheet.width - 2 * margin) / std::max(text_width(sheet.pen, title), 1.0);
    set_font(sheet.pen, 25 * std::clamp(share, 0.66, 1.0), true);
    set_color(sheet.pen, ink);
    show(sheet.pen, title, margin, 52);
    set_font(sheet.pen, 18);
    set_color(sheet.pen, faint_ink);
    show(sheet.pen, subtitle, margin, 82);
}

double legend_entry(cairo_t* pen, const std::string& words, const Rgb& color, bool area, double x, double y)
{
    set_color(pen, color);
    cairo_rectangle(pen, x, area ? y - 12 : y - 7, 26, area ? 14 : 4);
    cairo_fill_preserve(pen);
    set_color(pen, area ? ink : color);
    cairo_set_line_width(pen, area ? 1 : 0.1);
    cairo_stroke(pen);
    set_color(pen, ink);
    show(pen, words, x + 35, y);
    return x + 35 + text_width(pen, words) + 30;
}

}  // namespace voussoir
