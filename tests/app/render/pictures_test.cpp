// The pictures themselves, made by the helper program as the program asks for them.
#include <cairo.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "app/render/snapshots.h"
#include "app/results/results_writer.h"
#include "libdda/errors.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::render
{
namespace
{

std::filesystem::path results_of(const Case& the_case, const std::filesystem::path& folder)
{
    results::ResultsWriter writer(the_case, folder);
    for (int i = 0; i <= 4; ++i) writer.frame(synthetic::swaying(the_case, 0.5 * i), {});
    writer.finish(synthetic::swaying(the_case, 2), {}, {0, 0});
    return writer.results_file();
}

struct Picture {
    int width = 0, height = 0;
    std::vector<std::array<int, 3>> pixels;

    explicit Picture(const std::filesystem::path& path)
    {
        cairo_surface_t* surface = cairo_image_surface_create_from_png(path.c_str());
        width = cairo_image_surface_get_width(surface);
        height = cairo_image_surface_get_height(surface);
        const unsigned char* bytes = cairo_image_surface_get_data(surface);
        const int stride = cairo_image_surface_get_stride(surface);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const unsigned char* p = bytes + static_cast<std::ptrdiff_t>(y) * stride + 4 * x;
                pixels.push_back({p[2], p[1], p[0]});
            }
        }
        cairo_surface_destroy(surface);
    }

    /// Share of the pixels of the drawing (not of head, foot and colour bar) for which `test` holds.
    template <typename Test>
    double share(Test test) const
    {
        int count = 0, all = 0;
        for (int y = height / 8; y < height * 88 / 100; ++y) {
            for (int x = 0; x < width * 85 / 100; ++x, ++all) count += test(pixels[y * width + x]) ? 1 : 0;
        }
        return static_cast<double>(count) / all;
    }
};

bool is_red(const std::array<int, 3>& c)
{
    return c[0] > 200 && c[1] < 60 && c[2] < 60;
}

bool is_background(const std::array<int, 3>& c)
{
    return std::min({c[0], c[1], c[2]}) > 225;
}

bool is_colored(const std::array<int, 3>& c)
{
    return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]}) > 40;
}

TEST(Pictures, HaveTheirSizeTheirNamesAndSomethingOnThem)
{
    const TemporaryFolder folder;
    SnapshotOptions options;
    options.times = {0.5, 2};
    options.width = 800;
    options.height = 500;
    const auto pictures =
        render_snapshots(results_of(synthetic::arch(Kinematics::spatial_deformable), folder.path()),
                         folder.path() / "snapshots", options);
    ASSERT_EQ(pictures.size(), 2U);
    EXPECT_EQ(pictures[0], folder.path() / "snapshots" / "snapshot_0001_t=0.500s.png");
    EXPECT_EQ(pictures[1], folder.path() / "snapshots" / "snapshot_0002_t=2.000s.png");
    for (const auto& path : pictures) {
        const Picture picture(path);
        EXPECT_EQ(picture.width, 800);
        EXPECT_EQ(picture.height, 500);
        EXPECT_GT(picture.share(is_background), 0.3);
        EXPECT_GT(picture.share([](const auto& c) { return !is_background(c); }), 0.2) << "it fills the frame";
        EXPECT_GT(picture.share(is_colored), 0.08);
        EXPECT_GT(picture.share(is_red), 0.0003) << "open joints are marked";
    }
}

TEST(Pictures, NoMarkWhereNothingOpened)
{
    const TemporaryFolder folder;
    SnapshotOptions options;
    options.times = {0};
    options.width = 800;
    options.height = 500;
    const auto pictures = render_snapshots(results_of(synthetic::arch(Kinematics::spatial_rigid), folder.path()),
                                           folder.path() / "snapshots", options);
    ASSERT_EQ(pictures.size(), 1U);
    EXPECT_EQ(Picture(pictures[0]).share(is_red), 0);
}

TEST(Pictures, OfAnEarlierRenderingDoNotStay)
{
    const TemporaryFolder folder;
    const auto results = results_of(synthetic::tower(Kinematics::spatial_rigid), folder.path());
    SnapshotOptions options;
    options.width = options.height = 300;
    options.count = 4;
    EXPECT_EQ(render_snapshots(results, folder.path() / "s", options).size(), 4U);
    options.count = 1;
    const auto pictures = render_snapshots(results, folder.path() / "s", options);
    ASSERT_EQ(pictures.size(), 1U);
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "s")) {
        EXPECT_EQ(entry.path(), pictures[0]);
        ++files;
    }
    EXPECT_EQ(files, 1);
}

std::string sentence_of(const std::filesystem::path& results, const SnapshotOptions& options)
{
    try {
        render_snapshots(results, results.parent_path() / "snapshots", options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(Pictures, OfStressesThatARigidSceneHasNotAreRefused)
{
    const TemporaryFolder folder;
    SnapshotOptions options;
    options.color = SnapshotColor::principal_stress;
    const std::string sentence =
        sentence_of(results_of(synthetic::tower(Kinematics::spatial_rigid), folder.path()), options);
    EXPECT_NE(sentence.find("rigid blocks"), std::string::npos) << sentence;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "snapshots"));
}

TEST(Pictures, WithoutResultsOrHelperAreRefused)
{
    const TemporaryFolder folder;
    EXPECT_NE(sentence_of(folder.path() / "none.h5", {}).find("No such file"), std::string::npos);
    setenv("VOUSSOIR_BIN_DIR", folder.path().c_str(), 1);
    const std::string sentence = sentence_of(folder.path() / "none.h5", {});
    unsetenv("VOUSSOIR_BIN_DIR");
    EXPECT_NE(sentence.find("VOUSSOIR_RENDER"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace voussoir::app::render
