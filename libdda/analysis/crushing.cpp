#include "libdda/analysis/crushing.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>
#include <vector>

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

void add_time(double elapsed, CrushedJoint& joint)
{
    if (elapsed == 0) joint.at_rest = true;
    joint.duration += elapsed;
    joint.stretch += elapsed;
    joint.longest = std::max(joint.longest, joint.stretch);
}

}  // namespace

bool has_compressive_strength(const Model& model)
{
    return std::any_of(model.materials.begin(), model.materials.end(),
                       [](const BlockMaterial& material) { return material.compressive_strength > 0; });
}

void note_crushing(const Model& model, const State& state, double elapsed, RunReport& report)
{
    std::vector<bool> is_above(report.crushed.size(), false);
    for (const JointResultant& joint : joint_resultants(model, state)) {
        const double strength = strength_between(model, joint.block_a, joint.block_b);
        if (!(joint.edge_stress > strength)) continue;
        auto known = std::find_if(report.crushed.begin(), report.crushed.end(), [&](const CrushedJoint& crushed) {
            return crushed.block_a == joint.block_a && crushed.block_b == joint.block_b;
        });
        if (known == report.crushed.end()) {
            report.crushed.push_back({joint.block_a, joint.block_b, strength, state.time});
            known = report.crushed.end() - 1;
            is_above.push_back(true);
        }
        is_above[known - report.crushed.begin()] = true;
        add_time(elapsed, *known);
        if (joint.edge_stress <= known->worst_stress) continue;
        known->worst_stress = joint.edge_stress;
        known->worst_time = state.time;
    }
    for (std::size_t i = 0; i < is_above.size(); ++i)
        if (!is_above[i]) report.crushed[i].stretch = 0;
}

bool is_lasting(const CrushedJoint& joint)
{
    return joint.at_rest || joint.longest > (1 + 1e-9) * longest_impact;
}

std::optional<Diagnosis> crushed_warning(const RunReport& report)
{
    std::vector<CrushedJoint> lasting;
    std::copy_if(report.crushed.begin(), report.crushed.end(), std::back_inserter(lasting), is_lasting);
    if (lasting.empty()) return std::nullopt;
    const auto severity = [](const CrushedJoint& joint) {
        return std::make_tuple(joint.duration, joint.worst_stress / joint.strength);
    };
    const CrushedJoint& worst =
        *std::max_element(lasting.begin(), lasting.end(),
                          [&](const CrushedJoint& a, const CrushedJoint& b) { return severity(a) < severity(b); });
    return Diagnosis{DiagnosisKind::crushed_joints,
                     -1,
                     {worst.block_a, worst.block_b},
                     {static_cast<double>(lasting.size()), worst.worst_stress / worst.strength, worst.worst_time,
                      worst.duration, static_cast<double>(report.crushed.size() - lasting.size())}};
}

}  // namespace voussoir
