#include "app/commands/saver.h"

#include <algorithm>

namespace voussoir::app::commands
{

bool Saver::is_due(const RunPosition& position) const
{
    constexpr double between_static_steps = 2;  // s: there are thousands of them, and no time passes
    if (!saved_ || position.report.outcome != Outcome::completed || writer_.is_full()) return true;
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - *saved_;
    return since.count() >=
           (position.frames == frames_ ? std::max(begin_.every, between_static_steps) : begin_.every);
}

void Saver::operator()(const State& state, const RunPosition& position)
{
    if (!is_due(position)) return;
    writer_.save(state, position, times());
    frames_ = position.frames;
    saved_ = std::chrono::steady_clock::now();
}

results::CommandTimes Saver::times() const
{
    return {begin_.times.wall + stopwatch_.wall_time(), begin_.times.cpu + Stopwatch::cpu_time()};
}

}  // namespace voussoir::app::commands
