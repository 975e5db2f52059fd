// The open-close iteration:
//
// 1. Guess: every contact keeps the state it had at the end of the last step; one linear solve.
// 2. Contacts and residual, friction at its bound mu N of the same iterate. All in equilibrium: 6.
// 3. Before the first direction, and where many contacts have changed their state: stones that are out of
//    balance are relaxed one by one.
// 4. A direction for all stones: by the whole tangent where few states change, else by the one with the
//    friction bound held, which leads down a convex potential.
// 5. Along it until what the forces do has halved, the whole of it where that will do; 2.
// 6. The bonded joint that most exceeds its strength breaks, and 2; none does, and the step is done.
//
// Source: docs/numerics.md 3.
#pragma once

#include "libdda/iterate/iteration.h"

namespace voussoir::step
{

/// Fills the report. @returns whether every block is in equilibrium within the tolerance
template <class K>
bool iterate_newton(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                    StepProblem<K>& problem, Iteration<K>& iteration, StepReport& report);

}  // namespace voussoir::step
