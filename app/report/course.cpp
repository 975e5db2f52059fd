#include "app/report/course.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "libdda/analysis/joint_openings.h"

namespace voussoir::app::report
{

using Eigen::Vector3d;

namespace
{

/// The stone with the highest centroid, and how far that is above the lowest corner.
void find_highest(const results::RecordedModel& model, const std::vector<bool>& foundation, Course& course)
{
    double lowest = std::numeric_limits<double>::infinity();
    const int dimension = model.mesh.dimension;
    for (std::size_t v = 0; v < model.mesh.vertex_block.size(); ++v) {
        const int block = model.mesh.vertex_block[v];
        if (foundation[block]) continue;
        lowest = std::min(lowest, model.centroids[block].z() + model.mesh.levers[dimension * v + dimension - 1]);
    }
    for (std::size_t b = 0; b < model.centroids.size(); ++b) {
        if (foundation[b]) continue;
        if (course.highest >= 0 && model.centroids[b].z() <= model.centroids[course.highest].z()) continue;
        course.highest = static_cast<int>(b);
        course.height = model.centroids[b].z() - lowest;
    }
}

/// @param counts: joints that open as the structure comes to rest are no damage
void note_joints(const results::RecordedModel& model, const results::RecordedFrame& frame, bool counts,
                 Course& course)
{
    double opening = 0, slip = 0;
    for (std::size_t i = 0; i < frame.joints.size(); ++i) {
        const JointNow& joint = frame.joints[i];
        course.joint_normal_force[i].see(joint.normal_force, frame.time);
        if (!counts) continue;
        course.joint_opening[i].see(joint.motion.opening, frame.time);
        course.joint_slip[i].see(joint.motion.largest_slip, frame.time);
        if (course.within_ground[i]) continue;
        opening = std::max(opening, joint.motion.opening);
        slip = std::max(slip, joint.motion.largest_slip);
        for (const int block : {model.joints[i].block_a, model.joints[i].block_b}) {
            course.blocks[block].opening.see(joint.motion.opening, frame.time);
            course.blocks[block].slip.see(joint.motion.largest_slip, frame.time);
        }
    }
    course.opening.push_back(opening);
    course.slip.push_back(slip);
}

int joints_beyond(const std::vector<Peak>& peaks)
{
    return static_cast<int>(std::count_if(peaks.begin(), peaks.end(),
                                          [](const Peak& peak) { return peak.value > noteworthy_opening; }));
}

void note_contacts(const results::RecordedFrame& frame, const std::vector<bool>& foundation, bool first,
                   Course& course)
{
    Vector3d base = Vector3d::Zero();
    std::vector<bool> touches(foundation.size(), first);  // nothing has pressed yet in the first frame
    for (const JointResultant& contact : frame.contacts) {
        if (foundation[contact.block_b] && !foundation[contact.block_a]) base += contact.force;
        if (foundation[contact.block_a] && !foundation[contact.block_b]) base -= contact.force;
        if (!(contact.closed_area > 0)) continue;
        touches[contact.block_a] = touches[contact.block_b] = true;
    }
    course.base_force.push_back(base);
    for (std::size_t b = 0; b < touches.size(); ++b) {
        double& since = course.blocks[b].lost_contact;
        if (touches[b])
            since = -1;
        else if (since < 0)
            since = frame.time;
    }
}

void note_stresses(const results::RecordedFrame& frame, Course& course)
{
    for (std::size_t b = 0; b < frame.stresses.size(); ++b) {
        const Vector3d principal =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(frame.stresses[b], Eigen::EigenvaluesOnly)
                .eigenvalues();
        course.blocks[b].compression.see(-principal[0], frame.time);
        course.blocks[b].tension.see(principal[2], frame.time);
    }
}

}  // namespace

std::vector<bool> foundation_marks(const results::RecordedModel& model)
{
    std::vector<bool> marks(model.block_names.size(), false);
    for (const std::int32_t block : model.foundations) marks.at(static_cast<std::size_t>(block)) = true;
    for (const std::int32_t block : model.soil) marks.at(static_cast<std::size_t>(block)) = true;
    return marks;
}

Course course_of(const results::ResultsReader& results)
{
    const results::RecordedModel& model = results.model;
    const std::vector<bool> foundation = foundation_marks(model);
    Course course;
    course.blocks.resize(model.block_names.size());
    course.joint_opening.resize(model.joints.size());
    course.joint_slip.resize(model.joints.size());
    course.joint_normal_force.resize(model.joints.size());
    for (const WatchedJoint& joint : model.joints)
        course.within_ground.push_back(foundation[joint.block_a] && foundation[joint.block_b]);
    find_highest(model, foundation, course);
    const bool moves =
        std::find(model.stage_moves.begin(), model.stage_moves.end(), true) != model.stage_moves.end();
    for (std::size_t i = 0; i < results.times.size(); ++i) {
        const results::RecordedFrame frame = results.frame(i);
        course.times.push_back(frame.time);
        const bool counts = frame.in_motion || !moves;  // what settles under self-weight before is no damage
        double largest = 0;
        for (std::size_t b = 0; b < course.blocks.size(); ++b) {
            if (foundation[b]) continue;
            BlockCourse& block = course.blocks[b];
            block.residual = moved(model, frame, static_cast<int>(b)).norm();
            largest = std::max(largest, block.residual);
            if (counts)
                block.displacement.see(block.residual, frame.time);
            else
                block.settlement = block.residual;
        }
        course.displacement.push_back(counts ? largest : 0);
        course.drift.push_back(counts && course.highest >= 0 ? moved(model, frame, course.highest)
                                                             : Vector3d::Zero().eval());
        note_joints(model, frame, counts, course);
        note_contacts(frame, foundation, i == 0, course);
        note_stresses(frame, course);
    }
    course.joints_opened = joints_beyond(course.joint_opening);
    course.joints_slid = joints_beyond(course.joint_slip);
    return course;
}

}  // namespace voussoir::app::report
