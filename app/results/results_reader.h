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

/// What is constant in a results file.
struct RecordedModel {
    std::string title, version;
    Kinematics kinematics = Kinematics::spatial_deformable;
    double thickness = 0;  // m, of a planar scene
    std::vector<std::string> block_names, stage_names;
    std::vector<bool> stage_is_dynamic;
    std::vector<Eigen::Vector3d> centroids;  // m, in space, at the start
    std::vector<std::int32_t> foundations;   // blocks that follow the ground
    SurfaceMesh mesh;
    std::vector<WatchedJoint> joints;  // of the start, without their patches
    std::vector<JointBound> bounds;    // (joints)
    std::vector<RecordedRod> rods;
};

/// What one frame holds, vectors and tensors in space.
struct RecordedFrame {
    double time = 0;  // s
    std::int64_t step = 0;
    int stage = 0;
    State state;                                       // places and velocities only; no contacts
    Eigen::Vector3d ground = Eigen::Vector3d::Zero();  // m, displacement
    std::vector<Eigen::Matrix3d> stresses;             // (blocks) Pa; empty if rigid
    std::vector<JointNow> joints;                      // those of the model
    std::vector<JointResultant> contacts;              // of all pairs of blocks
};

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
    std::vector<Eigen::Matrix3d> stresses(std::size_t frame) const;
    std::vector<JointResultant> contacts(std::size_t frame) const;
    std::vector<JointNow> joints(std::size_t frame) const;
    Hdf5File file_;
    std::string place_;  // the file, for faults
};

}  // namespace voussoir::app::results
