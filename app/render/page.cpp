#include "app/render/page.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>

#include "app/drawing/pen.h"
#include "app/render/sheet.h"

namespace voussoir::app::render
{

namespace
{

// Logical pixels of a picture 900 high.
constexpr double margin = 40, head = 108, foot = 92, bar_column = 150, bar_width = 22, strip_height = 64;

/// Names with their colours, in place of a bar.
void draw_names(cairo_t* pen, const drawing::ColorScale& scale, double width, double height)
{
    const double x = width - bar_column + 4;
    double y = 0.5 * height - 11.0 * static_cast<double>(scale.ticks.size());
    drawing::font(pen, 13);
    for (std::size_t i = 0; i < scale.ticks.size() && i < 30; ++i, y += 22) {
        drawing::use(pen, drawing::viridis(scale.share(scale.ticks[i])));
        cairo_rectangle(pen, x, y - 11, 14, 14);
        cairo_fill(pen);
        drawing::use(pen, ink);
        drawing::write(pen, scale.labels[i], x + 20, y);
    }
}

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

void write_foot(const Sheet& sheet, const PageText& text, double bottom)
{
    drawing::font(sheet.pen, 15);
    double x = margin;
    const double y = bottom - 34;
    if (!text.opened.empty()) x = legend_entry(sheet.pen, text.opened, opened_color(), false, x, y);
    if (!text.slid.empty()) x = legend_entry(sheet.pen, text.slid, slid_color(), false, x, y);
    if (text.foundations) x = legend_entry(sheet.pen, "foundation", foundation_color(), true, x, y);
    if (!text.blank.empty()) x = legend_entry(sheet.pen, text.blank, blank_color(), true, x, y);
    if (!text.alarm.empty()) {
        drawing::use(sheet.pen, opened_color());
        drawing::font(sheet.pen, 17, true);
        drawing::write(sheet.pen, text.alarm, margin, y - 26);
        drawing::font(sheet.pen, 15);
    }
    drawing::use(sheet.pen, faint_ink);
    double line = y - 22.0 * (static_cast<double>(text.notes.size()) - 1);
    // A legend that reaches as far as the last note has the line for itself.
    if (!text.notes.empty() && x > sheet.width - margin - drawing::width_of(sheet.pen, text.notes.back()))
        line -= 24;
    for (const std::string& note : text.notes) {
        drawing::write(sheet.pen, note, sheet.width - margin - drawing::width_of(sheet.pen, note), line);
        line += 22;
    }
}

void draw_curve(cairo_t* pen, const MotionStrip& strip, double left, double right, double middle, double half)
{
    double peak = 0;
    for (const double value : strip.values) peak = std::max(peak, std::abs(value));
    if (!(peak > 0)) return;
    drawing::use(pen, faint_ink);
    cairo_set_line_width(pen, 0.8);
    for (std::size_t i = 0; i < strip.times.size(); ++i)
        cairo_line_to(pen, left + (right - left) * strip.times[i] / strip.end,
                      middle - half * strip.values[i] / peak);
    cairo_stroke(pen);
}

/// The accelerogram, or without one the time alone, with the mark of the moment.
void draw_strip(const Sheet& sheet, const MotionStrip& strip)
{
    cairo_t* pen = sheet.pen;
    const double left = margin, right = sheet.width - margin, middle = sheet.height - 0.5 * strip_height,
                 half = 0.5 * strip_height - 12;
    const double now = left + (right - left) * std::clamp(strip.now / strip.end, 0.0, 1.0);
    cairo_set_source_rgb(pen, 1, 1, 1);
    cairo_rectangle(pen, left, middle - half - 4, right - left, 2 * half + 8);
    cairo_fill(pen);
    cairo_set_source_rgb(pen, 0.86, 0.89, 0.94);
    cairo_rectangle(pen, left, middle - half - 4, now - left, 2 * half + 8);
    cairo_fill(pen);
    draw_curve(pen, strip, left, right, middle, half);
    drawing::use(pen, opened_color());
    cairo_set_line_width(pen, 2);
    drawing::line(pen, now, middle - half - 4, now, middle + half + 4);
    drawing::font(pen, 12);
    drawing::use(pen, ink);
    drawing::write_on_white(pen, strip.label, right - 6, middle + half + 1);
}

/// All but the writing of the file.
void draw_page(const Sheet& sheet, const drawing::ColorScale& scale, const PageText& text,
               const MotionStrip* strip)
{
    drawing::font(sheet.pen, 14);
    for (const PlacedWord& label : text.labels) {
        drawing::use(sheet.pen, ink);
        drawing::write_on_white(sheet.pen, label.text,
                                label.x * sheet.width + drawing::width_of(sheet.pen, label.text) / 2,
                                label.y * sheet.height + 5);
    }
    write_head(sheet, text.title, text.subtitle, margin);
    if (scale.caption == "group")
        draw_names(sheet.pen, scale, sheet.width, sheet.height);
    else
        draw_bar(sheet.pen, scale, sheet.width, sheet.height);
    write_foot(sheet, text, strip ? sheet.height - strip_height : sheet.height);
    if (strip) draw_strip(sheet, *strip);
}

}  // namespace

double logical_pixel(int width, int height)
{
    return std::min(height / 900.0, width / 1100.0);
}

PictureArea drawing_area(int width, int height, bool strip)
{
    const double pixel = logical_pixel(width, height), w = width / pixel, h = height / pixel;
    return {-1 + 2 * margin / w, 1 - 2 * (bar_column + 10) / w, -1 + 2 * (foot + (strip ? strip_height : 0)) / h,
            1 - 2 * head / h};
}

void write_page(const Image& drawing, const drawing::ColorScale& scale, const PageText& text,
                const std::filesystem::path& path)
{
    const Sheet sheet(drawing, logical_pixel(drawing.width, drawing.height));
    draw_page(sheet, scale, text, nullptr);
    sheet.write(path);
}

std::vector<std::uint32_t> page_pixels(const Image& drawing, const drawing::ColorScale& scale,
                                       const PageText& text, const MotionStrip* strip)
{
    const Sheet sheet(drawing, logical_pixel(drawing.width, drawing.height));
    draw_page(sheet, scale, text, strip);
    return sheet.pixels();
}

}  // namespace voussoir::app::render
