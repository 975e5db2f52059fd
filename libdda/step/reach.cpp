#include "libdda/step/reach.h"

#include <algorithm>
#include <cmath>

#include "libdda/block/kinematics_traits.h"
#include "libdda/contact/find_contacts.h"

namespace voussoir::step
{

template <int D>
std::vector<Extent> extents_of(const Model& model)
{
    std::vector<Extent> extents;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        double square = 0;
        for (const auto& part : contact::ShapeIn<D>::of(model.blocks[b]))
            for (const VectorIn<D>& x : part.vertices) square = std::max(square, x.squaredNorm());
        extents.push_back({std::sqrt(square), size_of(model, static_cast<int>(b))});
    }
    return extents;
}

namespace
{

/// Joints are as wide as drawn: at the start up to the tolerance, later as far as their stones were apart then.
template <int D>
void add_fit(const Model& model, const State& state, std::vector<double>& reach)
{
    if (model.fit_tolerance == 0) return;
    std::vector<double> widest(reach.size(), state.step == 0 ? model.fit_tolerance : 0);
    const auto& contacts = contacts_in<D>(state);
    for (const ContactPatchIn<D>& patch : contacts.patches)
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            for (const int block : {patch.block_a, patch.block_b})
                widest[block] = std::max(widest[block], contacts.points[i].rest_gap);
    for (std::size_t b = 0; b < reach.size(); ++b) reach[b] += widest[b] / 2;  // one half from either stone
}

}  // namespace

template <class K>
void find_reach(const Model& model, const Stage& stage, const State& state, double h,
                const std::vector<Extent>& extents, std::vector<double>& reach)
{
    constexpr int n = K::unknowns, dimension = K::dimension;
    double dashpot = 0;
    for (const JointMaterial& joint : model.joints) dashpot = std::max(dashpot, joint.relaxation_time);
    const double gravity =
        std::max(stage.gravity.norm(), stage.gravity_ramp.duration > 0 ? stage.gravity_ramp.from.norm() : 0);
    reach.resize(model.blocks.size());
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const double* v = state.velocities.data() + b * n;
        double turning = 0;
        for (int k = dimension; k < n; ++k) turning += v[k] * v[k];
        const double speed = typename K::Vector(v).norm() + std::sqrt(turning) * extents[b].radius;
        reach[b] = (h + dashpot) * speed + h * h * gravity * (stage.type == StageType::dynamic) +
                   contact::contact_distance * extents[b].size;
    }
    add_fit<dimension>(model, state, reach);
    // A bond lasts until its strength breaks it, however soft it is: it is looked for as far as it has stretched.
    const auto& contacts = contacts_in<dimension>(state);
    for (const ContactPatchIn<dimension>& patch : contacts.patches) {
        if (!patch.intact) continue;
        double stretched = 0;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            stretched = std::max(stretched, contacts.points[i].gap + contacts.points[i].rest_gap);
        reach[patch.block_a] += stretched;
    }
    for (const FoundationMotion& motion : stage.motions) {
        const double from = motion.motion->displacement(state.stage_time);
        const double to = motion.motion->displacement(state.stage_time + h);
        reach[model.foundations[motion.foundation].block] += std::abs(to - from);
    }
}

template std::vector<Extent> extents_of<2>(const Model&);
template std::vector<Extent> extents_of<3>(const Model&);

#define VOUSSOIR_INSTANTIATE(K)                                                                               \
    template void find_reach<K>(const Model&, const Stage&, const State&, double, const std::vector<Extent>&, \
                                std::vector<double>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
