// When a run writes what waits in memory, and what it can go on from.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "app/commands/stopwatch.h"
#include "app/results/results_writer.h"
#include "libdda/run/run.h"

namespace voussoir::app::commands
{

/// A run is saved with its first frame, at its end, when much waits in memory, and else every few seconds of
/// computing: putting a file on the disk takes longer than the frame of a small scene.
class Saver
{
 public:
    struct Begin {
        std::int64_t frames = 0;      // so far
        results::CommandTimes times;  // of the commands before this one
        double every = 2;             // s of computing between two savings; 0: with every frame
    };
    Saver(results::ResultsWriter& writer, const Begin& begin, const Stopwatch& stopwatch)
        : writer_(writer), begin_(begin), stopwatch_(stopwatch), frames_(begin.frames)
    {
    }
    /// Called after each frame and after each static step, which has none.
    void operator()(const State& state, const RunPosition& position);
    /// Of all commands so far.
    results::CommandTimes times() const;

 private:
    bool is_due(const RunPosition& position) const;

    results::ResultsWriter& writer_;
    Begin begin_;
    const Stopwatch& stopwatch_;
    std::int64_t frames_ = 0;  // when it was saved last
    std::optional<std::chrono::steady_clock::time_point> saved_;
};

}  // namespace voussoir::app::commands
