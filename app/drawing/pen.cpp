#include "app/drawing/pen.h"

#include <cairo.h>
#include <fmt/format.h>

#include <system_error>

#include "importers/process/program_start.h"
#include "libdda/errors.h"

namespace voussoir::app::drawing
{

void use(Cairo* pen, const Color& color, double opacity)
{
    cairo_set_source_rgba(pen, color.red, color.green, color.blue, opacity);
}

void use(Cairo* pen, const Rgb& color)
{
    cairo_set_source_rgb(pen, color.x(), color.y(), color.z());
}

void font(Cairo* pen, double size, bool bold)
{
    cairo_select_font_face(pen, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(pen, size);
}

double width_of(Cairo* pen, const std::string& text)
{
    cairo_text_extents_t extents;
    cairo_text_extents(pen, text.c_str(), &extents);
    return extents.x_advance;
}

void write(Cairo* pen, const std::string& text, double x, double y, double anchor)
{
    cairo_move_to(pen, x - anchor * width_of(pen, text), y);
    cairo_show_text(pen, text.c_str());
}

void line(Cairo* pen, double x0, double y0, double x1, double y1)
{
    cairo_move_to(pen, x0, y0);
    cairo_line_to(pen, x1, y1);
    cairo_stroke(pen);
}

void write_power(Cairo* pen, int exponent, double x, double y, double anchor)
{
    const std::string raised = fmt::format("{}", exponent);
    font(pen, 8.5);
    const double small = width_of(pen, raised);
    font(pen, 12);
    const double start = x - anchor * (width_of(pen, "10") + small);
    write(pen, "10", start, y);
    const double after = start + width_of(pen, "10");
    font(pen, 8.5);
    write(pen, raised, after, y - 5);
}

void write_on_white(Cairo* pen, const std::string& text, double x, double y)
{
    cairo_move_to(pen, x - width_of(pen, text), y);
    cairo_text_path(pen, text.c_str());
    cairo_save(pen);
    cairo_set_source_rgba(pen, 1, 1, 1, 0.85);
    cairo_set_line_width(pen, 4);
    cairo_stroke_preserve(pen);
    cairo_restore(pen);
    cairo_fill(pen);
}

void mark(Cairo* pen, std::size_t shape, double x, double y)
{
    constexpr double r = 4.2;
    cairo_new_path(pen);
    if (shape % 4 == 0) cairo_arc(pen, x, y, r, 0, 6.2831853);
    if (shape % 4 == 1) cairo_rectangle(pen, x - 0.85 * r, y - 0.85 * r, 1.7 * r, 1.7 * r);
    if (shape % 4 >= 2) {
        const double side = shape % 4 == 2 ? 0.9 * r : 0;
        cairo_move_to(pen, x, y - 1.2 * r);
        cairo_line_to(pen, x + 1.1 * r, y + side);
        if (side == 0) cairo_line_to(pen, x, y + 1.2 * r);
        cairo_line_to(pen, x - 1.1 * r, y + side);
        cairo_close_path(pen);
    }
    cairo_fill_preserve(pen);
    cairo_save(pen);
    cairo_set_source_rgb(pen, 1, 1, 1);
    cairo_set_line_width(pen, 0.8);
    cairo_stroke(pen);
    cairo_restore(pen);
}

void write_png(cairo_surface_t* surface, const std::filesystem::path& file)
{
    const importers::process::SignalsHeld held;
    std::filesystem::path part = file;
    part += ".part";
    std::error_code error;
    std::filesystem::remove(part, error);  // a link there may lead anywhere
    const cairo_status_t status = cairo_surface_write_to_png(surface, part.c_str());
    if (status == CAIRO_STATUS_SUCCESS) {
        std::filesystem::rename(part, file, error);
        if (!error) return;
    }
    const std::string reason = error ? error.message() : cairo_status_to_string(status);
    std::filesystem::remove(part, error);
    throw InputError(file.string(), "cannot be written: " + reason,
                     "give a writable folder on a disk with free space");
}

}  // namespace voussoir::app::drawing
