// Pictures beside ones that were looked at and kept, as means over cells of 8 x 8 pixels: what another rasteriser
// or font renderer does to edges and letters stays below the tolerance, a missing stone, another colour range or a
// mirrored axis does not. After a change that is meant to be seen: VOUSSOIR_KEEP_PICTURES=1
// build/release/bin/render_test
// --gtest_filter='GoldenPictures.*', and look at what it wrote.
#include <cairo.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <functional>

#include "app/render/extrusion.h"
#include "app/render/framing.h"
#include "app/results/results_writer.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::render
{
namespace
{

constexpr int width = 640, height = 400, cell = 8, across = width / cell, down = height / cell;
constexpr double tolerance = 0.06;        // of a colour from 0 to 1, the mean of a cell
constexpr std::size_t cells_allowed = 8;  // of 4000: a letter that another font renderer sets elsewhere

using Cells = std::vector<std::array<double, 3>>;  // (down x across) colours 0 to 1
using Pixels = std::vector<std::uint32_t>;

Cells cells_of(const Pixels& pixels)
{
    Cells cells(static_cast<std::size_t>(across) * down);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t k = 0; k < 3; ++k)
                cells[static_cast<std::size_t>(y / cell * across + x / cell)][k] +=
                    (pixels[static_cast<std::size_t>(y * width + x)] >> (16 - 8 * k) & 255U) / 255.0 / cell / cell;
    return cells;
}

std::size_t cells_that_differ(const Cells& a, const Cells& b)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        double most = 0;
        for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(a[i][k] - b[i][k]));
        count += most > tolerance ? 1 : 0;
    }
    return count;
}

std::filesystem::path golden_file(const std::string& name)
{
    return std::filesystem::path(VOUSSOIR_GOLDEN_PICTURES) / (name + ".png");
}

void keep(const Cells& cells, const std::string& name)
{
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, across, down);
    unsigned char* bytes = cairo_image_surface_get_data(surface);
    for (int i = 0; i < across * down; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            bytes[i / across * cairo_image_surface_get_stride(surface) + 4 * (i % across) + 2 -
                  static_cast<int>(k)] =
                static_cast<unsigned char>(std::lround(255 * cells[static_cast<std::size_t>(i)][k]));
    cairo_surface_mark_dirty(surface);
    cairo_surface_write_to_png(surface, golden_file(name).c_str());
    cairo_surface_destroy(surface);
}

Cells kept(const std::string& name)
{
    cairo_surface_t* surface = cairo_image_surface_create_from_png(golden_file(name).c_str());
    EXPECT_EQ(cairo_image_surface_get_width(surface), across) << golden_file(name);
    EXPECT_EQ(cairo_image_surface_get_height(surface), down);
    const unsigned char* bytes = cairo_image_surface_get_data(surface);
    Cells cells(static_cast<std::size_t>(across) * down);
    if (cairo_image_surface_get_width(surface) == across)
        for (int i = 0; i < across * down; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                cells[static_cast<std::size_t>(i)][k] =
                    bytes[i / across * cairo_image_surface_get_stride(surface) + 4 * (i % across) + 2 -
                          static_cast<int>(k)] /
                    255.0;
    cairo_surface_destroy(surface);
    return cells;
}

/// What is drawn of a moment, and how; faults are made in it.
struct Drawn {
    results::RecordedModel model;
    results::RecordedFrame frame;
    SceneOptions options;
    double range = 1;  // times the colour range
    bool mirrored = false;
};

Drawn arch_at_its_worst()
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_deformable);
    results::ResultsWriter writer(the_case, folder.path());
    for (const double time : {0.0, 2.0}) writer.frame(synthetic::swaying(the_case, time), {});
    writer.finish(synthetic::swaying(the_case, 2), {}, {0, 0});
    const results::ResultsReader results(writer.results_file());
    return {results.model, results.frame(1), {SnapshotColor::displacement, 20, noteworthy_opening}};
}

Pixels picture_of(const Drawn& drawn)
{
    Scene scene = make_scene(drawn.model, drawn.frame, drawn.options);
    Framing framing(drawn.options.color);
    framing.add(scene);
    drawing::ColorScale scale = framing.scale();
    scale.highest *= drawn.range;
    Camera camera = framing.camera(width, height, is_planar(drawn.model.kinematics));
    if (drawn.mirrored) camera.view_projection.row(0) *= -1;
    Drawing drawing(width, height);
    return page_pixels(drawing.draw(scene, camera, scale, logical_pixel(width, height)), scale,
                       words_of(scene, drawn.model, drawn.options), nullptr);
}

/// How many cells are not as they were kept; with VOUSSOIR_KEEP_PICTURES they are kept now.
std::size_t differing(const std::string& name, const Pixels& pixels)
{
    const Cells cells = cells_of(pixels);
    if (std::getenv("VOUSSOIR_KEEP_PICTURES") != nullptr) keep(cells, name);
    return cells_that_differ(cells, kept(name));
}

TEST(GoldenPictures, OfAnArchInSpace)
{
    EXPECT_LE(differing("arch_displacement", picture_of(arch_at_its_worst())), cells_allowed);
}

