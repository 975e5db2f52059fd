#include "libdda/analysis/verdict.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "libdda/analysis/bar_forces.h"
#include "libdda/analysis/ground.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/model/disjoint_sets.h"

namespace voussoir
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Pair = std::pair<int, int>;

constexpr double near = 0.5;  // of the size of the smaller stone: what has moved by less is where it was
constexpr double half = 0.5;  // of the mass

/// How the foot of the structure has moved since the first motion began, and moves.
struct FootMotion {
    Vector3d displacement = Vector3d::Zero(), velocity = Vector3d::Zero();  // m, m/s
};

/// Blocks at a given time, and the rotations that brought them there from those of the reference.
struct Places {
    std::vector<PlacedBlock> start, reference, now;
    std::vector<Matrix3d> turned;  // since the start

    Places(const Model& model, const RunStart& from, const State& state) : now(placed_blocks(model, state))
    {
        State before;
        before.coordinates = from.start;
        start = placed_blocks(model, before);
        reference = start;
        if (!from.reference.empty()) {
            before.coordinates = from.reference;
            reference = placed_blocks(model, before);
        }
        for (std::size_t b = 0; b < now.size(); ++b) turned.push_back(rotation(now[b], start[b]));
    }

    static Matrix3d rotation(const PlacedBlock& to, const PlacedBlock& from)
    {
        const Eigen::JacobiSVD<Matrix3d> parts(to.pose.map * from.pose.map.inverse(),
                                               Eigen::ComputeFullU | Eigen::ComputeFullV);
        return parts.matrixU() * parts.matrixV().transpose();
    }
};

double angle_between(const Vector3d& one, const Vector3d& other)
{
    return std::atan2(one.cross(other).norm(), one.dot(other));
}

FootMotion foot_motion(const Model& model, const std::vector<WatchedJoint>& joints, const RunStart& from,
                       const State& state)
{
    const Foot foot(model, joints);
    State before;
    before.coordinates = from.reference.empty() ? from.start : from.reference;
    return {foot.displacement(model, state) - foot.displacement(model, before), foot.velocity(model, state)};
}

template <int D>
std::set<Pair> touching(const ContactSetIn<D>& contacts, bool closed)
{
    std::set<Pair> pairs;
    for (const ContactPatchIn<D>& patch : contacts.patches)
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            if (!closed || contacts.points[i].status != ContactStatus::open)
                pairs.insert(std::minmax(patch.block_a, patch.block_b));
    return pairs;
}

std::set<Pair> touching(const Model& model, const State& state, bool closed)
{
    return is_planar(model.kinematics) ? touching(state.planar_contacts, closed)
                                       : touching(state.contacts, closed);
}

/// Which joints of the start hold.
class Joints
{
 public:
    Joints(const Model& model, const std::vector<WatchedJoint>& watched, const std::vector<double>& from,
           const Vector3d& down, const Places& places, const State& state)
        : model_(model), down_(down), places_(places), touch_(touching(model, state, true))
    {
        State start = initial_state(model);
        start.coordinates = from;
        find_initial_contacts(model, start);
        for (const Pair& pair : touching(model, start, false)) pairs_[pair] = nullptr;
        for (const WatchedJoint& joint : watched) pairs_[{joint.block_a, joint.block_b}] = &joint;
    }

    const std::map<Pair, const WatchedJoint*>& all() const { return pairs_; }

    bool holds(const Pair& pair, const WatchedJoint* joint) const
    {
        const auto& [a, b] = pair;
        const Vector3d normal = joint != nullptr ? joint->normal : down_;
        if (angle_between(places_.turned[a] * normal, places_.turned[b] * normal) > overturning_tilt) return false;
        const double enough = near * smaller(a, b);
        if (joint != nullptr) {
            const JointMotion motion = motion_of(*joint, places_.now);
            if (std::hypot(motion.opening, motion.largest_slip) < enough) return true;
        }
        if (!touch_.contains(pair)) return false;
        const bool is_bed = std::abs(normal.dot(down_)) > bed;  // on it a stone slides, along the rest it falls
        return is_bed || std::abs(down_.dot(gone(a) - gone(b))) < enough;
    }

 private:
    double smaller(int a, int b) const { return std::min(size_of(model_, a), size_of(model_, b)); }
    Vector3d gone(int b) const { return places_.now[b].pose.centroid - places_.start[b].pose.centroid; }

    const Model& model_;
    Vector3d down_;
    const Places& places_;
    std::set<Pair> touch_;                       // now
    std::map<Pair, const WatchedJoint*> pairs_;  // of the start; those that touch at edges have no joint
};

/// Blocks that the ground carries through these joints and bars.
template <class Holds>
std::vector<bool> carried(const Model& model, const Joints& joints, const Holds& holds,
                          const std::vector<BarNow>& bars)
{
    DisjointSets sets(model.blocks.size());
    for (const auto& [pair, joint] : joints.all())
        if (holds(pair, joint)) sets.join(pair.first, pair.second);
    for (std::size_t i = 0; i < model.bars.size(); ++i)
        if (bars.empty() || !bars[i].is_out) sets.join(model.bars[i].block_a, model.bars[i].block_b);
    std::vector<bool> is_ground(model.blocks.size(), false), result(is_ground);
    for (const int b : blocks_held_by_ground(model)) is_ground[sets.root_of(b)] = true;
    for (std::size_t b = 0; b < result.size(); ++b) result[b] = is_ground[sets.root_of(static_cast<int>(b))];
    return result;
}

