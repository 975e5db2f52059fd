// What an iteration works with beside the problem: solvers and scratch.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/iterate/directions.h"
#include "libdda/iterate/iteration_rules.h"
#include "libdda/iterate/relaxation.h"

namespace voussoir::step
{

/// Kept from step to step; nothing in it changes a result.
template <class K>
struct Iteration {
    IterationRules rules;
    Directions<K> directions;
    Relaxation<K> relaxation;
    std::vector<int> states;  // of contact points, as they were last noted
    Eigen::VectorXd trial;    // scratch

    /// To be called when a step is set up.
    void begin(const StepControl& control, const StepProblem<K>& problem)
    {
        directions.begin(control, problem);
        relaxation.begin();
    }
};

}  // namespace voussoir::step
