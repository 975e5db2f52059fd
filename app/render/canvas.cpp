#include "app/render/canvas.h"

#include <GL/osmesa.h>

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

/// Averages each square of samples; colours come out premultiplied by the share that was covered.
Image averaged(const std::vector<std::uint32_t>& samples, int width, int height)
{
    Image image{width, height, std::vector<std::uint32_t>(static_cast<std::size_t>(width) * height)};
    const int row_samples = width * Canvas::supersampling;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint32_t pixel = 0;
            for (int shift = 0; shift < 32; shift += 8) {
                std::uint32_t sum = 0;
                for (int k = 0; k < Canvas::supersampling * Canvas::supersampling; ++k) {
                    const int sx = x * Canvas::supersampling + k % Canvas::supersampling,
                              sy = y * Canvas::supersampling + k / Canvas::supersampling;
                    sum += samples[static_cast<std::size_t>(sy) * row_samples + sx] >> shift & 0xFFU;
                }
                pixel |= (sum + 2) / (Canvas::supersampling * Canvas::supersampling) << shift;
            }
            image.pixels[static_cast<std::size_t>(y) * width + x] = pixel;
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

}  // namespace voussoir::app::render
