// kill -9 at any moment leaves a results file that opens, with all frames but at most the last, and from which the
// run goes on as if nothing had happened.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>

#include "app/results/results_reader.h"
#include "app/results/results_writer.h"
#include "tests/app/results/every_dataset.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace
{
// How many more changes of files go through before the process dies; negative: it lives.
long writes_left = -1;

void maybe_die()
{
    if (writes_left == 0) raise(SIGKILL);
    if (writes_left > 0) --writes_left;
}
}  // namespace

// In front of the C library's: HDF5 writes its files through the first two, the others make them valid.
extern "C" ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t offset)
{
    static const auto original = reinterpret_cast<decltype(&pwrite)>(dlsym(RTLD_NEXT, "pwrite"));
    maybe_die();
    return original(descriptor, bytes, count, offset);
}

extern "C" int ftruncate(int descriptor, off_t size) noexcept
{
    static const auto original = reinterpret_cast<int (*)(int, off_t)>(dlsym(RTLD_NEXT, "ftruncate"));
    maybe_die();
    return original(descriptor, size);
}

extern "C" int rename(const char* from, const char* to) noexcept
{
    static const auto original = reinterpret_cast<int (*)(const char*, const char*)>(dlsym(RTLD_NEXT, "rename"));
    maybe_die();
    return original(from, to);
}

extern "C" int link(const char* from, const char* to) noexcept
{
    static const auto original = reinterpret_cast<int (*)(const char*, const char*)>(dlsym(RTLD_NEXT, "link"));
    maybe_die();
    return original(from, to);
}

extern "C" int fsync(int descriptor)
{
    static const auto original = reinterpret_cast<int (*)(int)>(dlsym(RTLD_NEXT, "fsync"));
    maybe_die();
    return original(descriptor);
}

