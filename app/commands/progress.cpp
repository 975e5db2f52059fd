#include "app/commands/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/commands/say.h"
#include "app/commands/stopwatch.h"

namespace voussoir::app::commands
{
namespace
{

/// "earthquake: 4.20 of 10 s", or the unbalanced force of a static stage.
std::string where(const Stage& stage, const State& state, const StepReport& step)
{
    if (stage.type == StageType::dynamic)
        return fmt::format("{}: {:.2f} of {:g} s", stage.name, state.stage_time, stage.duration);
    return fmt::format("{}: unbalanced {:.1e} of the load", stage.name, step.inertia_ratio);
}

}  // namespace

Progress::Progress(const std::vector<Stage>& stages, bool quiet)
    : stages_(stages), quiet_(quiet), on_terminal_(isatty(STDOUT_FILENO) == 1), told_(Clock::now())
{
    for (const Stage& stage : stages) simulated_time_ += stage.type == StageType::dynamic ? stage.duration : 0;
}

double Progress::share_done(const State& state) const
{
    double done = 0;
    for (int i = 0; i <= state.stage && i < static_cast<int>(stages_.size()); ++i)
        if (stages_[i].type == StageType::dynamic)
            done += i < state.stage ? stages_[i].duration : state.stage_time;
    return simulated_time_ > 0 ? std::min(done / simulated_time_, 1.0) : 0;
}

void Progress::step(const State& state, const StepReport& step, const RunReport& report)
{
    if (quiet_ || state.stage >= static_cast<int>(stages_.size())) return;
    const Clock::time_point now = Clock::now();
    const bool new_stage = state.stage != stage_;
    if (new_stage) {  // static stages tell nothing about the pace of dynamic ones
        stage_ = state.stage;
        moving_since_ = now;
        share_when_moving_ = share_done(state);
    }
    if (on_terminal_)
        draw_bar(state, step, report, now, new_stage);
    else
        print_line(state, step, report, now, new_stage);
}

std::string Progress::time_left(double share, Clock::time_point now) const
{
    const double moved = share - share_when_moving_;
    if (moved <= 0.01 || share >= 1) return "";
    const double elapsed = std::chrono::duration<double>(now - moving_since_).count();
    return ", " + duration_in_words(elapsed * (1 - share) / moved) + " left";
}

void Progress::draw_bar(const State& state, const StepReport& step, const RunReport& report, Clock::time_point now,
                        bool new_stage)
{
    if (!new_stage && now - told_ < std::chrono::milliseconds(100)) return;
    told_ = now;
    constexpr int width = 30;
    const double share = share_done(state);
    const int filled = static_cast<int>(share * width);
    say_over(
        fmt::format("[{}{}] {:3.0f} %  {}, step {}{}", std::string(filled, '#'), std::string(width - filled, '.'),
                    100 * share, where(stages_[state.stage], state, step), report.steps, time_left(share, now)),
        false);
    std::fflush(stdout);
    line_open_ = true;
}

void Progress::print_line(const State& state, const StepReport& step, const RunReport& report,
                          Clock::time_point now, bool new_stage)
{
    const double share = share_done(state);
    const int tenths = static_cast<int>(10 * share);
    if (!new_stage && tenths == tenths_ && now - told_ < std::chrono::minutes(5)) return;
    tenths_ = tenths;
    told_ = now;
    say(fmt::format("{:3.0f} %  {}, step {}{}", std::floor(100 * share), where(stages_[state.stage], state, step),
                    report.steps, time_left(share, now)));
    std::fflush(stdout);
}

void Progress::done()
{
    if (line_open_) say("");
    line_open_ = false;
}

}  // namespace voussoir::app::commands
