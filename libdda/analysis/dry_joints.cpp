#include "libdda/analysis/dry_joints.h"
#include "libdda/contact/initial_contacts.h"

#include <algorithm>
#include <sstream>

namespace voussoir
{

namespace
{

// Of the smaller block's size: stones that gape by more meet along an edge, as they may be meant to.
constexpr double widest_joint = 0.01;

struct DryJoints {
    int count = 0;
    double widest = 0;  // m
    int block_a = -1, block_b = -1;
};

template <int D>
DryJoints dry_joints(const Model& model, const ContactSetIn<D>& contacts)
{
    DryJoints dry;
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        if (patch.intact || !model.joint_between(patch.block_a, patch.block_b).has_strength()) continue;
        double gap = 0;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            gap = std::max(gap, contacts.points[i].gap);
        if (gap > widest_joint * std::min(size_of(model, patch.block_a), size_of(model, patch.block_b))) continue;
        if (dry.count++ == 0 || gap > dry.widest) {
            dry.widest = gap;
            dry.block_a = patch.block_a;
            dry.block_b = patch.block_b;
        }
    }
    return dry;
}

}  // namespace

std::optional<Diagnosis> dry_joints_warning(const Model& model, const State& start)
{
    if (start.step > 0) return std::nullopt;  // bonds are made at the start alone; what is dry now may have broken
    if (std::none_of(model.joints.begin(), model.joints.end(),
                     [](const JointMaterial& joint) { return joint.has_strength(); }))
        return std::nullopt;
    State touching = start;
    find_initial_contacts(model, touching);
    const DryJoints dry = is_planar(model.kinematics) ? dry_joints(model, touching.planar_contacts)
                                                      : dry_joints(model, touching.contacts);
    if (dry.count == 0) return std::nullopt;
    return Diagnosis{
        DiagnosisKind::dry_joints, -1, {dry.block_a, dry.block_b}, {static_cast<double>(dry.count), dry.widest}};
}

}  // namespace voussoir
