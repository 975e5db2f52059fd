#include "app/render/defect_page.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>

#include "app/drawing/pen.h"
#include "app/render/defect_colors.h"
#include "app/render/defect_drawing.h"
#include "app/render/defect_view.h"
#include "app/render/page.h"
#include "app/render/sheet.h"

namespace voussoir::app::render
{

namespace
{

using Eigen::Vector2d;
using Eigen::Vector3d;

// Logical pixels of a picture 900 high.
constexpr double margin = 40, head = 104, foot = 190, column = 215, line = 21;
constexpr std::size_t max_callouts = 10;
constexpr double smallest_mark = 26;  // smaller marks get a ring

struct Callout {
    std::string words;
    drawing::Rgb color;
    Vector2d anchor, low, high;  // of the mark on the sheet
};

Vector2d on_sheet(const Vector3d& x, const Camera& camera, const Sheet& sheet)
{
    const Eigen::Vector4d clip = camera.view_projection * x.homogeneous();
    return {(clip.x() / clip.w() + 1) / 2 * sheet.width, (1 - clip.y() / clip.w()) / 2 * sheet.height};
}

/// The callout of a mark points at the sample nearest to the middle of all.
Callout callout_of(const PictureMark& mark, const Camera& camera, const Sheet& sheet)
{
    Callout callout{
        mark.feature.label, color_of(mark.look), {}, Vector2d::Constant(1e9), Vector2d::Constant(-1e9)};
    std::vector<Vector2d> samples;
    for (const Vector3d& x : samples_of(mark.feature)) {
        samples.push_back(on_sheet(x, camera, sheet));
        callout.low = callout.low.cwiseMin(samples.back());
        callout.high = callout.high.cwiseMax(samples.back());
    }
    const Vector2d middle = (callout.low + callout.high) / 2;
    callout.anchor = *std::min_element(samples.begin(), samples.end(), [&](const Vector2d& a, const Vector2d& b) {
        return (a - middle).norm() < (b - middle).norm();
    });
    return callout;
}

std::vector<std::string> wrapped(cairo_t* pen, const std::string& text, double width)
{
    std::vector<std::string> lines(1);
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        const std::string word = text.substr(start, end - start);
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (!lines.back().empty() && drawing::width_of(pen, longer) > width)
            lines.push_back(word);
        else
            lines.back() = longer;
        start = end + 1;
    }
    return lines;
}

void draw_callout(const Sheet& sheet, const Callout& callout, const std::vector<std::string>& lines, double x,
                  double y, bool left)
{
    cairo_t* pen = sheet.pen;
    double width = 0;
    for (const std::string& words : lines) width = std::max(width, drawing::width_of(pen, words));
    const double height = line * static_cast<double>(lines.size()) + 8, edge = left ? x + width + 16 : x;
    drawing::use(pen, callout.color);
    cairo_set_line_width(pen, 1.6);
    cairo_move_to(pen, edge, y + height / 2);
    cairo_line_to(pen, callout.anchor.x(), callout.anchor.y());
    cairo_stroke(pen);
    cairo_arc(pen, callout.anchor.x(), callout.anchor.y(), 3.5, 0, 6.2831853);
    cairo_fill(pen);
    const double extent = (callout.high - callout.low).maxCoeff();
    if (extent < smallest_mark) {
        const Vector2d middle = (callout.low + callout.high) / 2;
        cairo_arc(pen, middle.x(), middle.y(), smallest_mark / 2 + 4, 0, 6.2831853);
        cairo_stroke(pen);
    }
    cairo_rectangle(pen, x, y, width + 16, height);
    cairo_set_source_rgba(pen, 1, 1, 1, 0.94);
    cairo_fill_preserve(pen);
    drawing::use(pen, callout.color);
    cairo_stroke(pen);
    drawing::use(pen, ink);
    for (std::size_t i = 0; i < lines.size(); ++i)
        drawing::write(pen, lines[i], x + 8, y + line * static_cast<double>(i + 1) - 2);
}

/// One column of callouts, in the order of their marks from top to bottom, none over another.
void draw_column(const Sheet& sheet, std::vector<Callout> callouts, bool left)
{
    std::sort(callouts.begin(), callouts.end(),
              [](const Callout& a, const Callout& b) { return a.anchor.y() < b.anchor.y(); });
    std::vector<std::vector<std::string>> lines;
    double needed = 0;
    for (const Callout& callout : callouts) {
        lines.push_back(wrapped(sheet.pen, callout.words, column - margin - 24));
        needed += line * static_cast<double>(lines.back().size()) + 22;
    }
    double top = head + 6;
    for (std::size_t i = 0; i < callouts.size(); ++i) {
        const double height = line * static_cast<double>(lines[i].size()) + 8;
        const double last = std::max(sheet.height - foot - needed, top);
        const double y = std::clamp(callouts[i].anchor.y() - height / 2, top, last);
        const double x = left ? margin : sheet.width - column + 8;
        draw_callout(sheet, callouts[i], lines[i], x, y, left);
        top = y + height + 14;
        needed -= height + 14;
    }
}

void draw_callouts(const Sheet& sheet, const DefectPicture& picture, const Camera& camera)
{
    std::vector<Callout> left, right;
    for (const PictureMark& mark : picture.marks) {
        if (mark.feature.label.empty() || samples_of(mark.feature).empty()) continue;
        if (left.size() + right.size() == max_callouts) break;
        Callout callout = callout_of(mark, camera, sheet);
        const bool goes_left = callout.anchor.x() < sheet.width / 2 ? left.size() <= right.size() + 2
                                                                    : right.size() > left.size() + 2;
        (goes_left ? left : right).push_back(std::move(callout));
    }
    drawing::font(sheet.pen, 15);
    draw_column(sheet, std::move(left), true);
    draw_column(sheet, std::move(right), false);
}

void write_legend_and_notes(const Sheet& sheet, const DefectPicture& picture)
{
    cairo_t* pen = sheet.pen;
    drawing::font(pen, 15);
    double x = margin, y = sheet.height - foot + 40;
    for (const auto& [look, words] : picture.legend) {
        if (x + drawing::width_of(pen, words) + 80 > sheet.width) {
            x = margin;
            y += 26;
        }
        const LookColor color = color_of(look);  // as it looks over white
        const drawing::Rgb shown = color.opacity * color.color + (1 - color.opacity) * drawing::Rgb::Ones();
        x = legend_entry(pen, words, shown, true, x, y);
    }
    for (const auto& [look, words] : picture.mark_legend) {
        if (x + drawing::width_of(pen, words) + 80 > sheet.width) {
            x = margin;
            y += 26;
        }
        x = legend_entry(pen, words, color_of(look), false, x, y);
    }
    y += 32;
    drawing::use(pen, ink);
    for (const std::string& note : picture.notes)
        for (const std::string& words : wrapped(pen, note, sheet.width - 2 * margin)) {
            if (y > sheet.height - 8) return;
            drawing::write(pen, words, margin, y);
            y += line;
        }
}

}  // namespace

