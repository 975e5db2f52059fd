// Step problems: the state just before a step, and all that says how the step is to be made.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::app::problems
{

/// A case that names no other files, as it is read again.
struct CaseText {
    std::string text;                    // of the case file
    std::vector<std::string> overrides;  // "stages[1].time_step=1 ms"
    bool operator==(const CaseText&) const = default;
};

/// One step to be made. The state names the stage.
struct StoredStep {
    std::string name;               // unique in a file: "column.000120", its scene and the steps before it
    std::size_t case_index = 0;     // of Corpus::cases
    double time_step = 0;           // s, that is to be attempted
    std::int64_t increment = 0;     // of gravity, from 1: of static stages; 0: a step in time
    double force_tolerance = 0;     // -, as StepControl::force_tolerance
    std::vector<std::string> tags;  // words: what the model has, and what happened in the step
    State state;                    // just before the step
};

/// Step problems and the cases that they are taken from.
struct Corpus {
    std::vector<CaseText> cases;       // each once
    std::vector<StoredStep> problems;  // in the order in which they were taken
};

/// Adds all problems of another corpus; a case that both have stays there once.
void add(const Corpus& more, Corpus& corpus);

/// The case of a text. @throws InputError with the faults of the case, other files that it names among them
Case read(const CaseText& text);

/// The stage of a problem as its step sees it, on one thread.
/// @throws InputError when the problem is not one of this case
Stage stage_of(const StoredStep& problem, const Case& the_case);

}  // namespace voussoir::app::problems
