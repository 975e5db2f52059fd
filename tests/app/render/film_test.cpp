// Films: what lies between stored frames, how long they are, what ffmpeg makes of them, and what is left when it
// fails.
#include "app/render/film.h"

#include <cairo.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

#include "app/render/between.h"
#include "app/render/snapshots.h"
#include "app/results/results_writer.h"
#include "app/results/run_end.h"
#include "libdda/errors.h"
#include "tests/app/command_test.h"
#include "tests/app/results/synthetic.h"
#include "tests/app/test_files.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::render
{
namespace
{

using Eigen::Vector3d;

/// A frame of one block that has turned by `angle` about y and moved by `moved` along x.
results::RecordedFrame turned_frame(Kinematics kinematics, double time, double angle, double moved)
{
    results::RecordedFrame frame;
    frame.time = time;
    std::vector<double>& x = frame.state.coordinates;
    const double c = std::cos(angle), s = std::sin(angle);
    if (kinematics == Kinematics::spatial_rigid)
        x = {moved, 0, 0, std::cos(angle / 2), 0, std::sin(angle / 2), 0};
    else if (kinematics == Kinematics::spatial_deformable)
        x = {moved, 0, 0, c, 0, -s, 0, 1, 0, s, 0, c};
    else if (kinematics == Kinematics::planar_rigid)
        x = {moved, 0, angle};
    else
        x = {moved, 0, c, s, -s, c};
    frame.state.velocities.assign(static_cast<std::size_t>(unknowns_per_block(kinematics)), time);
    frame.joints.resize(1);
    frame.joints[0].motion.opening = 1e-3 * time;
    return frame;
}

TEST(Between, ATurnGoesAlongTheArcWithoutShrinking)
{
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::spatial_rigid,
                                        Kinematics::planar_deformable, Kinematics::planar_rigid}) {
        const double angle = 2.0;  // a chord would shrink the stone to cos(1) = 0.54
        const auto before = turned_frame(kinematics, 1, 0, 0), after = turned_frame(kinematics, 3, angle, 0.8);
        for (const double share : {0.0, 0.25, 0.5, 1.0}) {
            const auto expected = turned_frame(kinematics, 1 + 2 * share, share * angle, share * 0.8);
            const auto found = between(kinematics, before, after, 1 + 2 * share);
            EXPECT_NEAR(found.time, expected.time, 1e-15);
            for (std::size_t i = 0; i < expected.state.coordinates.size(); ++i)
                EXPECT_NEAR(found.state.coordinates[i], expected.state.coordinates[i], 1e-12)
                    << name_of(kinematics) << " " << share << " " << i;
            EXPECT_NEAR(found.joints[0].motion.opening, 1e-3 * found.time, 1e-15);
            EXPECT_NEAR(found.state.velocities[0], found.time, 1e-12);
        }
    }
}

TEST(Between, AStretchedStoneStaysStretchedWhileItTurns)
{
    auto before = turned_frame(Kinematics::spatial_deformable, 0, 0, 0),
         after = turned_frame(Kinematics::spatial_deformable, 1, 1.5, 0);
    for (auto* frame : {&before, &after})
        for (std::size_t i = 3; i < 12; ++i) frame->state.coordinates[i] *= 1.01;
    const auto middle = between(Kinematics::spatial_deformable, before, after, 0.5);
    const Eigen::Map<const Eigen::Matrix3d> map(middle.state.coordinates.data() + 3);
    EXPECT_NEAR((map.transpose() * map - 1.01 * 1.01 * Eigen::Matrix3d::Identity()).norm(), 0, 1e-12);
}

/// Frames at 0 (static), 0.1, ..., `last` s of a tower whose run of 2 s is to end in this way.
std::filesystem::path run_of(const std::filesystem::path& folder, double last, Outcome outcome,
                             bool killed = false)
{
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid, 3);
    results::ResultsWriter writer(the_case, folder);
    for (int i = 0; 0.1 * i < last + 1e-9; ++i) writer.frame(synthetic::swaying(the_case, 0.1 * i), {});
    RunReport report;
    report.outcome = outcome;
    if (!killed) writer.finish(synthetic::swaying(the_case, last), report, {0, 0});
    return writer.results_file();
}

TEST(FilmTimes, TrueTimeSlowedTimeAndTheHeldEnd)
{
    const TemporaryFolder folder;
    const results::ResultsReader results(run_of(folder.path(), 1.5, Outcome::completed));
    FilmOptions options;
    std::vector<double> times = film_times(results, options, false);
    ASSERT_EQ(times.size(), 38U) << "1.5 s at 25 frames a second: 37 steps of 0.04 s";
    EXPECT_NEAR(times[10], 0.4, 1e-12);
    options.slow_down = 4;
    times = film_times(results, options, false);
    EXPECT_EQ(times.size(), 151U);
    EXPECT_NEAR(times[100], 1.0, 1e-12);
    EXPECT_EQ(film_times(results, options, true).size(), 151U + 50U) << "two seconds more of the last moment";
    options.slow_down = 1e4;
    EXPECT_THROW(film_times(results, options, false), InputError);
}

