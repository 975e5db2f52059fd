#include "app/render/canvas.h"

#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string>

#include "libdda/errors.h"

namespace voussoir::app::render
{

namespace
{

/// The library keeps lists of its contexts that it does not lock.
std::mutex& lists_of_the_library()
{
    static std::mutex mutex;
    return mutex;
}

/// Averages each square of samples; colours come out premultiplied by the share that was covered. Two channels at
/// a time, each in sixteen bits.
Image averaged(const std::vector<std::uint32_t>& samples, int width, int height)
{
    static_assert(Canvas::supersampling == 2);
    constexpr std::uint32_t even = 0x00FF00FFU, half = 0x00020002U;
    Image image{width, height, std::vector<std::uint32_t>(static_cast<std::size_t>(width) * height)};
    const std::size_t row_samples = 2 * static_cast<std::size_t>(width);
    for (int y = 0; y < height; ++y) {
        const std::uint32_t* upper = samples.data() + 2 * static_cast<std::size_t>(y) * row_samples;
        const std::uint32_t* lower = upper + row_samples;
        std::uint32_t* row = image.pixels.data() + static_cast<std::size_t>(y) * width;
        for (int x = 0; x < width; ++x) {
            const std::uint32_t a = upper[2 * x], b = upper[2 * x + 1], c = lower[2 * x], d = lower[2 * x + 1];
            const std::uint32_t low = (a & even) + (b & even) + (c & even) + (d & even) + half;
            const std::uint32_t high =
                (a >> 8U & even) + (b >> 8U & even) + (c >> 8U & even) + (d >> 8U & even) + half;
            row[x] = (low >> 2U & even) | (high >> 2U & even) << 8U;
        }
    }
    return image;
}

}  // namespace

struct Canvas::Context {
    OSMesaContext context = nullptr;
    int width = 0, height = 0;           // of the picture
    std::vector<std::uint32_t> samples;  // 0xAARRGGBB, supersampled
};

Canvas::Canvas(int width, int height) : context_(std::make_unique<Context>())
{
    const std::lock_guard<std::mutex> lock(lists_of_the_library());
    const std::array<int, 7> wishes = {
        OSMESA_FORMAT, OSMESA_BGRA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    context_->context = OSMesaCreateContextAttribs(wishes.data(), nullptr);
    const int w = width * supersampling, h = height * supersampling;
    context_->width = width;
    context_->height = height;
    context_->samples.resize(static_cast<std::size_t>(w) * h);
    if (context_->context == nullptr ||
        OSMesaMakeCurrent(context_->context, context_->samples.data(), GL_UNSIGNED_BYTE, w, h) == GL_FALSE) {
        throw InputError("size", std::to_string(width) + "x" + std::to_string(height),
                         "the off-screen renderer cannot draw a picture of this size: give a smaller one");
    }
    OSMesaPixelStore(OSMESA_Y_UP, 0);
}

Canvas::~Canvas()
{
    const std::lock_guard<std::mutex> lock(lists_of_the_library());
    if (context_->context != nullptr) OSMesaDestroyContext(context_->context);
}

void Canvas::clear(const Camera& camera)
{
    glViewport(0, 0, context_->width * supersampling, context_->height * supersampling);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(camera.view_projection.data());
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glShadeModel(GL_SMOOTH);
}

int Canvas::width() const
{
    return context_->width * supersampling;
}

int Canvas::height() const
{
    return context_->height * supersampling;
}

Image Canvas::image() const
{
    glFinish();
    return averaged(context_->samples, context_->width, context_->height);
}

Depths Canvas::depths() const
{
    Depths depths;
    depths.width = (context_->width + Depths::cell - 1) / Depths::cell;
    depths.height = (context_->height + Depths::cell - 1) / Depths::cell;
    depths.values.resize(static_cast<std::size_t>(depths.width) * depths.height);
    constexpr int every = Depths::cell * supersampling;
    std::vector<float> row(static_cast<std::size_t>(width()));
    for (int y = 0; y < depths.height; ++y) {  // the library counts rows from below
        const int down = std::min(every * y + every / 2, height() - 1);
        glReadPixels(0, height() - 1 - down, width(), 1, GL_DEPTH_COMPONENT, GL_FLOAT, row.data());
        for (int x = 0; x < depths.width; ++x)
            depths.values[static_cast<std::size_t>(y) * depths.width + x] =
                row[static_cast<std::size_t>(std::min(every * x + every / 2, width() - 1))];
    }
    return depths;
}

}  // namespace voussoir::app::render
