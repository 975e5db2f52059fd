// One frame as triangles and lines, ready to be drawn: seen from the ground, displacements enlarged.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/case/case.h"
#include "app/render/look.h"
#include "app/results/results_reader.h"

namespace voussoir::app::render
{

struct SceneOptions {
    SnapshotColor color = SnapshotColor::displacement;
    double deformation_scale = 1;
    double joint_threshold = noteworthy_opening;  // m, an opening or a slip larger than this is marked
    LookOfRun look = {};
    std::vector<std::vector<int>> joint_faces =
        {};  // of each joint, for many scenes of one model; empty: looked for
};

struct Triangle {
    std::array<Eigen::Vector3d, 3> corners;  // m
    Eigen::Vector3d normal;                  // unit, outward
    std::array<double, 3> values;            // of the coloured quantity, SI; NaN: it has none, and is grey
    bool foundation = false;                 // grey, not coloured
};

struct Segment {
    Eigen::Vector3d from, to;  // m
};

struct Label {
    std::string text;
    Eigen::Vector3d place;  // m
};

struct Scene {
    double time = 0;  // s
    std::string stage;
    Eigen::Vector3d ground = Eigen::Vector3d::Zero();  // m, displacement of the foot
    std::string counted_from;                          // what displacements count from, in words
    std::vector<Triangle> triangles;
    std::vector<Segment> edges, opened, slid;  // outlines of faces, and of the faces of marked joints
    std::vector<Segment> rods;                 // tie rods from end to end
    std::vector<Segment> forces, thrust;  // contact forces, a sixth of the structure for the largest of the run
    std::vector<Segment> ground_arrows;   // acceleration of the ground, the largest of the run as long
    double ground_acceleration = 0;       // m/s2, the largest that they show
    std::optional<Eigen::Vector3d> followed;  // m, where what the camera goes with is drawn
    bool has_blank = false;                   // stones that have no value are grey
    std::vector<Label> labels;
    int opened_joints = 0, slid_joints = 0;
};

/// The faces of each joint of a model, which are the same in all its scenes. @param model with a mesh in space
std::vector<std::vector<int>> joint_faces_of(const results::RecordedModel& model);

/// @param model with a mesh in space
Scene make_scene(const results::RecordedModel& model, const results::RecordedFrame& frame,
                 const SceneOptions& options);

}  // namespace voussoir::app::render
