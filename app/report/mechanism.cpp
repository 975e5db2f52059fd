#include "app/report/mechanism.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace voussoir::app::report
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{

constexpr double worth_a_word = 0.1;  // of what moved most

/// The rotation in a map, nearly its polar part: its columns made orthogonal.
Matrix3d turn_of(const Matrix3d& map)
{
    return Eigen::Quaterniond(map).normalized().toRotationMatrix();
}

double angle_of(const Matrix3d& turn)
{
    return Eigen::AngleAxisd(turn).angle();
}

/// A length that says how large a block is [m]: the middle one of the three sides of its box.
double size_of(const results::SurfaceMesh& mesh, int block)
{
    Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();
    for (int v = mesh.block_first_vertex[block]; v < mesh.block_first_vertex[block + 1]; ++v)
        for (int axis = 0; axis < mesh.dimension; ++axis) {
            const double lever = mesh.levers[static_cast<std::size_t>(mesh.dimension) * v + axis];
            low[axis] = std::min(low[axis], lever);
            high[axis] = std::max(high[axis], lever);
        }
    std::array<double, 3> sides = {high.x() - low.x(), high.y() - low.y(), high.z() - low.z()};
    std::sort(sides.begin(), sides.end());
    return mesh.dimension == 2 ? std::sqrt(sides[1] * sides[2]) : sides[1];
}

double typical_size(const results::RecordedModel& model)
{
    std::vector<double> sizes;
    const std::vector<bool> foundation = foundation_marks(model);
    for (std::size_t b = 0; b < model.block_names.size(); ++b)
        if (!foundation[b]) sizes.push_back(size_of(model.mesh, static_cast<int>(b)));
    if (sizes.empty()) return 0;
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
    return sizes[sizes.size() / 2];
}

std::size_t frame_of_the_most(const Course& course)
{
    std::size_t most = 0;
    for (std::size_t i = 0; i < course.times.size(); ++i)
        if (std::max(course.opening[i], course.slip[i]) > std::max(course.opening[most], course.slip[most]))
            most = i;
    return most;
}

/// The last frame before a stone has moved off, or the first after it where nothing shows before.
std::size_t frame_of_the_beginning(const Course& course, double most_moved)
{
    std::size_t last = 0;
    while (last + 1 < course.times.size() && course.displacement[last + 1] <= most_moved) ++last;
    const bool shows = std::max(course.opening[last], course.slip[last]) > 10 * noteworthy_opening;
    return shows || last + 1 == course.times.size() ? last : last + 1;
}

MovedJoint moved_joint(const results::RecordedModel& model, const results::RecordedFrame& frame, int index)
{
    const WatchedJoint& joint = model.joints[index];
    const JointNow& now = frame.joints[index];
    const Matrix3d a = turn_of(map_since(model, frame, joint.block_a)),
                   b = turn_of(map_since(model, frame, joint.block_b));
    const Eigen::AngleAxisd turn(a * b.transpose());
    MovedJoint moved;
    moved.joint = index;
    moved.opening = now.motion.opening;
    moved.slip = now.motion.largest_slip;
    moved.turn = turn.angle();
    // Points at r from the middle part by (turn x r) . normal: most at normal x turn, least opposite.
    const Vector3d opens_towards = joint.normal.cross(turn.axis());
    if (opens_towards.norm() > 1e-6) moved.edge = -opens_towards.normalized();
    return moved;
}

/// The joints that did something worth a word, from the most to the least.
std::vector<MovedJoint> moved_joints(const results::RecordedModel& model, const results::RecordedFrame& frame)
{
    double most = 0;
    for (const JointNow& joint : frame.joints)
        most = std::max({most, joint.motion.opening, joint.motion.largest_slip});
    const double least = std::max(noteworthy_opening, worth_a_word * most);
    std::vector<MovedJoint> joints;
    for (std::size_t i = 0; i < frame.joints.size(); ++i) {
        const JointMotion& motion = frame.joints[i].motion;
        if (std::max(motion.opening, motion.largest_slip) <= least) continue;
        MovedJoint joint = moved_joint(model, frame, static_cast<int>(i));
        joint.opens = motion.opening > std::max(least, 0.3 * motion.largest_slip);
        joint.slides = motion.largest_slip > std::max(least, 0.3 * motion.opening);
        joint.parted =
            joint.opens && !(frame.joints[i].normal_force > 0) && motion.mean_opening > 0.5 * motion.opening;
        joints.push_back(joint);
    }
    std::stable_sort(joints.begin(), joints.end(), [](const MovedJoint& a, const MovedJoint& b) {
        return std::max(a.opening, a.slip) > std::max(b.opening, b.slip);
    });
    return joints;
}

/// For each block the first block of its body.
std::vector<int> bodies_by_block(const results::RecordedModel& model, const std::vector<MovedJoint>& joints)
{
    std::vector<int> root(model.block_names.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&root](int b) {
        while (root[b] != b) b = root[b] = root[root[b]];
        return b;
    };
    std::vector<bool> moves(model.joints.size(), false);
    for (const MovedJoint& joint : joints) moves[joint.joint] = true;
    for (std::size_t i = 0; i < model.joints.size(); ++i)
        if (!moves[i]) root[find(model.joints[i].block_b)] = find(model.joints[i].block_a);
    for (const std::int32_t block : model.foundations) root[find(block)] = find(model.foundations.front());
    for (std::size_t b = 0; b < root.size(); ++b) root[b] = find(static_cast<int>(b));
    return root;
}

/// @param of_block is set to the place of each block's body in the list
std::vector<Body> bodies_in(const results::RecordedModel& model, const results::RecordedFrame& frame,
                            const results::RecordedFrame& end, const std::vector<MovedJoint>& joints,
                            std::vector<int>& of_block)
{
    of_block = bodies_by_block(model, joints);
    std::map<int, Body> by_root;
    for (std::size_t b = 0; b < of_block.size(); ++b) {
        Body& body = by_root[of_block[b]];
        const int block = static_cast<int>(b);
        body.blocks.push_back(block);
        body.displacement = std::max(body.displacement, moved(model, frame, block).norm());
        body.last_displacement = std::max(body.last_displacement, moved(model, end, block).norm());
        body.turn = std::max(body.turn, angle_of(turn_of(map_since(model, frame, block))));
        body.last_turn = std::max(body.last_turn, angle_of(turn_of(map_since(model, end, block))));
    }
    const auto larger = [](const auto& a, const auto& b) {
        return a.second.blocks.size() < b.second.blocks.size();
    };
    if (!model.foundations.empty())
        by_root[of_block[model.foundations.front()]].rests = true;
    else if (!by_root.empty())
        std::max_element(by_root.begin(), by_root.end(), larger)->second.rests = true;
    std::vector<Body> bodies;
    bodies.reserve(by_root.size());
    for (const auto& [root, body] : by_root) bodies.push_back(body);
    std::stable_sort(bodies.begin(), bodies.end(), [](const Body& a, const Body& b) {
        return a.rests != b.rests ? a.rests : a.blocks.size() > b.blocks.size();
    });
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (const int block : bodies[i].blocks) of_block[block] = static_cast<int>(i);
    return bodies;
}

/// Where stones have moved off by the end, bodies that are still near their places are no part of what failed: a
/// wall that rocks on, of which one stone falls. @param far m, from where on a stone has moved off
void mark_those_that_stay(double far, std::vector<Body>& bodies)
{
    constexpr double near = 0.1;  // of what moved most
    double most = 0;
    for (const Body& body : bodies) most = std::max(most, body.last_displacement);
    if (!(most > far)) return;
    for (Body& body : bodies) {
        if (body.rests || body.last_displacement > std::min(far, near * most)) continue;
        body.rests = body.stays = true;
    }
}

/// What two bodies do at all joints between them.
struct Interface {
    double opening = 0, slip = 0;
    bool presses = false;
};

/// Is every stone that moves above every stone that stays, and does one stay at all? @param clearly m, of
/// centroids
bool comes_off_above(const results::RecordedModel& model, const std::vector<Body>& bodies, double clearly)
{
    const std::vector<bool> foundation = foundation_marks(model);
    bool stays = false;
    double top = 0, bottom = 0;
    bool any = false;
    for (const Body& body : bodies)
        for (const int block : body.blocks) {
            const double z = model.centroids[block].z();
            if (body.rests && !foundation[block]) top = stays ? std::max(top, z) : z, stays = true;
            if (!body.rests) bottom = any ? std::min(bottom, z) : z, any = true;
        }
    return stays && any && bottom > top + clearly;
}

MechanismKind kind_of(const results::RecordedModel& model, const Mechanism& mechanism, double clearly,
                      const std::vector<int>& pressed_of_body)
{
    if (comes_off_above(model, mechanism.bodies, clearly)) return MechanismKind::sheds;
    const int turning = mechanism.hinges + mechanism.parted;
    constexpr double by_far = 3;
    if (mechanism.sliding > 0)
        return turning > 0 && mechanism.slip < by_far * mechanism.opening ? MechanismKind::mixed
                                                                          : MechanismKind::slides;
    bool chain = true;
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
        chain = chain && (mechanism.bodies[i].rests || pressed_of_body[i] >= 2);
    return chain ? MechanismKind::hinges : MechanismKind::overturns;
}

}  // namespace

