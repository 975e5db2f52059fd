#include "libdda/analysis/sliding.h"

#include "libdda/analysis/bar_forces.h"
#include "libdda/model/disjoint_sets.h"
#include "libdda/model/friction_law.h"

namespace voussoir
{

namespace
{

constexpr double mobilised = 0.99;  // of its friction, by a joint that slides

/// How a joint bears.
struct Bearing {
    double normal = 0;  // N
    bool slides = false;
};

template <int D>
Bearing bearing_of(const Model& model, const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch)
{
    const double friction = friction_between(model, patch.block_a, patch.block_b, false).at_rest;
    double normal = 0, rubbed = 0;
    for (const ContactPointIn<D>& point : points_of(contacts, patch)) {
        normal += point.normal_force;
        rubbed += point.shear_force.norm();
    }
    return {normal, friction > 0 && !patch.intact && rubbed >= mobilised * friction * normal};
}

/// Joins what sticks. @returns the joints that slide
template <int D>
std::vector<const ContactPatchIn<D>*> join(const Model& model, const ContactSetIn<D>& contacts, double least,
                                           DisjointSets& sets)
{
    std::vector<const ContactPatchIn<D>*> sliding;
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        const Bearing bearing = bearing_of(model, contacts, patch);
        if (bearing.slides && bearing.normal > least)
            sliding.push_back(&patch);
        else if (patch.intact || (bearing.normal > 0 && !bearing.slides))
            sets.join(patch.block_a, patch.block_b);
    }
    return sliding;
}

template <int D>
std::vector<int> held_by_sliding_joints(const Model& model, const State& state, const ContactSetIn<D>& contacts,
                                        double least)
{
    std::vector<int> held;
    if (model.foundations.empty()) return held;
    DisjointSets sets(model.blocks.size());
    const auto sliding = join(model, contacts, least, sets);
    if (sliding.empty()) return held;
    const std::vector<BarNow> bars = bars_now(model, state);
    for (std::size_t i = 0; i < bars.size(); ++i)
        if (bars[i].axial != 0 || bars[i].shear != 0) sets.join(model.bars[i].block_a, model.bars[i].block_b);
    const int ground = model.foundations.front().block;
    for (const Foundation& foundation : model.foundations) sets.join(foundation.block, ground);
    std::vector<bool> slides(model.blocks.size(), false);  // by the root of a part
    for (const ContactPatchIn<D>* patch : sliding)
        for (const int block : {patch->block_a, patch->block_b}) slides[sets.root_of(block)] = true;
    slides[sets.root_of(ground)] = false;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (slides[sets.root_of(b)]) held.push_back(b);
    return held;
}

}  // namespace

std::vector<int> held_by_sliding_joints(const Model& model, const State& state, double least)
{
    return is_planar(model.kinematics) ? held_by_sliding_joints(model, state, state.planar_contacts, least)
                                       : held_by_sliding_joints(model, state, state.contacts, least);
}

}  // namespace voussoir
