// The finished picture: background, drawing, title, colour bar, legend; written as PNG.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/render/drawing.h"

namespace voussoir::app::render
{

struct PageText {
    std::string title;
    std::string subtitle;            // "t = 1.250 s, earthquake"
    std::vector<std::string> notes;  // lines at the lower right
    std::string opened, slid;        // legend of the marks
    bool foundations = false;        // grey blocks are explained
};

/// The part of a picture that is free for the drawing.
PictureArea drawing_area(int width, int height);

/// Pixels in one logical pixel: the layout is made for a height of 900.
double logical_pixel(int width, int height);

/// @throws InputError when the file cannot be written
void write_page(const Image& drawing, const drawing::ColorScale& scale, const PageText& text,
                const std::filesystem::path& path);

}  // namespace voussoir::app::render
