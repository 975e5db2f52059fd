#include "app/render/drawing.h"

#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/render/crease_shade.h"

namespace voussoir::app::render
{

using Eigen::Vector3d;

namespace
{

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
        const drawing::Rgb color = drawing::viridis(static_cast<float>(i) / 255);
        std::copy(color.data(), color.data() + 3, colors.begin() + 3 * i);
    }
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB8, 256, 0, GL_RGB, GL_FLOAT, colors.data());
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

constexpr double crease_reach = 16;  // logical pixels that the shade of a crease reaches

/// What the colour of a face says.
enum class Paint { foundation, blank, value };

Paint paint_of(const Triangle& triangle)
{
    if (triangle.foundation) return Paint::foundation;
    return std::isnan(triangle.values[0]) ? Paint::blank : Paint::value;
}

drawing::Rgb base_of(Paint paint)
{
    if (paint == Paint::value) return drawing::Rgb::Ones();
    return paint == Paint::foundation ? foundation_color() : blank_color();
}

void draw_triangles(const Scene& scene, Paint paint, const Lights& lights, const drawing::ColorScale& scale)
{
    const drawing::Rgb base = base_of(paint);
    glBegin(GL_TRIANGLES);
    for (const Triangle& triangle : scene.triangles) {
        if (paint_of(triangle) != paint) continue;
        const drawing::Rgb color = base * brightness(triangle.normal, lights);
        glColor3fv(color.data());
        for (int corner = 0; corner < 3; ++corner) {
            glTexCoord1f(scale.share(triangle.values[corner]));
            glVertex3dv(triangle.corners[corner].data());
        }
    }
    glEnd();
}

/// So near 1 that nobody sees it: creases do not darken marks.
constexpr float mark_opacity = 254.0F / 255;

void draw_lines(const std::vector<Segment>& lines, const drawing::Rgb& color, double width)
{
    glLineWidth(static_cast<float>(width));
    glColor4f(color[0], color[1], color[2], mark_opacity);
    glBegin(GL_LINES);
    for (const Segment& line : lines) {
        glVertex3dv(line.from.data());
        glVertex3dv(line.to.data());
    }
    glEnd();
}

}  // namespace

drawing::Rgb opened_color()
{
    return {0.86F, 0.08F, 0.10F};
}

drawing::Rgb slid_color()
{
    return {1.0F, 0.55F, 0.0F};
}

drawing::Rgb force_color()
{
    return {0.08F, 0.35F, 0.95F};
}

drawing::Rgb blank_color()
{
    return {0.90F, 0.89F, 0.86F};
}

drawing::Rgb foundation_color()
{
    return {0.76F, 0.76F, 0.77F};
}

Drawing::Drawing(int width, int height) : canvas_(width, height)
{
    load_color_map();
}

Image Drawing::draw(const Scene& scene, const Camera& camera, const drawing::ColorScale& scale, double pixel)
{
    const Lights lights{(-0.55 * camera.right + 0.70 * camera.up + 0.75 * camera.back).normalized(),
                        (0.9 * camera.right + 0.1 * camera.up + 0.4 * camera.back).normalized()};
    canvas_.clear(camera);

    glEnable(GL_POLYGON_OFFSET_FILL);  // faces step back a little, so that lines on them are seen
    glPolygonOffset(1.5F, 2);
    draw_triangles(scene, Paint::foundation, lights, scale);
    if (scene.has_blank) draw_triangles(scene, Paint::blank, lights, scale);
    glEnable(GL_TEXTURE_1D);
    draw_triangles(scene, Paint::value, lights, scale);
    glDisable(GL_TEXTURE_1D);
    glDisable(GL_POLYGON_OFFSET_FILL);

    const double stroke = pixel * Canvas::supersampling;
    const double fine = scene.edges.size() > 20000 ? 0.6 : 1.1;
    draw_lines(scene.edges, {0.10F, 0.11F, 0.14F}, std::max(1.0, fine * stroke));
    glDepthRange(0, 0.99995);  // marks in front of the edges they follow
    draw_lines(scene.rods, {0.10F, 0.11F, 0.14F}, 4 * stroke);
    draw_lines(scene.slid, slid_color(), 3 * stroke);
    draw_lines(scene.opened, opened_color(), 3 * stroke);
    glDisable(GL_DEPTH_TEST);  // forces are seen through the stones
    draw_lines(scene.thrust, force_color(), 1.5 * stroke);
    draw_lines(scene.forces, force_color(), 3 * stroke);
    draw_lines(scene.ground_arrows, {1, 1, 1}, 9 * stroke);  // a light rim, to be seen on dark stones
    draw_lines(scene.ground_arrows, {0, 0, 0}, 5 * stroke);
    glEnable(GL_DEPTH_TEST);
    glDepthRange(0, 1);
    Image image = canvas_.image();
    darken(image, crease_shade(canvas_.depths(), camera, crease_reach * pixel));
    return image;
}

}  // namespace voussoir::app::render