namespace voussoir::app::results
{
namespace
{

constexpr double step = 1e-3;  // s between frames

/// Runs `action` in a child that ends by SIGKILL or, silently, by itself.
template <typename Action>
pid_t in_child(Action action)
{
    const pid_t child = fork();
    if (child == 0) {
        action();
        _exit(0);
    }
    return child;
}

/// A byte through the pipe for each frame that frame() returned from.
void write_frames(const Case& the_case, const std::filesystem::path& folder, int count, int pipe_end,
                  long die_after, int live_frames)
{
    ResultsWriter writer(the_case, folder);
    for (int i = 0; i < count; ++i) {
        if (i == live_frames) writes_left = die_after;
        writer.frame(synthetic::swaying(the_case, step * i), {});
        if (write(pipe_end, "f", 1) != 1) _exit(1);
    }
    writes_left = -1;
}

/// Opens the file and compares every frame with what was written.
void check_file(const Case& the_case, const std::filesystem::path& folder, std::size_t at_least)
{
    const ResultsReader reader(folder / "results.h5");
    ASSERT_GE(reader.times.size(), at_least);
    ASSERT_LE(reader.times.size(), at_least + 1);
    for (std::size_t i = 0; i < at_least; ++i) {
        const RecordedFrame frame = reader.frame(i);
        const State state = synthetic::swaying(the_case, step * static_cast<double>(i));
        ASSERT_EQ(frame.time, state.time);
        ASSERT_EQ(frame.state.coordinates, state.coordinates) << i;
        ASSERT_EQ(frame.state.velocities, state.velocities) << i;
        ASSERT_EQ(frame.joints.size(), the_case.model.blocks.size() - 1);
        ASSERT_EQ(frame.contacts.size(), the_case.model.blocks.size() - 1);
        ASSERT_EQ(frame.contacts.back().centre, joint_resultants(the_case.model, state).back().centre);
    }
}

std::size_t bytes_in(int pipe_end)
{
    std::size_t count = 0;
    char buffer[4096];
    for (ssize_t n = 0; (n = read(pipe_end, buffer, sizeof buffer)) > 0;) count += static_cast<std::size_t>(n);
    return count;
}

TEST(KilledWriter, AtRandomMoments)
{
    const Case the_case = synthetic::arch(Kinematics::spatial_deformable, 30);
    std::mt19937 random(20240406);
    std::size_t total = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const TemporaryFolder folder;
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        const pid_t child = in_child([&] { write_frames(the_case, folder.path(), 1'000'000, ends[1], -1, 0); });
        close(ends[1]);
        char first = 0;
        ASSERT_EQ(read(ends[0], &first, 1), 1);  // the file is there
        usleep(std::uniform_int_distribution<useconds_t>(0, 120'000)(random));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const std::size_t frames = 1 + bytes_in(ends[0]);
        close(ends[0]);
        check_file(the_case, folder.path(), frames);
        total += frames;
    }
    EXPECT_GT(total, 40U) << "the kills came before anything was written";
}

/// Dies before the first, second, third, ... write of one frame, until the frame gets through.
void kill_at_every_write(const Case& the_case, int live_frames)
{
    for (long die_after = 0;; ++die_after) {
        const TemporaryFolder folder;
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        const pid_t child = in_child(
            [&] { write_frames(the_case, folder.path(), live_frames + 1, ends[1], die_after, live_frames); });
        close(ends[1]);
        int status = 0;
        waitpid(child, &status, 0);
        const std::size_t frames = bytes_in(ends[0]);
        close(ends[0]);
        ASSERT_NO_FATAL_FAILURE(check_file(the_case, folder.path(), frames))
            << "after " << live_frames << " frames and " << die_after << " writes";
        if (!WIFSIGNALED(status)) {
            EXPECT_GT(die_after, 0) << "no write was seen: the trap does not work";
            return;
        }
    }
}

TEST(KilledWriter, AtEveryWriteOfTheFirstFrames)
{
    const Case the_case = synthetic::arch(Kinematics::spatial_deformable, 5);
    for (const int frames : {0, 1}) ASSERT_NO_FATAL_FAILURE(kill_at_every_write(the_case, frames));
}

TEST(KilledWriter, AtEveryWriteWhereChunksAreAdded)
{
    const Case the_case = synthetic::arch(Kinematics::spatial_deformable, 350);  // 8 rows to a chunk of places
    for (const int frames : {7, 8}) ASSERT_NO_FATAL_FAILURE(kill_at_every_write(the_case, frames));
}

/// Frames [first, end) with five steps between them, each with what a run can go on from.
void go_on(const Case& the_case, ResultsWriter& writer, int first, int end, int dies_at, long die_after)
{
    RunPosition position;
    for (int i = first; i < end; ++i) {
        if (i == dies_at) writes_left = die_after;
        for (int k = 4; k >= 0; --k) writer.history(synthetic::swaying(the_case, step * (i - 0.2 * k)), {}, {});
        const State state = synthetic::swaying(the_case, step * i);
        writer.frame(state, position.report);
        position.frames = i + 1;
        if (i > 0) position.reference = synthetic::swaying(the_case, 0).coordinates;  // as a run notes it
        writer.save(state, position, {});
        if (i == dies_at) writes_left = -1;
    }
    writer.finish(synthetic::swaying(the_case, step * end), {}, {});
}

constexpr int all_frames = 4;

/// Dies `die_after` changes of files into frame `dies_at`, goes on. @returns whether the child died
bool die_and_go_on(const Case& the_case, const std::filesystem::path& folder, int dies_at, long die_after)
{
    const pid_t child = in_child([&] {
        ResultsWriter writer(the_case, folder);
        go_on(the_case, writer, 0, all_frames, dies_at, die_after);
    });
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFSIGNALED(status)) return false;
    if (!std::filesystem::exists(restart_file_in(folder))) {
        EXPECT_EQ(dies_at, 0);
        ResultsWriter writer(the_case, folder);
        go_on(the_case, writer, 0, all_frames, -1, -1);
        return true;
    }
    const Restart restart = load_restart(restart_file_in(folder));
    EXPECT_GE(restart.position.frames, dies_at);
    ResultsWriter writer(the_case, folder, restart);
    go_on(the_case, writer, static_cast<int>(restart.position.frames), all_frames, -1, -1);
    return true;
}

TEST(KilledWriter, GoesOnFromEveryChangeOfAFile)
{
    Case the_case = synthetic::arch(Kinematics::spatial_rigid, 3);
    const TemporaryFolder whole;
    {
        ResultsWriter writer(the_case, whole.path());
        go_on(the_case, writer, 0, all_frames, -1, -1);
    }
    const auto right = every_dataset(whole / "results.h5");
    for (const int dies_at : {0, 1}) {
        bool died = true;
        long die_after = 0;
        for (; died && !HasFailure(); ++die_after) {
            const TemporaryFolder folder;
            died = die_and_go_on(the_case, folder.path(), dies_at, die_after);
            EXPECT_EQ(every_dataset(folder / "results.h5"), right) << dies_at << ", " << die_after;
        }
        EXPECT_GT(die_after, 20) << "the traps do not work";
    }
}

}  // namespace
}  // namespace voussoir::app::results