TEST(RunEnd, SaysHowTheRunEnded)
{
    const auto words = [](double last, Outcome outcome, bool killed) {
        const TemporaryFolder folder;
        return results::early_end_in_words(results::run_end_of(run_of(folder.path(), last, outcome, killed)));
    };
    EXPECT_EQ(words(2, Outcome::completed, false), "");
    EXPECT_EQ(words(1.2, Outcome::collapsed, false), "the structure collapsed at 1.2 of 2 s");
    EXPECT_EQ(words(1.2, Outcome::gave_up, false), "the run gave up at 1.2 of 2 s");
    EXPECT_EQ(words(1.2, Outcome::interrupted, false), "the run was interrupted at 1.2 of 2 s");
    EXPECT_EQ(words(1.2, Outcome::completed, true),
              "the run has not ended: killed, or still running, at 1.2 of 2 s");
}

/// What ffprobe says of the first stream: "h264,320,240,yuv420p,25/1,63".
std::string probed(const std::filesystem::path& film)
{
    const std::string command =
        "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
        "stream=codec_name,pix_fmt,width,height,nb_read_frames,r_frame_rate -of csv=p=0 '" +
        film.string() + "' > '" + film.string() + ".txt'";
    if (std::system(command.c_str()) != 0) return "unreadable";
    std::string line;
    std::getline(std::ifstream(film.string() + ".txt"), line);
    return line;
}

/// A film is at its place, and nothing beside it.
class FilmFile : public CommandTest
{
 protected:
    std::vector<std::string> films() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
            if (entry.path().filename().string().find("film.") == 0)
                names.push_back(entry.path().filename().string());
        return names;
    }
    /// A program called ffmpeg that does this. @returns what PATH must be
    std::string false_ffmpeg(const std::string& script)
    {
        const std::filesystem::path folder = folder_.path() / "bin";
        std::filesystem::create_directory(folder);
        std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n" << script << "\n";
        chmod((folder / "ffmpeg").c_str(), 0700);
        return "env PATH=" + folder.string() + ":/usr/bin:/bin";
    }
};

TEST_F(FilmFile, IsWhatBrowsersPlay)
{
    run_of(folder_.path(), 1.0, Outcome::collapsed);
    ASSERT_EQ(voussoir("render results.h5 --video film.mp4 --size 320 240"), 0) << output_;
    EXPECT_EQ(probed(folder_.path() / "film.mp4"), "h264,320,240,yuv420p,25/1,76") << "26 frames and 50 held";
    EXPECT_NE(output_.find("film.mp4"), std::string::npos);
    EXPECT_NE(output_.find("100 %  film: frame 76 of 76"), std::string::npos) << output_;
    EXPECT_EQ(films(), (std::vector<std::string>{"film.mp4", "film.mp4.txt"}));
    const std::string film = contents("film.mp4");
    EXPECT_LT(film.find("moov"), film.find("mdat")) << "the index in front: plays while it loads";
    ASSERT_EQ(voussoir("render results.h5 --video again.mp4 --size 320 240"), 0) << output_;
    EXPECT_EQ(contents("again.mp4"), film) << "the same film from the same results";
}

TEST_F(FilmFile, MovingPicturesForAPage)
{
    run_of(folder_.path(), 0.4, Outcome::completed);
    ASSERT_EQ(voussoir("render results.h5 --video film.gif --size 200 200 --fps 10"), 0) << output_;
    EXPECT_EQ(probed(folder_.path() / "film.gif"), "gif,200,200,bgra,10/1,5");
    ASSERT_EQ(voussoir("render results.h5 --video film.webp --size 200 200 --fps 10"), 0) << output_;
    EXPECT_EQ(contents("film.webp").substr(8, 4), "WEBP");
}

TEST_F(FilmFile, RefusalsNameTheReason)
{
    run_of(folder_.path(), 0.4, Outcome::completed);
    EXPECT_EQ(voussoir("render results.h5 --video film.avi"), 2);
    EXPECT_NE(output_.find("mp4, gif, webp"), std::string::npos) << output_;
    EXPECT_EQ(voussoir("render results.h5 --video film.mp4 --size 321 240"), 2);
    EXPECT_NE(output_.find("even"), std::string::npos) << output_;
    EXPECT_EQ(voussoir("render results.h5 --video film.mp4 --color principal_stress"), 2);
    EXPECT_NE(output_.find("rigid"), std::string::npos) << output_;
    EXPECT_EQ(films(), std::vector<std::string>{});
}

