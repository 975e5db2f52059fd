#include "app/render/page.h"

#include <cairo.h>

#include <algorithm>
#include <memory>

#include "libdda/errors.h"

namespace voussoir
{

namespace
{

// Logical pixels of a picture 900 high.
constexpr double margin = 40, head = 108, foot = 92, bar_column = 150, bar_width = 22;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void set_color(cairo_t* pen, const Rgb& color)
{
    cairo_set_source_rgb(pen, color.x(), color.y(), color.z());
}

const Rgb ink(0.13F, 0.14F, 0.17F), faint_ink(0.38F, 0.40F, 0.44F);

void set_font(cairo_t* pen, double size, bool bold = false)
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

/// A title too long for the picture is drawn smaller, down to two thirds.
void write_head(cairo_t* pen, const PageText& text, double width)
{
    set_font(pen, 25, true);
    const double share = (width - 2 * margin) / std::max(text_width(pen, text.title), 1.0);
    set_font(pen, 25 * std::clamp(share, 0.66, 1.0), true);
    set_color(pen, ink);
    show(pen, text.title, margin, 52);
    set_font(pen, 18);
    set_color(pen, faint_ink);
    show(pen, text.subtitle, margin, 82);
}

void draw_bar(cairo_t* pen, const ColorScale& scale, double width, double height)
{
    const double x = width - bar_column + 20, length = 0.56 * height, bottom = 0.5 * height + length / 2;
    constexpr int strips = 256;
    cairo_set_antialias(pen, CAIRO_ANTIALIAS_NONE);
    for (int i = 0; i < strips; ++i) {
        set_color(pen, viridis((static_cast<float>(i) + 0.5F) / strips));
        cairo_rectangle(pen, x, bottom - length * (i + 1) / strips, bar_width, length / strips + 1);
        cairo_fill(pen);
    }
    cairo_set_antialias(pen, CAIRO_ANTIALIAS_DEFAULT);
    set_color(pen, ink);
    cairo_set_line_width(pen, 1);
    cairo_rectangle(pen, x, bottom - length, bar_width, length);
    cairo_stroke(pen);
    set_font(pen, 15);
    double widest = 0;
    for (std::size_t i = 0; i < scale.ticks.size(); ++i) {
        const double y = bottom - length * scale.share(scale.ticks[i]);
        cairo_move_to(pen, x + bar_width, y);
        cairo_line_to(pen, x + bar_width + 6, y);
        cairo_stroke(pen);
        show(pen, scale.labels[i], x + bar_width + 11, y + 5.5);
        widest = std::max(widest, text_width(pen, scale.labels[i]));
    }
    cairo_save(pen);
    set_font(pen, 15);
    cairo_translate(pen, std::min(x + bar_width + 11 + widest + 24, width - 8), 0.5 * height);
    cairo_rotate(pen, -1.5707963267948966);
    show(pen, scale.caption, -text_width(pen, scale.caption) / 2, 0);
    cairo_restore(pen);
}

/// One entry at the lower left. @returns where the next one starts
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

void write_foot(cairo_t* pen, const PageText& text, double width, double height)
{
    set_font(pen, 15);
    double x = margin;
    const double y = height - 34;
    if (!text.opened.empty()) x = legend_entry(pen, text.opened, opened_color(), false, x, y);
    if (!text.slid.empty()) x = legend_entry(pen, text.slid, slid_color(), false, x, y);
    if (text.foundations) legend_entry(pen, "foundation", foundation_color(), true, x, y);
    set_color(pen, faint_ink);
    double line = y - 22.0 * (static_cast<double>(text.notes.size()) - 1);
    for (const std::string& note : text.notes) {
        show(pen, note, width - margin - text_width(pen, note), line);
        line += 22;
    }
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

double logical_pixel(int width, int height)
{
    return std::min(height / 900.0, width / 1100.0);
}

PictureArea drawing_area(int width, int height)
{
    const double pixel = logical_pixel(width, height), w = width / pixel, h = height / pixel;
    return {-1 + 2 * margin / w, 1 - 2 * (bar_column + 10) / w, -1 + 2 * foot / h, 1 - 2 * head / h};
}

void write_page(const Image& drawing, const ColorScale& scale, const PageText& text,
                const std::filesystem::path& path)
{
    const double pixel = logical_pixel(drawing.width, drawing.height);
    const double width = drawing.width / pixel, height = drawing.height / pixel;
    const Surface page(cairo_image_surface_create(CAIRO_FORMAT_RGB24, drawing.width, drawing.height),
                       &cairo_surface_destroy);
    const Surface layer = surface_of(drawing);
    {
        const Pen pen(cairo_create(page.get()), &cairo_destroy);
        cairo_scale(pen.get(), pixel, pixel);
        paint_background(pen.get(), width, height);
        cairo_save(pen.get());
        cairo_scale(pen.get(), 1 / pixel, 1 / pixel);
        cairo_set_source_surface(pen.get(), layer.get(), 0, 0);
        cairo_paint(pen.get());
        cairo_restore(pen.get());
        write_head(pen.get(), text, width);
        draw_bar(pen.get(), scale, width, height);
        write_foot(pen.get(), text, width, height);
    }
    const cairo_status_t status = cairo_surface_write_to_png(page.get(), path.c_str());
    if (status != CAIRO_STATUS_SUCCESS) {
        throw InputError(path.string(), std::string("cannot be written: ") + cairo_status_to_string(status),
                         "give a folder that can be written on a disk with room");
    }
}

}  // namespace voussoir
