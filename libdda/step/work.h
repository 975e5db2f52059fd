// What a step works on, per kinematics: the inside of a Workspace.
#pragma once

#include <variant>
#include <vector>

#include "libdda/contact/find_contacts.h"
#include "libdda/iterate/iteration.h"
#include "libdda/problem/step_problem.h"
#include "libdda/step/reach.h"
#include "libdda/step/workspace.h"

namespace voussoir
{

/// What a scene of one kinematics works on.
template <class K>
struct Work {
    contact::SearchMemory<K::dimension> search;
    std::vector<step::Extent> extents;  // of the blocks
    std::vector<double> reach;          // m, of the blocks
    ContactSetIn<K::dimension> contacts;
    std::vector<step::Jump<K>> jumps;  // of blocks that land in the step
    step::StepProblem<K> problem;
    step::Iteration<K> iteration;
};

struct Workspace::Implementation {
    std::variant<Work<step::SpatialDeformable>, Work<step::SpatialRigid>, Work<step::PlanarDeformable>,
                 Work<step::PlanarRigid>>
        work;
};

}  // namespace voussoir
