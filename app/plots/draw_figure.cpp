#include "app/plots/draw_figure.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/drawing/pen.h"
#include "app/plots/axis.h"

namespace voussoir::app::plots
{
namespace
{

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr drawing::Color ink{0.13, 0.14, 0.17}, faint_ink{0.42, 0.44, 0.48}, grid_ink{0.91, 0.92, 0.94};
constexpr drawing::Color reference_ink{0.78, 0.79, 0.81};
constexpr drawing::Color tolerance_ink{0.10, 0.45, 0.25}, paper_ink{0.75, 0.22, 0.17};
// Okabe and Ito's colours: told apart by the colour-blind.
constexpr drawing::Color palette[] = {{0.00, 0.45, 0.70}, {0.90, 0.62, 0.00}, {0.00, 0.62, 0.45},
                                      {0.80, 0.47, 0.65}, {0.34, 0.71, 0.91}, {0.84, 0.37, 0.00}};

// Logical pixels; the picture has `sharpness` pixels to each.
constexpr double sharpness = 2, panel_width = 430, panel_height = 330, head = 74, foot = 60;
constexpr double stacked_height = 190;
constexpr double axis_left = 66, axis_right = 20, legend_line = 18, legend_width = 380, note_line = 15;

/// Where a diagram lies in the picture.
struct Panel {
    double left, top, width, height;
    Axis x, y;
    double at_x(double value) const { return left + width * x.share(value); }
    double at_y(double value) const { return top + height * (1 - y.share(value)); }
};

/// The sheet a figure is drawn on.
struct Sheet {
    double width, panels_height;  // with heads and feet of the rows
    double diagram_width, diagram_height, row_height;
};

Sheet sheet_of(const Figure& figure)
{
    const auto count = static_cast<double>(figure.diagrams.size());
    if (figure.stacked) {
        const double row = stacked_height + foot;
        return {2 * panel_width, count * row, 2 * panel_width, stacked_height, row};
    }
    const double width = figure.diagrams.size() == 1 ? 2 * panel_width : panel_width;  // one alone is a broad one
    return {count * width, panel_height + foot, width, panel_height, 0};
}

Panel place(const Diagram& diagram, const Figure& figure, const Sheet& sheet, std::size_t number)
{
    const double left = figure.stacked ? 0 : sheet.diagram_width * static_cast<double>(number);
    std::vector<double> x, y;
    for (const Curve& curve : diagram.curves) {
        x.insert(x.end(), curve.x.begin(), curve.x.end());
        y.insert(y.end(), curve.y.begin(), curve.y.end());
    }
    for (const Level& level : diagram.levels) y.push_back(level.y);
    return {left + axis_left,
            head + sheet.row_height * static_cast<double>(number),
            sheet.diagram_width - axis_left - axis_right,
            sheet.diagram_height,
            axis_for(x, diagram.logarithmic_x),
            axis_for(y, diagram.logarithmic_y)};
}

/// @param anchor 0 left, 0.5 middle, 1 right end of the label at x
void write_value(cairo_t* pen, const Axis& axis, double value, double x, double y, double anchor)
{
    drawing::use(pen, ink);
    if (axis.logarithmic)
        return drawing::write_power(pen, static_cast<int>(std::lround(std::log10(value))), x, y, anchor);
    const bool is_zero = std::abs(value) < 1e-9 * (axis.high - axis.low);
    drawing::font(pen, 12);
    drawing::write(pen, fmt::format("{:.6g}", is_zero ? 0 : value), x, y, anchor);
}

void draw_grid_of_x(cairo_t* pen, const Panel& panel)
{
    const double bottom = panel.top + panel.height;
    for (const Tick& tick : ticks_of(panel.x)) {
        const double x = panel.at_x(tick.value);
        drawing::use(pen, faint_ink);
        drawing::line(pen, x, bottom, x, bottom + (tick.is_labelled ? 5 : 3));
        if (!tick.is_labelled) continue;
        drawing::use(pen, grid_ink);
        drawing::line(pen, x, panel.top, x, bottom);
        write_value(pen, panel.x, tick.value, x, bottom + 21, 0.5);
    }
}

void draw_grid_of_y(cairo_t* pen, const Panel& panel)
{
    for (const Tick& tick : ticks_of(panel.y)) {
        if (!tick.is_labelled) continue;
        const double y = panel.at_y(tick.value);
        drawing::use(pen, grid_ink);
        drawing::line(pen, panel.left, y, panel.left + panel.width, y);
        drawing::use(pen, faint_ink);
        drawing::line(pen, panel.left - 5, y, panel.left, y);
        write_value(pen, panel.y, tick.value, panel.left - 9, y + 4.5, 1);
    }
}

void draw_frame(cairo_t* pen, const Diagram& diagram, const Panel& panel)
{
    drawing::use(pen, faint_ink);
    cairo_set_line_width(pen, 1.2);
    cairo_rectangle(pen, panel.left, panel.top, panel.width, panel.height);
    cairo_stroke(pen);
    drawing::use(pen, ink);
    drawing::font(pen, 13);
    drawing::write(pen, diagram.x_title, panel.left + panel.width / 2, panel.top + panel.height + 45, 0.5);
    cairo_save(pen);
    cairo_translate(pen, panel.left - 50, panel.top + panel.height / 2);
    cairo_rotate(pen, -1.5707963267948966);
    drawing::write(pen, diagram.y_title, 0, 0, 0.5);
    cairo_restore(pen);
}

void draw_levels(cairo_t* pen, const Diagram& diagram, const Panel& panel)
{
    const double dash[] = {7, 4};
    cairo_set_line_width(pen, 1.5);
    for (const Level& level : diagram.levels) {
        const double y = panel.at_y(level.y);
        drawing::use(pen, level.tolerance ? tolerance_ink : paper_ink);
        cairo_set_dash(pen, dash, 2, 0);
        drawing::line(pen, panel.left, y, panel.left + panel.width, y);
        cairo_set_dash(pen, nullptr, 0, 0);
        drawing::font(pen, 11);
        const double below = y < panel.top + 16 ? y + 13 : y - 5;
        drawing::write_on_white(pen, level.name, panel.left + panel.width - 6, below);
    }
}

/// How a curve is told from the others.
struct Style {
    std::string name;
    bool is_reference = false, has_marks = true;
    std::size_t number = 0;  // among those that are no references
};

void use(cairo_t* pen, const Style& style)
{
    drawing::use(pen, style.is_reference ? reference_ink : palette[style.number % std::size(palette)]);
    cairo_set_line_width(pen, style.is_reference ? 5 : 1.8);
}

void draw_curve(cairo_t* pen, const Curve& curve, const Style& style, const Panel& panel)
{
    use(pen, style);
    cairo_new_path(pen);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        cairo_line_to(pen, panel.at_x(curve.x[i]), panel.at_y(curve.y[i]));
    cairo_stroke(pen);
    if (!style.has_marks) return;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        use(pen, style);
        drawing::mark(pen, style.number, panel.at_x(curve.x[i]), panel.at_y(curve.y[i]));
    }
}

std::vector<Style> styles_of(const Figure& figure)
{
    std::vector<Style> styles;
    std::size_t number = 0;
    for (const Diagram& diagram : figure.diagrams)
        for (const Curve& curve : diagram.curves) {
            const auto same = [&](const Style& style) { return style.name == curve.name; };
            if (std::any_of(styles.begin(), styles.end(), same)) continue;
            styles.push_back({curve.name, curve.is_reference, diagram.marks && !curve.is_reference, number});
            if (!curve.is_reference) ++number;
        }
    return styles;
}

void draw_curves(cairo_t* pen, const Diagram& diagram, const std::vector<Style>& styles, const Panel& panel)
{
    for (const bool references : {true, false})
        for (const Curve& curve : diagram.curves) {
            if (curve.is_reference != references) continue;
            const auto style = std::find_if(styles.begin(), styles.end(),
                                            [&](const Style& each) { return each.name == curve.name; });
            draw_curve(pen, curve, *style, panel);
        }
}

void draw_legend(cairo_t* pen, const Figure& figure, const std::vector<Style>& styles, std::size_t columns,
                 double top)
{
    double y = top;
    for (std::size_t i = 0; i < styles.size(); ++i) {
        const double x = axis_left + legend_width * static_cast<double>(i % columns);
        use(pen, styles[i]);
        drawing::line(pen, x, y - 4, x + 28, y - 4);
        if (styles[i].has_marks) drawing::mark(pen, styles[i].number, x + 14, y - 4);
        drawing::use(pen, ink);
        drawing::font(pen, 12);
        drawing::write(pen, styles[i].name, x + 36, y);
        if (i % columns == columns - 1 || i + 1 == styles.size()) y += legend_line;
    }
    drawing::use(pen, paper_ink);
    drawing::font(pen, 11);
    for (const std::string& note : figure.notes) {
        drawing::write(pen, note, axis_left, y);
        y += note_line;
    }
}

/// A title too long for the picture is drawn smaller.
void write_head(cairo_t* pen, const Figure& figure, double width)
{
    drawing::font(pen, 17, true);
    const double room = width - axis_left - axis_right;
    drawing::font(pen, 17 * std::clamp(room / std::max(drawing::width_of(pen, figure.title), 1.0), 0.55, 1.0),
                  true);
    drawing::use(pen, ink);
    drawing::write(pen, figure.title, axis_left, 32);
    drawing::font(pen, 12);
    drawing::use(pen, faint_ink);
    drawing::write(pen, figure.subtitle, axis_left, 54);
}

}  // namespace

