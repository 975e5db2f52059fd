// How far a run is: a bar with the remaining time on a terminal, a few plain lines elsewhere.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::app::commands
{

/// Watches the steps of a run and steers nothing.
class Progress
{
 public:
    Progress(const std::vector<Stage>& stages, bool quiet);
    ~Progress() { done(); }  // what is said when a run breaks begins on a line of its own

    void step(const State& state, const StepReport& step, const RunReport& report);
    void done();  // ends the bar's line

 private:
    using Clock = std::chrono::steady_clock;

    double share_done(const State& state) const;  // of the simulated time of all dynamic stages
    /// At the pace of the stage in this program: what an earlier one did before a resume does not count.
    std::string time_left(double share, Clock::time_point now) const;
    void draw_bar(const State& state, const StepReport& step, const RunReport& report, Clock::time_point now,
                  bool new_stage);
    void print_line(const State& state, const StepReport& step, const RunReport& report, Clock::time_point now,
                    bool new_stage);

    const std::vector<Stage>& stages_;
    double simulated_time_ = 0;  // s, of all dynamic stages
    bool quiet_ = false, on_terminal_ = false, line_open_ = false;
    int stage_ = -1, tenths_ = 0;  // of the last step, of the last line
    Clock::time_point told_, moving_since_;
    double share_when_moving_ = 0;
};

}  // namespace voussoir::app::commands
