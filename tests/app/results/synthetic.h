// Small made-up cases and states whose every number is known: what goes into a file must come out.
#pragma once

#include <filesystem>

#include "app/reader/case_file.h"
#include "libdda/model/state.h"

namespace voussoir::synthetic
{

/// A half-round arch of `voussoirs` stones (4 m inner radius, 1 m thick, 2 m wide) on two foundation blocks.
/// Two stages, a history point at the crown, no motion. Planar scenes have the outlines, 2 m thick.
app::Case arch(Kinematics kinematics, int voussoirs = 15);

/// A tower of boxes on one foundation block, no stages with damping, no histories.
app::Case tower(Kinematics kinematics, int boxes = 8);

/// A state that sways, strains (deformable) and opens and slides some joints, more so with time [s].
State swaying(const app::Case& the_case, double time);

}  // namespace voussoir::synthetic
