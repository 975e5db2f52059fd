// When a run is saved: frames are cheap because most of them wait.
#include "app/commands/saver.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include "app/results/restart_file.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::commands
{
namespace
{

constexpr int frames = 50;

/// The frames of a run, with some time for each. @returns how often it was saved
int savings(double every, useconds_t time_for_a_frame)
{
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    const TemporaryFolder folder;
    results::ResultsWriter writer(the_case, folder.path());
    const Stopwatch stopwatch;
    Saver saver(writer, {0, {}, every}, stopwatch);
    RunPosition position;
    std::int64_t saved = 0;
    int count = 0;
    State state;
    for (int i = 0; i < frames; ++i) {
        state = synthetic::swaying(the_case, 0.01 * i);
        writer.add_frame(state, {});
        ++position.frames;
        usleep(time_for_a_frame);
        saver(state, position);
        const results::Restart restart = results::load_restart(results::restart_file_in(folder.path()));
        count += restart.position.frames != saved;
        saved = restart.position.frames;
    }
    position.report.outcome = Outcome::interrupted;
    saver(state, position);
    EXPECT_EQ(results::load_restart(results::restart_file_in(folder.path())).position.frames, frames);
    return count;
}

TEST(Saver, SavesTheFirstFrameAndTheEndHoweverQuickTheRun)
{
    EXPECT_EQ(savings(1000, 0), 1);
}

TEST(Saver, SavesEveryFrameWhereAsked)
{
    EXPECT_EQ(savings(0, 0), frames);
}

TEST(Saver, SavesAsOftenAsTheTimeSays)
{
    // 50 frames of 4 ms or more: every 50 ms at the latest but for one frame.
    const int count = savings(0.05, 4000);
    EXPECT_GE(count, 3);
    EXPECT_LE(count, frames / 2);
}

}  // namespace
}  // namespace voussoir::app::commands
