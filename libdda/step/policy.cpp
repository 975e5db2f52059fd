#include "libdda/step/policy.h"

namespace voussoir::step
{

namespace
{

/// Whether blocks keep their velocities and contacts are iterated on as they are, not as published.
bool follows_motion(const Stage& stage)
{
    return stage.type == StageType::dynamic && !stage.control.is_published();
}

}  // namespace

contact::NewOverlap new_overlaps_in(const Model& model, const Stage& stage, const State& state)
{
    // In static stages a new overlap presses; what that gives is gone with the velocity. The published iteration
    // takes contacts as they are. In the first step of a run an overlap is the model's own. Stones that do not fit
    // as drawn overlap wherever their contact goes over to another face or part: that presses in no stage.
    const bool is_drawn = model.fit_tolerance > 0 && !stage.control.is_published();
    return (follows_motion(stage) || is_drawn) && state.step > 0 ? contact::NewOverlap::forgiven
                                                                 : contact::NewOverlap::presses;
}

bool may_divide(const Stage& stage, int moving)
{
    return moving <= stage.control.divide_up_to_blocks;
}

bool stones_land(const Stage& stage)
{
    // The impulses belong to the motion of the whole step. Newmark's forces are those of its end alone: their work
    // on the jumps in it would be a gain of energy, which grows with the stiffness of the joints.
    return follows_motion(stage) && stage.control.integrator != Integrator::newmark;
}

}  // namespace voussoir::step
