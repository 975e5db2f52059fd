#include "libdda/iterate/published.h"

namespace voussoir::step
{

namespace
{
constexpr int passes = 6;
}

template <class K>
bool iterate_published(StepProblem<K>& problem, Directions<K>& directions, StepReport& report)
{
    for (int pass = 0; pass < passes; ++pass) {
        // With the springs given the equations are linear but for finite strains: one solve.
        evaluate_published(problem.d, problem.patch_threads, problem.contacts);
        if (!evaluate_residual(problem.d, problem)) return false;
        if (!directions.find(true, problem, report)) return false;
        ++report.open_close_iterations;
        problem.d += directions.direction;
        evaluate_published(problem.d, problem.patch_threads, problem.contacts);
        if (!evaluate_residual(problem.d, problem) || !problem.d.allFinite()) return false;
        if (!switch_published(problem.contacts)) {
            // The forces that were solved with are the accepted ones: a sliding point keeps the load of this pass.
            return true;
        }
    }
    report.trouble = Trouble::chatter;
    return false;
}

#define VOUSSOIR_INSTANTIATE(K) template bool iterate_published(StepProblem<K>&, Directions<K>&, StepReport&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