void draw_figure(const Figure& figure, const std::filesystem::path& file)
{
    const std::vector<Style> styles = styles_of(figure);
    const Sheet sheet = sheet_of(figure);
    const auto columns =
        static_cast<std::size_t>(std::max(1.0, std::floor((sheet.width - axis_left) / legend_width)));
    const double lines = legend_line * static_cast<double>((styles.size() + columns - 1) / columns);
    const double height =
        head + sheet.panels_height + 16 + lines + note_line * static_cast<double>(figure.notes.size());
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(sharpness * sheet.width),
                                                     static_cast<int>(sharpness * height)),
                          &cairo_surface_destroy);
    {
        const Pen pen(cairo_create(surface.get()), &cairo_destroy);
        cairo_scale(pen.get(), sharpness, sharpness);
        cairo_set_source_rgb(pen.get(), 1, 1, 1);
        cairo_paint(pen.get());
        cairo_set_line_join(pen.get(), CAIRO_LINE_JOIN_ROUND);
        write_head(pen.get(), figure, sheet.width);
        for (std::size_t i = 0; i < figure.diagrams.size(); ++i) {
            const Diagram& diagram = figure.diagrams[i];
            const Panel panel = place(diagram, figure, sheet, i);
            cairo_set_line_width(pen.get(), 1);
            draw_grid_of_x(pen.get(), panel);
            draw_grid_of_y(pen.get(), panel);
            draw_curves(pen.get(), diagram, styles, panel);
            draw_levels(pen.get(), diagram, panel);
            draw_frame(pen.get(), diagram, panel);
        }
        draw_legend(pen.get(), figure, styles, columns, head + sheet.panels_height + 8);
    }
    drawing::write_png(surface.get(), file);
}

}  // namespace voussoir::app::plots
