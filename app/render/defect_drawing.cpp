#include "app/render/defect_drawing.h"

#define GL_GLEXT_PROTOTYPES  // glBlendFuncSeparate
#include <GL/gl.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "app/render/defect_colors.h"

namespace voussoir::app::render
{

namespace
{

using Eigen::Vector3d;

constexpr float hidden_mark = 0.55F;  // opacity of what lies behind something

struct Light {
    Vector3d main, back;  // unit: towards the light, towards the viewer
};

/// Inner sides, seen through a hole, are darker.
float brightness(const Vector3d& normal, const Light& light)
{
    if (normal.dot(light.back) < 0) return 0.48F;
    return static_cast<float>(std::min(1.0, 0.60 + 0.42 * std::max(0.0, normal.dot(light.main))));
}

Vector3d normal_of(const PictureShape& shape, const std::vector<int>& face)
{
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        sum += (shape.vertices[face[i]] - shape.vertices[face[0]])
                   .cross(shape.vertices[face[i + 1]] - shape.vertices[face[0]]);
    return sum.norm() > 0 ? Vector3d(sum.normalized()) : Vector3d::Zero();
}

/// A face on its way to the picture.
struct Facet {
    const PictureShape* shape;
    const std::vector<int>* face;
    Eigen::Vector4f color;
    double depth;  // along the view, for drawing from back to front
};

std::vector<Facet> facets_of(const std::vector<PictureShape>& shapes, const DefectPicture& picture, bool opaque,
                             const Camera& camera)
{
    const Light light{(-0.55 * camera.right + 0.70 * camera.up + 0.75 * camera.back).normalized(), camera.back};
    std::vector<Facet> facets;
    for (const PictureStone& stone : picture.stones) {
        const LookColor look = color_of(stone.look);
        if ((look.opacity == 1) != opaque) continue;
        const PictureShape& shape = shapes[stone.shape];
        for (const std::vector<int>& face : shape.faces) {
            if (face.size() < 3) continue;
            const drawing::Rgb color = look.color * brightness(normal_of(shape, face), light);
            double depth = 0;
            for (const int v : face)
                depth += camera.back.dot(shape.vertices[v]) / static_cast<double>(face.size());
            facets.push_back({&shape, &face, {color.x(), color.y(), color.z(), look.opacity}, depth});
        }
    }
    return facets;
}

void draw_facets(const std::vector<Facet>& facets)
{
    glBegin(GL_TRIANGLES);
    for (const Facet& facet : facets) {
        glColor4fv(facet.color.data());
        const std::vector<int>& face = *facet.face;
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            for (const std::size_t corner : {std::size_t{0}, i, i + 1})
                glVertex3dv(facet.shape->vertices[face[corner]].data());
    }
    glEnd();
}

/// Every edge once: faces of a stone name their shared edges in opposite directions, but a bad surface may not.
void draw_edges(const std::vector<Facet>& facets, const Eigen::Vector4f& color, double width)
{
    glLineWidth(static_cast<float>(width));
    glColor4fv(color.data());
    glBegin(GL_LINES);
    for (const Facet& facet : facets) {
        const std::vector<int>& face = *facet.face;
        for (std::size_t i = 0; i < face.size(); ++i) {
            glVertex3dv(facet.shape->vertices[face[i]].data());
            glVertex3dv(facet.shape->vertices[face[(i + 1) % face.size()]].data());
        }
    }
    glEnd();
}

void draw_mark(const importers::mesh::MarkedFeature& feature, const drawing::Rgb& color, float opacity,
               double stroke)
{
    glColor4f(color.x(), color.y(), color.z(), 0.5F * opacity * opacity);
    for (const std::vector<Vector3d>& polygon : feature.polygons) {
        glBegin(GL_TRIANGLE_FAN);
        for (const Vector3d& x : polygon) glVertex3dv(x.data());
        glEnd();
    }
    glColor4f(color.x(), color.y(), color.z(), opacity);
    glLineWidth(static_cast<float>(2 * stroke));
    for (const std::vector<Vector3d>& polygon : feature.polygons) {
        glBegin(GL_LINE_LOOP);
        for (const Vector3d& x : polygon) glVertex3dv(x.data());
        glEnd();
    }
    glLineWidth(static_cast<float>(4 * stroke));
    glBegin(GL_LINES);
    for (const auto& line : feature.lines)
        for (const Vector3d& x : line) glVertex3dv(x.data());
    glEnd();
    glPointSize(static_cast<float>(11 * stroke));
    glBegin(GL_POINTS);
    for (const Vector3d& x : feature.points) glVertex3dv(x.data());
    glEnd();
}

void draw_marks(const DefectPicture& picture, float opacity, double stroke)
{
    for (const PictureMark& mark : picture.marks) draw_mark(mark.feature, color_of(mark.look), opacity, stroke);
}

}  // namespace

LookColor color_of(StoneLook look)
{
    switch (look) {
        case StoneLook::plain:
            return {{0.90F, 0.84F, 0.72F}, 1};
        case StoneLook::ground:
            return {{0.70F, 0.72F, 0.75F}, 1};
        case StoneLook::faulty:
            return {{0.98F, 0.78F, 0.38F}, 1};
        case StoneLook::first:
            return {{0.98F, 0.72F, 0.30F}, 0.5F};
        case StoneLook::second:
            return {{0.40F, 0.66F, 0.92F}, 0.5F};
        case StoneLook::floating:
            return {{0.66F, 0.48F, 0.84F}, 1};
        case StoneLook::ghost:
            break;
    }
    return {{0.72F, 0.75F, 0.80F}, 0.11F};
}

drawing::Rgb color_of(MarkLook look)
{
    if (look == MarkLook::gap) return {0.05F, 0.35F, 0.85F};
    if (look == MarkLook::contact) return {0.78F, 0.05F, 0.62F};
    return {0.86F, 0.06F, 0.08F};
}

Image draw_defect(Canvas& canvas, const std::vector<PictureShape>& shapes, const DefectPicture& picture,
                  const Camera& camera, const PictureArea& area, double pixel)
{
    const double stroke = pixel * Canvas::supersampling;
    const std::vector<Facet> opaque = facets_of(shapes, picture, true, camera);
    std::vector<Facet> through = facets_of(shapes, picture, false, camera);
    std::stable_sort(through.begin(), through.end(),
                     [](const Facet& a, const Facet& b) { return a.depth < b.depth; });
    canvas.clear(camera);
    glEnable(GL_SCISSOR_TEST);  // neighbours may reach beyond the drawing: words stand there
    glScissor(0, static_cast<int>((1 + area.bottom) / 2 * canvas.height()) - static_cast<int>(12 * stroke),
              canvas.width(),
              static_cast<int>((area.top - area.bottom) / 2 * canvas.height()) + static_cast<int>(18 * stroke));
    glEnable(GL_BLEND);  // colours over nothing keep their own opacity, premultiplied as the page wants them
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_POINT_SMOOTH);

    glEnable(GL_POLYGON_OFFSET_FILL);  // faces step back a little, so that lines on them are seen
    glPolygonOffset(1.5F, 2);
    draw_facets(opaque);
    glDisable(GL_POLYGON_OFFSET_FILL);
    const double fine = opaque.size() > 20000 ? 0.5 : 1.1;
    draw_edges(opaque, {0.16F, 0.15F, 0.14F, 1}, std::max(1.0, fine * stroke));

    glDepthRange(0, 0.9998);  // marks in front of the faces they lie on
    draw_marks(picture, 1, stroke);
    glDepthRange(0, 1);
    glDepthMask(GL_FALSE);
    draw_facets(through);
    draw_edges(through, {0.25F, 0.28F, 0.34F, 0.35F}, std::max(1.0, 0.9 * stroke));
    glDisable(GL_DEPTH_TEST);
    draw_marks(picture, hidden_mark, stroke);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    return canvas.image();
}

}  // namespace voussoir::app::render
