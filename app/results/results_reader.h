// Reads results.h5 back into plain structs: for pictures, reports and tests.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/results/friction_use.h"
#include "app/results/hdf5_file.h"
#include "app/results/surface_mesh.h"
#include "libdda/analysis/joints_now.h"

namespace voussoir::app::results
{

/// A tie rod.
struct RecordedRod {
    std::array<std::int32_t, 2> blocks{};
    std::array<Eigen::Vector3d, 2> anchors;  // m, in space, from the centroids at the start
};

/// What displacements count from: the last frame before the first motion.
struct RecordedRest {
    State state;  // places only; empty: there was no such frame, and they count from the start
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();  // m, displacement since the start
    std::vector<JointNow> joints;                    // those of the model
};

/// What is constant in a results file.
struct RecordedModel {
    std::string title, version;
    Kinematics kinematics = Kinematics::spatial_deformable;
    double thickness = 0;  // m, of a planar scene
    std::vector<std::string> block_names, stage_names;
    std::vector<bool> stage_is_dynamic, stage_moves;  // the latter: it moves the structure (Stage::moves)
    std::vector<Eigen::Vector3d> centroids;           // m, in space, at the start
    std::vector<std::int32_t> foundations;            // blocks that follow the ground
    std::vector<std::int32_t> soil;                   // blocks of the ground, of a structure that stands on soil
    std::vector<std::int32_t> foot;  // stones on soil, relative to whose mean displacements count; else empty
    SurfaceMesh mesh;
    std::vector<WatchedJoint> joints;  // of the start, without their patches
    std::vector<JointBound> bounds;    // (joints)
    std::vector<RecordedRod> rods;
    RecordedRest rest;

    /// Whether what a frame shows has a rest before it, from which it counts; else it counts from the start.
    bool counts_from_rest(const struct RecordedFrame& frame) const;
};

/// What one frame holds, vectors and tensors in space.
struct RecordedFrame {
    double time = 0;  // s
    std::int64_t step = 0;
    int stage = 0;
    State state;                                       // places and velocities only; no contacts
    Eigen::Vector3d ground = Eigen::Vector3d::Zero();  // m, displacement of the foot since the start
    bool in_motion = false;                 // the first motion has begun: displacements count from there
    std::vector<Eigen::Matrix3d> stresses;  // (blocks) Pa; empty if rigid
    std::vector<JointNow> joints;           // of the model; openings and slips since the motion began
    std::vector<JointResultant> contacts;   // of all pairs of blocks
};

/// How far a block's centroid has moved relative to the foot of the structure [m]: since the first motion began;
/// in frames before, since the start.
Eigen::Vector3d moved(const RecordedModel& model, const RecordedFrame& frame, int block);

/// What a block has turned and strained since then: its map, as of Pose.
Eigen::Matrix3d map_since(const RecordedModel& model, const RecordedFrame& frame, int block);

/// The last frame before the first motion as that motion counts it: nothing has moved yet.
void begin_motion(RecordedFrame& frame);

/// "since the motion began, relative to the supports": what moved() counts from, in words.
/// @param in_motion of the frame
std::string counted_from(const RecordedModel& model, bool in_motion = true);

class ResultsReader
{
 public:
    /// Opens a file, of a finished, running or killed run. @throws InputError when it is no results file
    explicit ResultsReader(const std::filesystem::path& path);

    /// @throws InputError when the file is damaged there
    RecordedFrame frame(std::size_t index) const;

    RecordedModel model;
    std::vector<std::int32_t> stages;  // of the whole frames
    std::vector<double> times;  // s, of the whole frames; one that a killed run left unfinished is not counted

 private:
    /// `count` rows of so many columns each, or else an InputError.
    template <typename T>
    std::vector<T> rows(const std::string& name, std::int64_t first, std::int64_t count,
                        std::size_t columns) const;
    template <typename T>
    T one(const std::string& name, std::size_t row) const;
    bool has_moved(int stage) const;  // in it or before
    std::vector<Eigen::Matrix3d> stresses(std::size_t frame) const;
    std::vector<JointResultant> contacts(std::size_t frame) const;
    std::vector<JointNow> joints(std::size_t frame) const;
    Hdf5File file_;
    std::string place_;  // the file, for faults
};

}  // namespace voussoir::app::results
