#include "app/render/page.h"

#include <cairo.h>

#include <algorithm>

#include "app/drawing/pen.h"
#include "app/render/sheet.h"

namespace voussoir::app::render
{

namespace
{

// Logical pixels of a picture 900 high.
constexpr double margin = 40, head = 108, foot = 92, bar_column = 150, bar_width = 22;

void draw_bar(cairo_t* pen, const drawing::ColorScale& scale, double width, double height)
{
    const double x = width - bar_column + 20, length = 0.56 * height, bottom = 0.5 * height + length / 2;
    constexpr int strips = 256;
    cairo_set_antialias(pen, CAIRO_ANTIALIAS_NONE);
    for (int i = 0; i < strips; ++i) {
        drawing::use(pen, drawing::viridis((static_cast<float>(i) + 0.5F) / strips));
        cairo_rectangle(pen, x, bottom - length * (i + 1) / strips, bar_width, length / strips + 1);
        cairo_fill(pen);
    }
    cairo_set_antialias(pen, CAIRO_ANTIALIAS_DEFAULT);
    drawing::use(pen, ink);
    cairo_set_line_width(pen, 1);
    cairo_rectangle(pen, x, bottom - length, bar_width, length);
    cairo_stroke(pen);
    drawing::font(pen, 15);
    double widest = 0;
    for (std::size_t i = 0; i < scale.ticks.size(); ++i) {
        const double y = bottom - length * scale.share(scale.ticks[i]);
        cairo_move_to(pen, x + bar_width, y);
        cairo_line_to(pen, x + bar_width + 6, y);
        cairo_stroke(pen);
        drawing::write(pen, scale.labels[i], x + bar_width + 11, y + 5.5);
        widest = std::max(widest, drawing::width_of(pen, scale.labels[i]));
    }
    cairo_save(pen);
    drawing::font(pen, 15);
    cairo_translate(pen, std::min(x + bar_width + 11 + widest + 24, width - 8), 0.5 * height);
    cairo_rotate(pen, -1.5707963267948966);
    drawing::write(pen, scale.caption, -drawing::width_of(pen, scale.caption) / 2, 0);
    cairo_restore(pen);
}

void write_foot(const Sheet& sheet, const PageText& text)
{
    drawing::font(sheet.pen, 15);
    double x = margin;
    const double y = sheet.height - 34;
    if (!text.opened.empty()) x = legend_entry(sheet.pen, text.opened, opened_color(), false, x, y);
    if (!text.slid.empty()) x = legend_entry(sheet.pen, text.slid, slid_color(), false, x, y);
    if (text.foundations) legend_entry(sheet.pen, "foundation", foundation_color(), true, x, y);
    drawing::use(sheet.pen, faint_ink);
    double line = y - 22.0 * (static_cast<double>(text.notes.size()) - 1);
    for (const std::string& note : text.notes) {
        drawing::write(sheet.pen, note, sheet.width - margin - drawing::width_of(sheet.pen, note), line);
        line += 22;
    }
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

void write_page(const Image& drawing, const drawing::ColorScale& scale, const PageText& text,
                const std::filesystem::path& path)
{
    const Sheet sheet(drawing, logical_pixel(drawing.width, drawing.height));
    write_head(sheet, text.title, text.subtitle, margin);
    draw_bar(sheet.pen, scale, sheet.width, sheet.height);
    write_foot(sheet, text);
    sheet.write(path);
}

}  // namespace voussoir::app::render
