// Several pictures at once: in their order, and the same whatever their number.
#include "app/render/picture_queue.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::render
{
namespace
{

TEST(PictureQueue, HandsOverInOrderAndPassesOnWhatIsThrown)
{
    PictureQueue queue(3, 200, 200);
    for (std::uint32_t i = 0; i < 20; ++i)
        queue.ask([i](Drawing& drawing) {
            if (i == 13) throw std::runtime_error("thirteen");
            std::this_thread::sleep_for(std::chrono::milliseconds(i % 3));
            return Pixels(static_cast<std::size_t>(drawing.width()), i);
        });
    EXPECT_TRUE(queue.is_full());
    for (std::uint32_t i = 0; i < 20; ++i) {
        if (i == 13)
            EXPECT_THROW(queue.next(), std::runtime_error);
        else
            EXPECT_EQ(queue.next(), Pixels(200, i));
    }
    EXPECT_TRUE(queue.is_empty());
}

TEST(PictureQueue, EndsWithoutWaitingForWhatNobodyTook)
{
    PictureQueue queue(2, 200, 200);
    for (int i = 0; i < 1000; ++i)
        queue.ask([](Drawing&) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            return Pixels();
        });
}

TEST(PictureQueue, TakesAsManyAsFindRoom)
{
    EXPECT_EQ(jobs_for(3, 640, 480), 3);
    EXPECT_EQ(jobs_for(3, 8000, 8000), 1) << "one of them takes 4 GB";
    EXPECT_LE(jobs_for(1000, 640, 480), 20);
    EXPECT_GE(jobs_for(0, 640, 480), 1);
}

class PicturesAtOnce : public CommandTest
{
 protected:
    std::vector<std::string> pictures(const std::string& folder)
    {
        std::vector<std::string> all;
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / folder))
            files.push_back(entry.path().filename());
        std::sort(files.begin(), files.end());
        all.reserve(files.size());
        for (const std::filesystem::path& file : files) all.push_back(file.string() + contents(folder / file));
        return all;
    }
};

TEST_F(PicturesAtOnce, AreTheSameBytesWhateverTheirNumber)
{
    folder_.write("case.yaml", two_boxes);
    ASSERT_EQ(voussoir("run case.yaml -o results -q"), 0) << output_;
    const std::string wishes =
        "render results/results.h5 --size 320 240 --color friction --deformation-scale 1e4 ";
    for (const char* jobs : {"1", "2", "5"}) {
        ASSERT_EQ(voussoir(wishes + "--count 7 -o of_" + jobs + " --jobs " + jobs), 0) << output_;
        ASSERT_EQ(voussoir(wishes + "--orbit 90 --slow-down 4 --video film_" + jobs + ".gif --jobs " + jobs), 0)
            << output_;
    }
    EXPECT_EQ(pictures("of_1").size(), 7U);
    for (const char* jobs : {"2", "5"}) {
        EXPECT_TRUE(pictures("of_1") == pictures(std::string("of_") + jobs)) << jobs;
        EXPECT_TRUE(contents("film_1.gif") == contents(std::string("film_") + jobs + ".gif")) << jobs;
    }
}

}  // namespace
}  // namespace voussoir::app::render