void find_lost(const Model& model, const Joints& joints, const Vector3d& down, const Places& places,
               const State& state, const std::vector<bool>& is_ground, Verdict& verdict)
{
    const auto always = [](const Pair&, const WatchedJoint*) { return true; };
    const auto now = [&](const Pair& pair, const WatchedJoint* joint) { return joints.holds(pair, joint); };
    std::vector<bool> before = carried(model, joints, always, {});
    for (const InitialMotion& motion : model.initial_motions) before[motion.block] = false;  // it is thrown
    const std::vector<bool> after = carried(model, joints, now, bars_now(model, state));
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        if (!before[b] || is_ground[b]) continue;
        verdict.mass += model.mass(b);
        const bool leans = angle_between(places.turned[b] * down, down) > overturning_tilt;
        if (!after[b] || leans) verdict.lost.push_back(b);
    }
}

/// By what is lost and what moves.
void judge(const Model& model, Verdict& verdict)
{
    double gone = 0;
    for (const int b : verdict.lost) gone += model.mass(b);
    verdict.lost_share = gone > 0 ? std::min(1.0, gone / std::max(gone, verdict.mass)) : 0;
    verdict.standing = verdict.lost_share >= half ? Standing::fallen
                       : !verdict.lost.empty()    ? Standing::lost_stones
                       : verdict.fastest >= 0     ? Standing::moves
                                                  : Standing::stands;
}

/// Marks what is lost besides the ground.
std::vector<bool> with_lost(std::vector<bool> marks, const Verdict& verdict)
{
    for (const int b : verdict.lost) marks[b] = true;
    return marks;
}

/// The fastest of the blocks, by its speed over that which is slow for its size. @param leave marks of blocks
void find_fastest(const Model& model, double gravity, const FootMotion& foot, const State& state,
                  const std::vector<bool>& leave, Verdict& verdict)
{
    double most = 1;
    for (int b = 0; b < static_cast<int>(leave.size()); ++b) {
        if (leave[b]) continue;
        const double size = size_of(model, b), slow = slow_end * std::sqrt(gravity * size);
        const double speed = (velocity_of(model.kinematics, state, b) - foot.velocity).norm() +
                             0.5 * size * angular_velocity_of(model, state, b).norm();
        if (speed <= most * slow) continue;
        most = speed / slow;
        verdict.fastest = b;
        verdict.speed = speed;
    }
}

/// Twice the time in which something as high as the scene falls over.
double time_to_see(const Model& model, const Vector3d& down, double gravity, const Places& places)
{
    double low = 0, high = 0;
    for (std::size_t b = 0; b < places.start.size(); ++b) {
        const double at = down.dot(places.start[b].pose.centroid);
        const double reach = 0.5 * size_of(model, static_cast<int>(b));
        low = b == 0 ? at - reach : std::min(low, at - reach);
        high = b == 0 ? at + reach : std::max(high, at + reach);
    }
    return std::max(1.0, std::ceil(4 * std::sqrt((high - low) / gravity)));
}

/// @param lost marks of what is lost @param is_ground joints within the ground are no damage
void find_worst_joint(const Model& model, const std::vector<WatchedJoint>& joints, const Places& places,
                      const std::vector<bool>& is_ground, const std::vector<bool>& leave, Verdict& verdict)
{
    for (const WatchedJoint& joint : joints) {
        const int a = joint.block_a, b = joint.block_b;
        const bool is_within_ground = is_ground[a] && is_ground[b];
        const bool is_lost = (leave[a] && !is_ground[a]) || (leave[b] && !is_ground[b]);
        if (is_within_ground || is_lost) continue;
        const JointMotion moved = since(motion_of(joint, places.reference), motion_of(joint, places.now));
        const double opening = moved.opening, slip = moved.largest_slip;
        const double share = std::max(opening, slip) / std::min(size_of(model, a), size_of(model, b));
        if (share > verdict.worst.share) verdict.worst = {a, b, opening, slip, share};
    }
    const double share = verdict.worst.share;
    verdict.damage = share < limited_deformation  ? DamageLevel::none
                     : share < light_damage       ? DamageLevel::limited_deformation
                     : share < significant_damage ? DamageLevel::light_damage
                                                  : DamageLevel::significant_damage;
}

}  // namespace

std::optional<Verdict> verdict_of(const Model& model, const std::vector<WatchedJoint>& joints,
                                  const RunStart& from, const Vector3d& gravity, const State& state)
{
    const double g = gravity.norm();
    if (g == 0 || blocks_that_are_ground(model).empty()) return std::nullopt;
    const Vector3d down = gravity / g;
    Verdict verdict;
    const Places places(model, from, state);
    const FootMotion foot = foot_motion(model, joints, from, state);
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const Vector3d gone = places.now[b].pose.centroid - places.reference[b].pose.centroid;
        const Matrix3d turned = Places::rotation(places.now[b], places.reference[b]);
        verdict.blocks.push_back({(gone - foot.displacement).norm(), std::abs(Eigen::AngleAxisd(turned).angle())});
    }
    const std::vector<bool> is_ground = ground_marks(model);
    find_lost(model, {model, joints, from.start, down, places, state}, down, places, state, is_ground, verdict);
    const std::vector<bool> leave = with_lost(is_ground, verdict);
    find_fastest(model, g, foot, state, leave, verdict);
    if (verdict.fastest >= 0) verdict.go_on = time_to_see(model, down, g, places);
    if (!from.reference.empty()) find_worst_joint(model, joints, places, is_ground, leave, verdict);
    judge(model, verdict);
    return verdict;
}

void add_lost(const Model& model, const std::vector<int>& blocks, Verdict& verdict)
{
    const std::vector<bool> is_ground = ground_marks(model);
    for (const int b : blocks)
        if (!is_ground[b] && !std::binary_search(verdict.lost.begin(), verdict.lost.end(), b))
            verdict.lost.insert(std::lower_bound(verdict.lost.begin(), verdict.lost.end(), b), b);
    judge(model, verdict);
}

}  // namespace voussoir
