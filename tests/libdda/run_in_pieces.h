// A run that is stopped after every step and begun again from what was saved.
#pragma once

#include <gtest/gtest.h>

#include "libdda/run/run.h"

namespace voussoir::testing
{

/// Where it ended.
struct RunInPieces {
    State state;
    RunReport report;
    int pieces = 0;
};

/// @param state, position to begin from
inline RunInPieces run_in_pieces(const Model& model, const std::vector<Stage>& stages, const State& state,
                                 const RunPosition& position)
{
    constexpr int most = 2000;
    State saved_state = state;
    RunPosition saved = position;
    RunObserver observer;
    observer.stop = [] { return true; };
    observer.save = [&](const State& now, const RunPosition& at) {
        saved_state = now;
        saved = at;
    };
    RunInPieces ended;
    do {
        ended.state = saved_state;
        ended.report = run(model, stages, ended.state, observer, saved);
        ++ended.pieces;
    } while (ended.report.outcome == Outcome::interrupted && ended.pieces < most);
    return ended;
}

}  // namespace voussoir::testing
