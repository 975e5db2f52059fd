// What a run did in time: one pass over its stored frames.
#pragma once

#include <string>
#include <vector>

#include "app/results/results_reader.h"

namespace voussoir::app::report
{

/// The largest of something over a run, and when.
struct Peak {
    double value = 0, time = 0;  // SI, s

    void see(double now, double when)
    {
        if (now > value) *this = {now, when};
    }
};

struct BlockCourse {
    double settlement = 0;     // m, of the centroid relative to the foot, until the first motion began
    Peak displacement;         // m, since then
    double residual = 0;       // m, at the end
    Peak opening, slip;        // m, of its joints
    Peak compression;          // Pa, largest compressive principal stress; deformable scenes
    Peak tension;              // Pa
    double lost_contact = -1;  // s, since when it touches nothing, to the end; -1: it touches something
};

struct Course {
    std::vector<double> times;                        // s, of the frames
    std::vector<double> displacement, opening, slip;  // m, the largest in each frame
    std::vector<Eigen::Vector3d> base_force;          // N, of the foundations on the structure
    std::vector<Eigen::Vector3d> drift;               // m, of the highest stone relative to the foot
    std::vector<BlockCourse> blocks;
    std::vector<Peak> joint_opening, joint_slip, joint_normal_force;  // m, m, N; of the model's joints
    // That opened or slid at some time: as the run counted in its steps; of a run without summary, in its frames.
    int joints_opened = 0, joints_slid = 0;
    std::vector<bool> within_ground;  // of the model's joints: between two blocks of soil; none of the structure
    int highest = -1;                 // the stone whose drift it is; -1: there are foundations alone
    double height = 0;                // m, of its centroid above the lowest corner of the structure's stones
};

/// @param results with at least one frame
Course course_of(const results::ResultsReader& results);

/// For each block whether it is ground: a foundation, or the soil below.
std::vector<bool> foundation_marks(const results::RecordedModel& model);

}  // namespace voussoir::app::report
