// The pictures of defects: they are drawn, and the mark is seen in its colour.
#include "app/render/defect_pictures.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <array>

#include "libdda/geometry/convex_polyhedron.h"
#include "tests/app/test_files.h"

namespace voussoir::app::render
{
namespace
{

using Eigen::Vector3d;
using Pixel = std::array<int, 3>;

PictureShape box(const Vector3d& lower, const Vector3d& upper)
{
    const ConvexPolyhedron shape = make_box(lower, upper);
    return {shape.vertices, shape.faces};
}

/// How many pixels of the drawing, without callouts and legend, pass a test.
template <typename Test>
int count(const std::filesystem::path& path, Test test)
{
    cairo_surface_t* surface = cairo_image_surface_create_from_png(path.c_str());
    const int width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
    const unsigned char* bytes = cairo_image_surface_get_data(surface);
    int found = 0;
    for (int y = height / 6; y < height * 3 / 4; ++y)
        for (int x = width / 6; x < width * 5 / 6; ++x) {
            const unsigned char* p =
                bytes + static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface) + 4 * x;
            found += test(Pixel{p[2], p[1], p[0]}) ? 1 : 0;
        }
    cairo_surface_destroy(surface);
    return found;
}

bool is_red(const Pixel& c)
{
    return c[0] > 180 && c[1] < 60 && c[2] < 60;
}

bool is_blue(const Pixel& c)
{
    return c[0] < 60 && c[1] < 130 && c[2] > 180;
}

bool is_faulty_stone(const Pixel& c)
{
    return c[0] > c[1] + 20 && c[1] > c[2] + 40 && c[0] > 120;
}

/// A box with a mark on its back, a neighbour as a ghost.
DefectPictures marked_box(const importers::mesh::MarkedFeature& feature, MarkLook look)
{
    DefectPictures pictures;
    pictures.width = 700;
    pictures.height = 500;
    pictures.shapes = {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})};
    DefectPicture picture;
    picture.name = "defect_01_box.png";
    picture.title = "box: refused";
    picture.stones = {{0, StoneLook::faulty}, {1, StoneLook::ghost}};
    picture.marks = {{feature, look}};
    picture.legend = {{StoneLook::faulty, "refused stone"}};
    pictures.pictures = {picture};
    return pictures;
}

TEST(DefectPictures, ShowAMarkWhereverItIs)
{
    for (const double y : {0.0, 1.0}) {
        const TemporaryFolder folder;
        const importers::mesh::MarkedFeature hole{
            "hole", {}, {{Vector3d(0.2, y, 0.2), Vector3d(0.8, y, 0.8)}}, {}};
        const auto files = draw_defects(marked_box(hole, MarkLook::defect), folder / "");
        ASSERT_EQ(files.size(), 1U);
        EXPECT_GT(count(files[0], is_red), 150);
        EXPECT_GT(count(files[0], is_faulty_stone), 5000);
    }
}

TEST(DefectPictures, ShowNoMarkWhereNoneIs)
{
    const TemporaryFolder folder;
    const auto files = draw_defects(marked_box({}, MarkLook::defect), folder / "");
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(count(files[0], is_red), 0);
}

TEST(DefectPictures, GapsAreBluePolygons)
{
    const TemporaryFolder folder;
    const importers::mesh::MarkedFeature gap{
        "25 mm apart", {}, {}, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}};
    const auto files = draw_defects(marked_box(gap, MarkLook::gap), folder / "");
    ASSERT_EQ(files.size(), 1U);
    EXPECT_GT(count(files[0], is_blue), 300);
    EXPECT_EQ(count(files[0], is_red), 0);
}

TEST(DefectPictures, TheRequestSurvivesTheWire)
{
    const importers::mesh::MarkedFeature feature{
        "faces cross", {{1, 2, 3}}, {{Vector3d(0, 0, 0), Vector3d(1, 0, 0)}}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
    const DefectPictures sent = marked_box(feature, MarkLook::contact);
    const DefectRequest got = defects_from_json(to_json(sent, "/some/where"));
    EXPECT_EQ(got.folder, "/some/where");
    ASSERT_EQ(got.pictures.pictures.size(), 1U);
    const PictureMark& mark = got.pictures.pictures[0].marks.at(0);
    EXPECT_EQ(mark.look, MarkLook::contact);
    EXPECT_EQ(mark.feature.label, "faces cross");
    EXPECT_EQ(mark.feature.points, feature.points);
    EXPECT_EQ(mark.feature.lines, feature.lines);
    EXPECT_EQ(mark.feature.polygons, feature.polygons);
    EXPECT_EQ(got.pictures.shapes[1].vertices, sent.shapes[1].vertices);
}

TEST(DefectPictures, ARequestThatPointsOutsideIsRefused)
{
    DefectPictures bad = marked_box({}, MarkLook::defect);
    bad.pictures[0].stones[0].shape = 7;
    EXPECT_THROW(defects_from_json(to_json(bad, ".")), std::exception);
    bad = marked_box({}, MarkLook::defect);
    bad.shapes[0].faces[0][0] = 99;
    EXPECT_THROW(defects_from_json(to_json(bad, ".")), std::exception);
}

}  // namespace
}  // namespace voussoir::app::render
