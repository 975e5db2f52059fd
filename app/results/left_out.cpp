#include <algorithm>

#include "app/results/results_writer.h"

namespace voussoir::app::results
{

namespace
{

template <typename Predicate>
bool any_stage(const Case& the_case, Predicate predicate)
{
    return std::any_of(the_case.stages.begin(), the_case.stages.end(), predicate);
}

template <typename Predicate>
bool any_joint(const Case& the_case, Predicate predicate)
{
    return std::any_of(the_case.model.joints.begin(), the_case.model.joints.end(), predicate);
}

template <typename Predicate>
bool any_material(const Case& the_case, Predicate predicate)
{
    return std::any_of(the_case.model.materials.begin(), the_case.model.materials.end(), predicate);
}

}  // namespace

std::vector<std::string> left_out(const Case& the_case)
{
    std::vector<std::string> words;
    const auto leave_out = [&](bool absent, const char* what) {
        if (absent) words.emplace_back(what);
    };
    leave_out(is_planar(the_case.model.kinematics), "the third dimension (the scene is planar)");
    leave_out(!is_deformable(the_case.model.kinematics), "strains and stresses (the blocks are rigid)");
    leave_out(the_case.mesh_files.empty(), "mesh importers (no mesh is read)");
    leave_out(the_case.model.foundations.empty(), "foundations (no block follows the ground)");
    leave_out(!any_stage(the_case, [](const Stage& s) { return !s.motions.empty(); }),
              "ground motion (no foundation is moved)");
    leave_out(!any_stage(the_case, [](const Stage& s) { return !s.body_accelerations.empty(); }),
              "body accelerations (no stage has one)");
    leave_out(!any_joint(the_case, [](const JointMaterial& j) { return j.has_strength(); }),
              "cohesion and tensile strength (all joints are dry)");
    leave_out(!any_joint(the_case, [](const JointMaterial& j) { return j.relaxation_time > 0; }),
              "contact damping (no joint has a relaxation time)");
    leave_out(!any_joint(the_case, [](const JointMaterial& j) { return j.has_landing_law(); }),
              "impulses of landing stones (no joint has a restitution)");
    leave_out(any_stage(the_case,
                        [](const Stage& s) {
                            return s.type == StageType::dynamic && s.control.integrator == Integrator::newmark;
                        }),
              "impulses of landing stones where the integrator is newmark (impacts are left to the springs)");
    leave_out(
        !any_stage(the_case, [](const Stage& s) { return s.damping.rate != 0 || s.damping.factor_per_step != 1; }),
        "kinetic damping (no stage has any)");
    leave_out(!any_material(the_case, [](const BlockMaterial& m) { return m.rayleigh.any(); }),
              "Rayleigh damping (no material has any)");
    leave_out(!any_material(the_case, [](const BlockMaterial& m) { return !m.branches.empty(); }),
              "hysteretic damping (no material has any)");
    leave_out(the_case.model.bars.empty(), "bars (no metal is between stones)");
    leave_out(the_case.model.boundaries.empty(), "viscous boundaries (no face of a block is one)");
    leave_out(the_case.output.histories.empty() && the_case.output.bar_histories.empty(),
              "histories (no points are requested)");
    leave_out(!the_case.output.snapshots && !the_case.output.film && !the_case.output.report,
              "renderer (no snapshots are requested)");
    return words;
}

}  // namespace voussoir::app::results
