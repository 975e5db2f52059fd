// A sheet of paper with a drawing on it, and a pen for words.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/drawing/color_map.h"
#include "app/render/canvas.h"

struct _cairo;  // the library's own names, so that its header stays out of ours
struct _cairo_surface;

namespace voussoir::app::render
{

class Sheet
{
 public:
    /// Background and drawing. @param pixel pixels in one logical pixel, the unit of all lengths on the sheet
    Sheet(const Image& drawing, double pixel);
    ~Sheet();
    Sheet(const Sheet&) = delete;
    Sheet& operator=(const Sheet&) = delete;

    _cairo* pen = nullptr;
    double width = 0, height = 0;  // logical pixels

    /// As PNG. @throws InputError when the file cannot be written
    void write(const std::filesystem::path& path) const;
    /// 0xXXRRGGBB, rows from the top.
    std::vector<std::uint32_t> pixels() const;

 private:
    _cairo_surface* surface_ = nullptr;
};

extern const drawing::Rgb ink, faint_ink;

/// Title and subtitle at the upper left. A title too long for the sheet is written smaller, down to two thirds.
void write_head(const Sheet& sheet, const std::string& title, const std::string& subtitle, double margin);

/// A colour, as a line or an area, and what it means. @returns where the next entry starts
double legend_entry(_cairo* pen, const std::string& words, const drawing::Rgb& color, bool area, double x,
                    double y);

}  // namespace voussoir::app::render
