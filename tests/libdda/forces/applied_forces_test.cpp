// A scene without boundaries, ties and damping of its blocks carries nothing of them.
#include "libdda/forces/applied_forces.h"

#include <gtest/gtest.h>

#include "libdda/problem/step_problem.h"
#include "tests/libdda/ground_scenes.h"

namespace voussoir::testing
{

namespace
{

/// What the first step of a scene holds in memory for the ground around it: bytes.
template <class K>
std::size_t bytes_for_the_ground(const Model& model, const Stage& stage)
{
    const State state = initial_state(model);
    step::StepProblem<K> system;
    step::assemble_blocks<K>(model, stage, state, {}, stage.control.time_step, {}, system);
    const auto bytes = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    return bytes(system.others.applied.own) + bytes(system.others.applied.couplings) +
           bytes(system.others.applied.ties) + bytes(state.boundary_reactions) + bytes(state.branch_strains);
}

class AppliedForces : public ::testing::TestWithParam<Kinematics>
{
 protected:
    std::size_t bytes(const Model& model, const Stage& stage) const
    {
        switch (GetParam()) {
            case Kinematics::planar_rigid:
                return bytes_for_the_ground<step::PlanarRigid>(model, stage);
            case Kinematics::planar_deformable:
                return bytes_for_the_ground<step::PlanarDeformable>(model, stage);
            case Kinematics::spatial_rigid:
                return bytes_for_the_ground<step::SpatialRigid>(model, stage);
            case Kinematics::spatial_deformable:
                return bytes_for_the_ground<step::SpatialDeformable>(model, stage);
        }
        return 0;
    }
};
INSTANTIATE_TEST_SUITE_P(Kinematics, AppliedForces, every_kinematics(), test_name);

}  // namespace

TEST_P(AppliedForces, TakeNoMemoryInASceneWithoutThem)
{
    EXPECT_EQ(bytes(grid(GetParam(), 4, 3), dynamic_stage(1, 1e-3)), 0U);
}

TEST_P(AppliedForces, TakeMemoryWhereABoundaryIs)
{
    if (!is_deformable(GetParam())) return;  // rigid blocks have no boundaries
    Model model = grid(GetParam(), 4, 3);
    model.boundaries = {base_of(model, 4)};
    EXPECT_GT(bytes(model, dynamic_stage(1, 1e-3)), 0U);
}

}  // namespace voussoir::testing
