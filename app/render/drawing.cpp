#include "app/render/drawing.h"

#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <string>

#include "libdda/errors.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

constexpr int supersampling = 2;

/// Two lights, one over the viewer's left shoulder and a weak one from the right, and light from everywhere.
struct Lights {
    Vector3d main, fill;  // unit, towards the light
};

float brightness(const Vector3d& normal, const Lights& lights)
{
    const double light =
        0.56 + 0.40 * std::max(0.0, normal.dot(lights.main)) + 0.10 * std::max(0.0, normal.dot(lights.fill));
    return static_cast<float>(std::min(light, 1.0));
}

void load_color_map()
{
    std::array<float, 3 * 256> colors{};
    for (int i = 0; i < 256; ++i) {
        const Rgb color = viridis(static_cast<float>(i) / 255);
        std::copy(color.data(), color.data() + 3, colors.begin() + 3 * i);
    }
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB8, 256, 0, GL_RGB, GL_FLOAT, colors.data());
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

void draw_triangles(const Scene& scene, bool foundations, const Lights& lights, const ColorScale& scale)
{
    const Rgb base = foundations ? foundation_color() : Rgb::Ones();
    glBegin(GL_TRIANGLES);
    for (const Triangle& triangle : scene.triangles) {
        if (triangle.foundation != foundations) continue;
        const Rgb color = base * brightness(triangle.normal, lights);
        glColor3fv(color.data());
        for (int corner = 0; corner < 3; ++corner) {
            glTexCoord1f(scale.share(triangle.values[corner]));
            glVertex3dv(triangle.corners[corner].data());
        }
    }
    glEnd();
}

void draw_lines(const std::vector<Segment>& lines, const Rgb& color, double width)
{
    glLineWidth(static_cast<float>(width));
    glColor3fv(color.data());
    glBegin(GL_LINES);
    for (const Segment& line : lines) {
        glVertex3dv(line.from.data());
        glVertex3dv(line.to.data());
    }
    glEnd();
}

/// Averages each square of samples; colours come out premultiplied by the share that was covered.
Image averaged(const std::vector<std::uint32_t>& samples, int width, int height)
{
    Image image{width, height, std::vector<std::uint32_t>(static_cast<std::size_t>(width) * height)};
    const int row_samples = width * supersampling;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint32_t pixel = 0;
            for (int shift = 0; shift < 32; shift += 8) {
                std::uint32_t sum = 0;
                for (int k = 0; k < supersampling * supersampling; ++k) {
                    const int sx = x * supersampling + k % supersampling,
                              sy = y * supersampling + k / supersampling;
                    sum += samples[static_cast<std::size_t>(sy) * row_samples + sx] >> shift & 0xFFU;
                }
                pixel |= (sum + 2) / (supersampling * supersampling) << shift;
            }
            image.pixels[static_cast<std::size_t>(y) * width + x] = pixel;
        }
    }
    return image;
}

}  // namespace

Rgb opened_color()
{
    return {0.86F, 0.08F, 0.10F};
}

Rgb slid_color()
{
    return {1.0F, 0.55F, 0.0F};
}

Rgb foundation_color()
{
    return {0.76F, 0.76F, 0.77F};
}

struct Drawing::Context {
    OSMesaContext context = nullptr;
    int width = 0, height = 0;           // of the picture
    std::vector<std::uint32_t> samples;  // 0xAARRGGBB, supersampled
};

Drawing::Drawing(int width, int height) : context_(std::make_unique<Context>())
{
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
                         "the off-screen renderer cannot make such a picture: give a smaller one");
    }
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    load_color_map();
}

Drawing::~Drawing()
{
    if (context_->context != nullptr) OSMesaDestroyContext(context_->context);
}

Image Drawing::draw(const Scene& scene, const Camera& camera, const ColorScale& scale, double pixel)
{
    const Lights lights{(-0.55 * camera.right + 0.70 * camera.up + 0.75 * camera.back).normalized(),
                        (0.9 * camera.right + 0.1 * camera.up + 0.4 * camera.back).normalized()};
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

    glEnable(GL_POLYGON_OFFSET_FILL);  // faces step back a little, so that lines on them are seen
    glPolygonOffset(1.5F, 2);
    draw_triangles(scene, true, lights, scale);
    glEnable(GL_TEXTURE_1D);
    draw_triangles(scene, false, lights, scale);
    glDisable(GL_TEXTURE_1D);
    glDisable(GL_POLYGON_OFFSET_FILL);

    const double stroke = pixel * supersampling;
    const double fine = scene.edges.size() > 20000 ? 0.6 : 1.1;
    draw_lines(scene.edges, {0.10F, 0.11F, 0.14F}, std::max(1.0, fine * stroke));
    glDepthRange(0, 0.99995);  // marks in front of the edges they follow
    draw_lines(scene.slid, slid_color(), 3 * stroke);
    draw_lines(scene.opened, opened_color(), 3 * stroke);
    glDepthRange(0, 1);
    glFinish();
    return averaged(context_->samples, context_->width, context_->height);
}

}  // namespace voussoir
