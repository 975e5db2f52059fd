#include "libdda/step/published.h"

namespace voussoir::step
{

namespace
{
constexpr int passes = 6;
}

template <class K>
bool iterate_published(const Stage& stage, StepSystem<K>& system, StepReport& report)
{
    for (int pass = 0; pass < passes; ++pass) {
        // With the springs given the equations are linear but for finite strains: one solve.
        evaluate_published(system.d, stage.control.threads, system.contacts);
        if (!evaluate_residual(system.d, system)) return false;
        if (!solve_direction(stage.control, true, 1, system, report)) return false;
        ++report.open_close_iterations;
        system.d += system.direction;
        evaluate_published(system.d, stage.control.threads, system.contacts);
        if (!evaluate_residual(system.d, system) || !system.d.allFinite()) return false;
        if (!switch_published(system.contacts)) {
            // The forces that were solved with are the accepted ones: a sliding point keeps the load of this pass.
            return true;
        }
    }
    report.trouble = Trouble::chatter;
    return false;
}

#define VOUSSOIR_INSTANTIATE(K) template bool iterate_published(const Stage&, StepSystem<K>&, StepReport&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