TEST(GoldenPictures, OfStressesInAnElevation)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::planar_deformable);
    results::ResultsWriter writer(the_case, folder.path());
    writer.frame(synthetic::swaying(the_case, 1.5), {});
    writer.finish(synthetic::swaying(the_case, 1.5), {}, {0, 0});
    const results::ResultsReader results(writer.results_file());
    const Drawn drawn{
        in_space(results.model), results.frame(0), {SnapshotColor::principal_stress, 1, noteworthy_opening}};
    EXPECT_LE(differing("arch_stress_elevation", picture_of(drawn)), cells_allowed);
}

/// The stones of the arch use more and more of their friction from the left to the right; those at the crown
/// touch nothing. The crown is the eighth of fifteen, between two foundations.
Drawn arch_on_its_friction()
{
    Drawn drawn = arch_at_its_worst();
    drawn.options.color = SnapshotColor::friction;
    for (std::size_t i = 0; i < drawn.model.joints.size(); ++i) {
        JointNow& now = drawn.frame.joints[i];
        drawn.model.bounds[i] = {0.5, 0};
        now.area_in_use = i == 7 || i == 8 ? 0 : 1;
        now.normal_force = 1e4;
        now.shear_force = 5e3 * static_cast<double>(i) / static_cast<double>(drawn.model.joints.size() - 1);
    }
    return drawn;
}

TEST(GoldenPictures, OfTheUseOfFriction)
{
    EXPECT_LE(differing("arch_friction", picture_of(arch_on_its_friction())), cells_allowed);
    Drawn pressing = arch_on_its_friction(), reversed = arch_on_its_friction();
    pressing.frame.joints[7].area_in_use = 1;
    EXPECT_GT(cells_that_differ(cells_of(picture_of(pressing)), kept("arch_friction")), 5 * cells_allowed)
        << "a stone whose joint presses after all";
    std::reverse(reversed.frame.joints.begin(), reversed.frame.joints.end());
    EXPECT_GT(cells_that_differ(cells_of(picture_of(reversed)), kept("arch_friction")), 5 * cells_allowed);
}

TEST(GoldenPictures, OfStrains)
{
    Drawn drawn = arch_at_its_worst();
    drawn.options.color = SnapshotColor::principal_strain;
    EXPECT_LE(differing("arch_strain", picture_of(drawn)), cells_allowed);
    drawn.range = 1.25;
    EXPECT_GT(cells_that_differ(cells_of(picture_of(drawn)), kept("arch_strain")), 5 * cells_allowed);
}

TEST(GoldenPictures, ToleratesTheNoiseOfRasterisers)
{
    const Cells arch = cells_of(picture_of(arch_at_its_worst()));
    Pixels noisy = picture_of(arch_at_its_worst()), shifted = noisy;
    unsigned random = 1;
    for (std::uint32_t& pixel : noisy) {  // each channel up or down by up to eight
        std::uint32_t changed = 0;
        for (unsigned shift = 0; shift < 24; shift += 8) {
            random = random * 1664525U + 1013904223U;
            const int value = static_cast<int>(pixel >> shift & 255U) + static_cast<int>(random >> 24U) % 17 - 8;
            changed |= static_cast<std::uint32_t>(std::clamp(value, 0, 255)) << shift;
        }
        pixel = changed;
    }
    EXPECT_LE(cells_that_differ(cells_of(noisy), arch), cells_allowed);
    for (std::size_t i = 0; i + 1 < shifted.size(); i += 3) shifted[i] = shifted[i + 1];  // edges, one pixel aside
    EXPECT_LE(cells_that_differ(cells_of(shifted), arch), cells_allowed);
}

TEST(GoldenPictures, SeesAMissingStoneAnotherRangeAndAMirroredAxis)
{
    const Cells arch = kept("arch_displacement");
    const auto seen = [&](const std::function<void(Drawn&)>& spoil) {
        Drawn drawn = arch_at_its_worst();
        spoil(drawn);
        return cells_that_differ(cells_of(picture_of(drawn)), arch);
    };
    for (const std::int32_t stone : {1, 7, 12})
        EXPECT_GT(seen([&](Drawn& drawn) {
                      results::SurfaceMesh& mesh = drawn.model.mesh;  // its faces become those of another stone
                      for (std::size_t v = 0; v < mesh.vertex_block.size(); ++v)
                          if (mesh.vertex_block[v] == stone)
                              for (std::size_t k = 0; k < 3; ++k) mesh.levers[3 * v + k] = 0;
                  }),
                  5 * cells_allowed)
            << "stone " << stone;
    EXPECT_GT(seen([](Drawn& drawn) { drawn.range = 1.25; }), 5 * cells_allowed) << "a scale a quarter too long";
    EXPECT_GT(seen([](Drawn& drawn) { drawn.mirrored = true; }), 5 * cells_allowed);
    EXPECT_GT(seen([](Drawn& drawn) { drawn.options.joint_threshold = 1; }), 3 * cells_allowed)
        << "no joint marked";
}

}  // namespace
}  // namespace voussoir::app::render
