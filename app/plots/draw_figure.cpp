#include "app/plots/draw_figure.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app/plots/pen.h"
#include "libdda/errors.h"

namespace voussoir
{
namespace
{

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr Color ink{0.13, 0.14, 0.17}, faint_ink{0.42, 0.44, 0.48}, grid_ink{0.91, 0.92, 0.94};
constexpr Color tolerance_ink{0.10, 0.45, 0.25}, paper_ink{0.75, 0.22, 0.17};
// Okabe and Ito's colours: told apart by the colour-blind.
constexpr Color palette[] = {{0.00, 0.45, 0.70}, {0.90, 0.62, 0.00}, {0.00, 0.62, 0.45},
                             {0.80, 0.47, 0.65}, {0.34, 0.71, 0.91}, {0.84, 0.37, 0.00}};

// Logical pixels; the picture has `sharpness` pixels to each.
constexpr double sharpness = 2, panel_width = 430, panel_height = 330, head = 74, foot = 60;
constexpr double axis_left = 66, axis_right = 20, legend_line = 18, note_line = 15;

/// The logarithms an axis runs over.
struct Decades {
    double low = 0, high = 1;
    double share(double value) const { return (std::log10(value) - low) / (high - low); }
    int first() const { return static_cast<int>(std::ceil(low)); }
    int last() const { return static_cast<int>(std::floor(high)); }
};

/// Where a diagram lies in the picture.
struct Panel {
    double left, top, width, height;
    Decades x, y;
    double at_x(double value) const { return left + width * x.share(value); }
    double at_y(double value) const { return top + height * (1 - y.share(value)); }
};

/// Room for all values with a margin, and for at least two decades' ticks.
Decades decades_of(const std::vector<double>& values)
{
    if (values.empty()) return {};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    Decades decades{std::log10(*least), std::log10(*most)};
    const double margin = 0.06 * std::max(decades.high - decades.low, 1.0);
    decades.low -= margin;
    decades.high += margin;
    if (decades.last() > decades.first()) return decades;
    return {std::floor(decades.low), std::ceil(decades.high)};
}

Panel place(const Diagram& diagram, double left)
{
    std::vector<double> x, y;
    for (const Curve& curve : diagram.curves) {
        x.insert(x.end(), curve.x.begin(), curve.x.end());
        y.insert(y.end(), curve.y.begin(), curve.y.end());
    }
    for (const Level& level : diagram.levels) y.push_back(level.y);
    return {left + axis_left, head,          panel_width - axis_left - axis_right,
            panel_height,     decades_of(x), decades_of(y)};
}

void draw_grid_of_x(cairo_t* pen, const Panel& panel)
{
    const double bottom = panel.top + panel.height;
    for (int power = panel.x.first() - 1; power <= panel.x.last(); ++power) {
        use(pen, faint_ink);
        for (int i = 1; i < 10; ++i) {
            const double share = panel.x.share(i * std::pow(10.0, power)), x = panel.left + panel.width * share;
            if (share >= 0 && share <= 1) line(pen, x, bottom, x, bottom + (i == 1 ? 5 : 3));
        }
        if (power < panel.x.first()) continue;
        const double x = panel.at_x(std::pow(10.0, power));
        use(pen, grid_ink);
        line(pen, x, panel.top, x, bottom);
        use(pen, ink);
        write_power(pen, power, x, bottom + 21, 0.5);
    }
}

void draw_grid_of_y(cairo_t* pen, const Panel& panel)
{
    const int skip = panel.y.last() - panel.y.first() > 9 ? 2 : 1;
    for (int power = panel.y.first(); power <= panel.y.last(); ++power) {
        const double y = panel.at_y(std::pow(10.0, power));
        use(pen, grid_ink);
        line(pen, panel.left, y, panel.left + panel.width, y);
        use(pen, faint_ink);
        line(pen, panel.left - 5, y, panel.left, y);
        use(pen, ink);
        if ((power - panel.y.first()) % skip == 0) write_power(pen, power, panel.left - 9, y + 4.5, 1);
    }
}

void draw_frame(cairo_t* pen, const Diagram& diagram, const Panel& panel)
{
    use(pen, faint_ink);
    cairo_set_line_width(pen, 1.2);
    cairo_rectangle(pen, panel.left, panel.top, panel.width, panel.height);
    cairo_stroke(pen);
    use(pen, ink);
    font(pen, 13);
    write(pen, diagram.x_title, panel.left + panel.width / 2, panel.top + panel.height + 45, 0.5);
    cairo_save(pen);
    cairo_translate(pen, panel.left - 50, panel.top + panel.height / 2);
    cairo_rotate(pen, -1.5707963267948966);
    write(pen, diagram.y_title, 0, 0, 0.5);
    cairo_restore(pen);
}

void draw_levels(cairo_t* pen, const Diagram& diagram, const Panel& panel)
{
    const double dash[] = {7, 4};
    cairo_set_line_width(pen, 1.5);
    for (const Level& level : diagram.levels) {
        const double y = panel.at_y(level.y);
        use(pen, level.tolerance ? tolerance_ink : paper_ink);
        cairo_set_dash(pen, dash, 2, 0);
        line(pen, panel.left, y, panel.left + panel.width, y);
        cairo_set_dash(pen, nullptr, 0, 0);
        font(pen, 11);
        const double below = y < panel.top + 16 ? y + 13 : y - 5;
        write_on_white(pen, level.name, panel.left + panel.width - 6, below);
    }
}

void draw_curve(cairo_t* pen, const Curve& curve, std::size_t number, const Panel& panel)
{
    const Color& color = palette[number % std::size(palette)];
    use(pen, color, 0.9);
    cairo_set_line_width(pen, 1.8);
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        points.emplace_back(panel.at_x(curve.x[i]), panel.at_y(curve.y[i]));
    cairo_new_path(pen);
    for (const auto& [x, y] : points) cairo_line_to(pen, x, y);
    cairo_stroke(pen);
    for (const auto& [x, y] : points) {
        use(pen, color);
        mark(pen, number, x, y);
    }
}

std::vector<std::string> legend_of(const Figure& figure)
{
    std::vector<std::string> names;
    for (const Diagram& diagram : figure.diagrams)
        for (const Curve& curve : diagram.curves)
            if (std::find(names.begin(), names.end(), curve.name) == names.end()) names.push_back(curve.name);
    return names;
}

void draw_legend(cairo_t* pen, const Figure& figure, const std::vector<std::string>& names, double top)
{
    double y = top;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double x = axis_left + (i % 2 == 0 ? 0 : 380);
        use(pen, palette[i % std::size(palette)]);
        cairo_set_line_width(pen, 1.8);
        line(pen, x, y - 4, x + 28, y - 4);
        mark(pen, i, x + 14, y - 4);
        use(pen, ink);
        font(pen, 12);
        write(pen, names[i], x + 36, y);
        if (i % 2 == 1 || i + 1 == names.size()) y += legend_line;
    }
    use(pen, paper_ink);
    font(pen, 11);
    for (const std::string& note : figure.notes) {
        write(pen, note, axis_left, y);
        y += note_line;
    }
}

/// A title too long for the picture is drawn smaller.
void write_head(cairo_t* pen, const Figure& figure, double width)
{
    font(pen, 17, true);
    const double room = width - axis_left - axis_right;
    font(pen, 17 * std::clamp(room / std::max(width_of(pen, figure.title), 1.0), 0.55, 1.0), true);
    use(pen, ink);
    write(pen, figure.title, axis_left, 32);
    font(pen, 12);
    use(pen, faint_ink);
    write(pen, figure.subtitle, axis_left, 54);
}

}  // namespace

