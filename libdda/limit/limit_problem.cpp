#include "libdda/limit/limit_problem.h"

#include <algorithm>
#include <cmath>

#include "libdda/analysis/bar_forces.h"
#include "libdda/model/friction_law.h"

namespace voussoir::limit
{

namespace
{

using Eigen::Vector3d;

template <int D>
void add_contacts(const Model& model, const State& state, double reach, FacePoints which, LimitProblem& problem)
{
    const ContactSetIn<D>& found = contacts_in<D>(state);
    for (const ContactPatchIn<D>& patch : found.patches) {
        const double near = reach * std::min(size_of(model, patch.block_a), size_of(model, patch.block_b));
        const double friction = friction_between(model, patch.block_a, patch.block_b, false).at_rest;
        const JointMaterial& joint = model.joint_between(patch.block_a, patch.block_b);
        double area = 0;
        for (const ContactPointIn<D>& point : points_of(found, patch)) area += point.area;
        const auto corners = corners_of(found, patch);
        const auto count = static_cast<double>(corners.size());
        for (const ContactPointIn<D>& point : which == FacePoints::all ? points_of(found, patch) : corners) {
            if (point.gap > near) continue;
            LimitContact contact{patch.block_a, patch.block_b, to_space(point.position), to_space(patch.normal),
                                 friction};
            if (which == FacePoints::all) contact.stiffness = count * point.area / area;
            const double share = patch.intact ? contact.stiffness * area / count : 0;
            contact.cohesion = share * joint.cohesion;
            contact.tension = share * joint.tensile_strength;
            if (contact.stiffness > 0) problem.contacts.push_back(contact);
        }
    }
}

void add_bars(const Model& model, const State& state, LimitProblem& problem)
{
    const std::vector<BarNow> now = bars_now(model, state);
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i].is_out) continue;
        const Bar& bar = model.bars[i];
        const Pose a = pose_of(model.kinematics, state, bar.block_a),
                   b = pose_of(model.kinematics, state, bar.block_b);
        LimitBar limit{bar.block_a, bar.block_b, a.centroid + a.map * bar.anchor_a,
                       b.centroid + b.map * bar.anchor_b};
        limit.axis =
            bar.is_rod ? (limit.end_b - limit.end_a).stableNormalized() : (a.map * bar.axis).stableNormalized();
        limit.tension = bar.tension;
        limit.compression = bar.compression;
        limit.shear = bar.is_rod ? 0 : bar.shear;
        problem.bars.push_back(limit);
    }
}

}  // namespace

LimitProblem limit_problem_of(const Model& model, const State& state, const Vector3d& dead, const Vector3d& live,
                              double reach, FacePoints points)
{
    LimitProblem problem;
    problem.planar = is_planar(model.kinematics);
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        LimitBlock block;
        block.centroid = pose_of(model.kinematics, state, b).centroid;
        block.dead = model.mass(b) * dead;
        block.live = model.mass(b) * live;
        problem.blocks.push_back(block);
    }
    for (const Foundation& foundation : model.foundations) {
        LimitBlock& block = problem.blocks[static_cast<std::size_t>(foundation.block)];
        block.held = foundation.translation_held;
        block.turning_held = foundation.rotation_held;
    }
    if (problem.planar)
        add_contacts<2>(model, state, reach, points, problem);
    else
        add_contacts<3>(model, state, reach, points, problem);
    add_bars(model, state, problem);
    return problem;
}

bool is_known_to_limit_analysis(const Model& model)
{
    return model.boundaries.empty();
}

}  // namespace voussoir::limit
