// Where OpenGL draws: off-screen, by software.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "app/render/camera.h"

namespace voussoir::app::render
{

/// Pixels as 0xAARRGGBB with premultiplied alpha, rows from the top; transparent where nothing was drawn.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};

/// How deep in the view what was drawn lies, at the middles of cells of `cell` x `cell` pixels.
struct Depths {
    static constexpr int cell = 2;
    int width = 0, height = 0;  // cells
    std::vector<float> values;  // (height x width) 0 near to 1 far or nothing, rows from the top
};

/// A software OpenGL context of one size, drawn at twice the resolution and averaged. While one exists no other
/// may be made in the same thread.
class Canvas
{
 public:
    static constexpr int supersampling = 2;

    /// @throws InputError when the size is too large for the library
    Canvas(int width, int height);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// Wipes the canvas and looks through the camera; depth test on.
    void clear(const Camera& camera);

    /// In samples.
    int width() const;
    int height() const;

    /// What has been drawn.
    Image image() const;
    Depths depths() const;

 private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace voussoir::app::render
