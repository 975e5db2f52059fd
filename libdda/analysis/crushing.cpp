#include "libdda/analysis/crushing.h"

#include <algorithm>
#include <limits>

#include "libdda/analysis/joint_resultants.h"

namespace voussoir
{

namespace
{

/// Of the weaker of the two stones [Pa]; infinity when neither has one.
double strength_between(const Model& model, int block_a, int block_b)
{
    double strength = std::numeric_limits<double>::infinity();
    for (const int block : {block_a, block_b}) {
        const double own = model.materials[model.blocks[block].material].compressive_strength;
        if (own > 0) strength = std::min(strength, own);
    }
    return strength;
}

}  // namespace

bool has_compressive_strength(const Model& model)
{
    return std::any_of(model.materials.begin(), model.materials.end(),
                       [](const BlockMaterial& material) { return material.compressive_strength > 0; });
}

void note_crushing(const Model& model, const State& state, RunReport& report)
{
    for (const JointResultant& joint : joint_resultants(model, state)) {
        const double strength = strength_between(model, joint.block_a, joint.block_b);
        const double stress = joint.edge_stress;
        if (!(stress > strength)) continue;
        auto known = std::find_if(report.crushed.begin(), report.crushed.end(), [&](const CrushedJoint& crushed) {
            return crushed.block_a == joint.block_a && crushed.block_b == joint.block_b;
        });
        if (known == report.crushed.end())
            known = report.crushed.insert(known, {joint.block_a, joint.block_b, strength, state.time, 0, 0});
        if (stress <= known->worst_stress) continue;
        known->worst_stress = stress;
        known->worst_time = state.time;
    }
}

std::optional<Diagnosis> crushed_warning(const RunReport& report)
{
    if (report.crushed.empty()) return std::nullopt;
    const CrushedJoint& worst = *std::max_element(
        report.crushed.begin(), report.crushed.end(), [](const CrushedJoint& a, const CrushedJoint& b) {
            return a.worst_stress / a.strength < b.worst_stress / b.strength;
        });
    return Diagnosis{
        DiagnosisKind::crushed_joints,
        -1,
        {worst.block_a, worst.block_b},
        {static_cast<double>(report.crushed.size()), worst.worst_stress / worst.strength, worst.worst_time}};
}

}  // namespace voussoir