PictureArea defect_area(int width, int height)
{
    const double pixel = logical_pixel(width, height), w = width / pixel, h = height / pixel;
    return {-1 + 2 * column / w, 1 - 2 * column / w, -1 + 2 * foot / h, 1 - 2 * head / h};
}

void write_defect_page(const Image& drawing, const DefectPicture& picture, const Camera& camera,
                       const std::filesystem::path& path)
{
    const Sheet sheet(drawing, logical_pixel(drawing.width, drawing.height));
    write_head(sheet, picture.title, picture.subtitle, margin);
    draw_callouts(sheet, picture, camera);
    write_legend_and_notes(sheet, picture);
    sheet.write(path);
}

std::vector<std::filesystem::path> draw_defect_pages(const DefectPictures& pictures,
                                                     const std::filesystem::path& folder)
{
    const int width = pictures.width, height = pictures.height;
    const double aspect = static_cast<double>(width) / height;
    Canvas canvas(width, height);
    std::vector<std::filesystem::path> files;
    for (const DefectPicture& picture : pictures.pictures) {
        const std::vector<Vector3d> points = points_to_see(pictures.shapes, picture);
        if (points.empty()) continue;
        const PictureArea area = defect_area(width, height);
        const Camera camera = camera_from(points, area, aspect, best_direction(pictures.shapes, picture));
        const Image image =
            draw_defect(canvas, pictures.shapes, picture, camera, area, logical_pixel(width, height));
        files.push_back(folder / picture.name);
        write_defect_page(image, picture, camera, files.back());
    }
    return files;
}

}  // namespace voussoir::app::render
