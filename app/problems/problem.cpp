#include "app/problems/problem.h"

#include <algorithm>

#include "app/reader/case_file.h"
#include "app/results/state_checks.h"
#include "libdda/errors.h"

namespace voussoir::app::problems
{

namespace
{

std::size_t place_of(const CaseText& text, std::vector<CaseText>& cases)
{
    const auto found = std::find(cases.begin(), cases.end(), text);
    const auto place = static_cast<std::size_t>(found - cases.begin());
    if (found == cases.end()) cases.push_back(text);
    return place;
}

bool is_of(const StoredStep& problem, const Case& the_case)
{
    const auto index = static_cast<std::size_t>(problem.state.stage);
    if (index >= the_case.stages.size() || !results::fits(problem.state, the_case.model)) return false;
    const Stage& stage = the_case.stages[index];
    const bool is_static = stage.type == StageType::static_equilibrium;
    return is_static ? problem.increment >= 1 && problem.increment <= stage.gravity_increments
                     : problem.increment == 0;
}

}  // namespace

void add(const Corpus& more, Corpus& corpus)
{
    for (StoredStep problem : more.problems) {
        problem.case_index = place_of(more.cases[problem.case_index], corpus.cases);
        corpus.problems.push_back(std::move(problem));
    }
}

Case read(const CaseText& text)
{
    // In a folder that nobody has, a case that names other files does not find them.
    return reader::read_case_text("/a step problem has no files/case.yaml", text.text, text.overrides);
}

Stage stage_of(const StoredStep& problem, const Case& the_case)
{
    if (!is_of(problem, the_case))
        throw InputError(problem.name, "the state of another model", "take the problems of this case again");
    Stage stage = the_case.stages[static_cast<std::size_t>(problem.state.stage)];
    stage.control.threads = 1;
    stage.control.force_tolerance = problem.force_tolerance;
    if (problem.increment > 0)
        stage.gravity = stage.gravity * static_cast<double>(problem.increment) / stage.gravity_increments;
    if (stage.control.step_error > 0) {  // steps that follow their error are as dissipative as they are long
        StepControl of_step = stage.control;
        of_step.time_step = problem.time_step;
        stage.control.dissipation = of_step.dissipation_used();
    }
    return stage;
}

}  // namespace voussoir::app::problems