void draw_figure(const Figure& figure, const std::filesystem::path& file)
{
    const std::vector<std::string> names = legend_of(figure);
    const double width = panel_width * static_cast<double>(figure.diagrams.size());
    const double lines = legend_line * static_cast<double>((names.size() + 1) / 2);
    const double height =
        head + panel_height + foot + 16 + lines + note_line * static_cast<double>(figure.notes.size());
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(sharpness * width),
                                                     static_cast<int>(sharpness * height)),
                          &cairo_surface_destroy);
    {
        const Pen pen(cairo_create(surface.get()), &cairo_destroy);
        cairo_scale(pen.get(), sharpness, sharpness);
        cairo_set_source_rgb(pen.get(), 1, 1, 1);
        cairo_paint(pen.get());
        cairo_set_line_join(pen.get(), CAIRO_LINE_JOIN_ROUND);
        write_head(pen.get(), figure, width);
        for (std::size_t i = 0; i < figure.diagrams.size(); ++i) {
            const Diagram& diagram = figure.diagrams[i];
            const Panel panel = place(diagram, panel_width * static_cast<double>(i));
            cairo_set_line_width(pen.get(), 1);
            draw_grid_of_x(pen.get(), panel);
            draw_grid_of_y(pen.get(), panel);
            for (const Curve& curve : diagram.curves) {
                const auto number = std::find(names.begin(), names.end(), curve.name) - names.begin();
                draw_curve(pen.get(), curve, static_cast<std::size_t>(number), panel);
            }
            draw_levels(pen.get(), diagram, panel);
            draw_frame(pen.get(), diagram, panel);
        }
        draw_legend(pen.get(), figure, names, head + panel_height + foot + 8);
    }
    const cairo_status_t status = cairo_surface_write_to_png(surface.get(), file.c_str());
    if (status != CAIRO_STATUS_SUCCESS)
        throw InputError(file.string(), std::string("cannot be written: ") + cairo_status_to_string(status),
                         "give a folder that can be written on a disk with room");
}

}  // namespace voussoir