TEST_F(FilmFile, NothingIsLeftWhenFfmpegIsMissingOrDies)
{
    run_of(folder_.path(), 2.0, Outcome::completed);
    EXPECT_EQ(voussoir("render results.h5 --video film.mp4", "env PATH=/nowhere"), 2);
    EXPECT_NE(output_.find("there is no such program"), std::string::npos) << output_;
    EXPECT_EQ(voussoir("render results.h5 --video film.mp4", false_ffmpeg("echo 'no such codec' >&2; exit 1")), 2);
    EXPECT_NE(output_.find("no such codec"), std::string::npos) << output_;
    const std::string eats_and_dies = "for last; do :; done; head -c 100000 > \"${last#file:}\"; kill -9 $$";
    EXPECT_EQ(voussoir("render results.h5 --video film.mp4", false_ffmpeg(eats_and_dies)), 2);
    EXPECT_NE(output_.find("ffmpeg"), std::string::npos) << output_;
    const std::string writes_and_fails = "for last; do :; done; cat > \"${last#file:}\"; exit 3";
    EXPECT_EQ(voussoir("render results.h5 --video film.mp4", false_ffmpeg(writes_and_fails)), 2);
    EXPECT_EQ(films(), std::vector<std::string>{}) << "neither half a film nor its temporary name";
}

TEST_F(FilmFile, AnOldFilmStaysWhenTheNewOneFails)
{
    run_of(folder_.path(), 0.4, Outcome::completed);
    std::ofstream(folder_.path() / "film.mp4") << "the old one";
    EXPECT_EQ(voussoir("render results.h5 --video film.mp4", false_ffmpeg("cat > /dev/null; exit 1")), 2);
    EXPECT_EQ(contents("film.mp4"), "the old one");
}

TEST_F(FilmFile, ARunMakesTheOneItsCaseAsksFor)
{
    folder_.write("case.yaml", with(two_boxes, "output: {", "output: {video: {size: [240, 200], slow_down: 2}, "));
    std::filesystem::create_directory(folder_.path() / "results");
    folder_.write("results/video.gif", "of an earlier run");
    ASSERT_EQ(voussoir("run case.yaml -o results"), 0) << output_;
    EXPECT_EQ(probed(folder_.path() / "results/video.mp4"), "h264,240,200,yuv420p,25/1,11") << "0.4 s of film";
    EXPECT_NE(output_.find("results/video.mp4"), std::string::npos) << output_;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "results/video.gif"));
}

TEST(Beside, BothRunsHaveTheirHalfOnOneScale)
{
    const TemporaryFolder one, other;
    const std::filesystem::path a = run_of(one.path(), 2, Outcome::completed),
                                b = run_of(other.path(), 1, Outcome::collapsed);
    SnapshotOptions options;
    options.width = 800;
    options.height = 300;
    options.times = {0.5, 2};
    const auto halves = [&](const std::filesystem::path& left, const std::filesystem::path& right) {
        std::vector<bool> alike;
        for (const auto& picture :
             render_beside({{left, "A: one"}, {right, "A: one"}}, one.path() / "both", options, {}, 1e-4)) {
            cairo_surface_t* surface = cairo_image_surface_create_from_png(picture.c_str());
            EXPECT_EQ(cairo_image_surface_get_width(surface), 800);
            const unsigned char* bytes = cairo_image_surface_get_data(surface);
            const int stride = cairo_image_surface_get_stride(surface);
            bool same = true;
            for (int y = 0; y < 300; ++y)
                same =
                    same && std::equal(bytes + y * stride, bytes + y * stride + 1600, bytes + y * stride + 1600);
            alike.push_back(same);
            cairo_surface_destroy(surface);
        }
        return alike;
    };
    EXPECT_EQ(halves(a, a), (std::vector<bool>{true, true}));
    EXPECT_EQ(halves(a, b), (std::vector<bool>{true, false})) << "b ends at 1 s and says so";
}

TEST_F(FilmFile, WithoutFfmpegACaseThatWantsAFilmIsRefusedBeforeItRuns)
{
    folder_.write("case.yaml", with(two_boxes, "output: {", "output: {video: true, "));
    for (const char* command : {"check case.yaml", "run case.yaml -o results"}) {
        EXPECT_EQ(voussoir(command, "env PATH=/nowhere"), 2);
        EXPECT_NE(output_.find("output.video: there is no program ffmpeg"), std::string::npos) << output_;
    }
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "results"));
}

TEST_F(FilmFile, OfRestAloneThereIsNone)
{
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid, 3);
    results::ResultsWriter writer(the_case, folder_.path());
    writer.frame(synthetic::swaying(the_case, 0), {});
    writer.finish(synthetic::swaying(the_case, 0), {}, {0, 0});
    EXPECT_EQ(voussoir("render results.h5 --video film.mp4"), 2);
    EXPECT_NE(output_.find("no time passes"), std::string::npos) << output_;
}

}  // namespace
}  // namespace voussoir::app::render