Mechanism mechanism_in(const results::ResultsReader& results, const Course& course, std::optional<bool> known)
{
    const results::RecordedModel& model = results.model;
    const double far = 0.25 * typical_size(model);
    const bool failed = known.value_or(!course.displacement.empty() && course.displacement.back() > far);
    Mechanism mechanism;
    mechanism.frame = failed ? frame_of_the_beginning(course, far) : frame_of_the_most(course);
    mechanism.time = course.times[mechanism.frame];
    const results::RecordedFrame frame = results.frame(mechanism.frame);
    mechanism.joints = moved_joints(model, frame);
    std::vector<int> body_of;
    mechanism.bodies = bodies_in(model, frame, results.frame(results.times.size() - 1), mechanism.joints, body_of);
    if (failed) mark_those_that_stay(far, mechanism.bodies);

    std::map<std::pair<int, int>, Interface> interfaces;
    for (const MovedJoint& joint : mechanism.joints) {
        const WatchedJoint& of = model.joints[joint.joint];
        const auto ends = std::minmax(body_of[of.block_a], body_of[of.block_b]);
        if (ends.first == ends.second) continue;
        if (failed && mechanism.bodies[ends.first].rests && mechanism.bodies[ends.second].rests) continue;
        mechanism.opening += joint.opening;
        mechanism.slip += joint.slip;
        Interface& between = interfaces[ends];
        between.opening += joint.opening;
        between.slip += joint.slip;
        between.presses = between.presses || !joint.parted;
    }
    std::vector<int> pressed_of_body(mechanism.bodies.size(), 0);
    for (const auto& [ends, between] : interfaces) {
        if (between.presses) {
            ++pressed_of_body[ends.first];
            ++pressed_of_body[ends.second];
        }
        if (between.slip > between.opening)
            ++mechanism.sliding;
        else
            ++(between.presses ? mechanism.hinges : mechanism.parted);
    }
    if (failed)
        mechanism.kind =
            interfaces.empty() ? MechanismKind::loose : kind_of(model, mechanism, far, pressed_of_body);
    return mechanism;
}

}  // namespace voussoir::app::report
