// The finished picture: background, drawing, title, colour bar, legend; written as PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/render/drawing.h"

namespace voussoir::app::render
{

/// The ground's acceleration over the time of a run, with a mark at the time that is shown.
struct MotionStrip {
    std::vector<double> times, values;  // s of the run, m/s2
    std::string label;                  // what is drawn
    double now = 0, end = 1;            // s; end: as planned
};

/// A word on the drawing. @param x, y from 0 (left, top) to 1
struct PlacedWord {
    std::string text;
    double x = 0, y = 0;
};

struct PageText {
    std::string title;
    std::string subtitle;            // "t = 1.250 s, earthquake"
    std::vector<std::string> notes;  // lines at the lower right
    std::string opened, slid;        // legend of the marks
    bool foundations = false;        // grey blocks are explained
    std::string blank;               // what is explained of stones without a value
    std::vector<PlacedWord> labels;
    std::string alarm;  // in red above the legend: that the run ended early
};

/// The part of a picture that is free for the drawing. @param strip with room for a strip below it
PictureArea drawing_area(int width, int height, bool strip = false);

/// Pixels in one logical pixel: the layout is made for a height of 900.
double logical_pixel(int width, int height);

/// @throws InputError when the file cannot be written
void write_page(const Image& drawing, const drawing::ColorScale& scale, const PageText& text,
                const std::filesystem::path& path);

/// The same as pixels, 0xXXRRGGBB, rows from the top. @param strip may be absent
std::vector<std::uint32_t> page_pixels(const Image& drawing, const drawing::ColorScale& scale,
                                       const PageText& text, const MotionStrip* strip);

}  // namespace voussoir::app::render
