#include "libdda/analysis/joints_now.h"

#include <algorithm>
#include <set>
#include <utility>

namespace voussoir
{

namespace
{

using Pair = std::pair<int, int>;

template <int D>
void add_bonded(const ContactSetIn<D>& contacts, std::set<Pair>& bonded)
{
    for (const ContactPatchIn<D>& patch : contacts.patches)
        if (patch.intact) bonded.insert(std::minmax(patch.block_a, patch.block_b));
}

void add_resultant(const JointResultant& contact, JointNow& now)
{
    now.normal_force = contact.force.dot(contact.normal);
    now.shear_force = (contact.force - now.normal_force * contact.normal).norm();
    const Eigen::Vector3d off = contact.pressure_centre - contact.centre;
    now.eccentricity = (off - off.dot(contact.normal) * contact.normal).norm();
    now.area_in_use = contact.closed_area;
}

}  // namespace

std::vector<JointNow> joints_now(const Model& model, const std::vector<WatchedJoint>& joints, const State& state,
                                 const std::vector<JointResultant>& contacts)
{
    std::vector<JointNow> all;
    all.reserve(joints.size());
    std::set<Pair> bonded;
    add_bonded(state.contacts, bonded);
    add_bonded(state.planar_contacts, bonded);
    const std::vector<PlacedBlock> blocks = placed_blocks(model, state);
    auto contact = contacts.begin();  // both lists ascend
    for (const WatchedJoint& joint : joints) {
        const Pair pair(joint.block_a, joint.block_b);
        JointNow now;
        now.motion = motion_of(joint, blocks);
        while (contact != contacts.end() && Pair(contact->block_a, contact->block_b) < pair) ++contact;
        if (contact != contacts.end() && Pair(contact->block_a, contact->block_b) == pair)
            add_resultant(*contact, now);
        now.broken = joint.bonded && state.step > 0 && !bonded.contains(pair);
        all.push_back(now);
    }
    return all;
}

}  // namespace voussoir
