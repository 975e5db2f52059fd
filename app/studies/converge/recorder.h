// Follows the compared quantities through a run, and tells when the structure collapses.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/converge/quantity.h"
#include "libdda/analysis/ground.h"
#include "libdda/analysis/material_point.h"

namespace voussoir::app::studies::converge
{

/// Every accepted step of the dynamic stages, after the state in which the motion began.
struct Recording {
    std::vector<double> times;                         // s of the run, rising
    std::vector<std::vector<Eigen::Vector3d>> values;  // (channels x times); of a component in x, the rest 0
    std::vector<double> extents;                       // (channels): largest length of the vector, all components
};

/// When a structure counts as collapsed: a block that is not wholly held has its centroid further from where the
/// case has it, relative to the foot of the structure, than a share of its size (the cube root of its volume) or
/// than a length.
struct CollapseRule {
    std::optional<double> sizes = 1;  // -
    std::optional<double> length;     // m; with neither, nothing is a collapse
};

struct Collapse {
    double time = 0;  // s of the run
    std::string block;
};

/// Watches the accepted steps of one run and steers nothing.
class Recorder
{
 public:
    Recorder(const Case& the_case, const std::vector<Quantity>& channels, const CollapseRule& rule);

    void step(const State& state);

    Recording recording;
    std::optional<Collapse> collapse;  // the first

 private:
    struct Channel {
        Quantity quantity;
        MaterialPoint point;
        Eigen::Vector3d rest = Eigen::Vector3d::Zero();  // m, drift of the point when the motion began
    };
    Eigen::Vector3d value_of(const Channel& channel, const State& state, const Eigen::Vector3d& ground) const;
    void follow_blocks(const State& state, const Eigen::Vector3d& ground);
    void look_for_collapse(const State& state);
    void remember_rest(const State& state, const Eigen::Vector3d& ground);

    const Case& case_;
    Foot foot_;
    std::vector<Channel> channels_;
    std::vector<int> blocks_;                    // not wholly held
    std::vector<double> collapse_distance_;      // m, of those blocks
    std::vector<Eigen::Vector3d> drift_, rest_;  // m, of those blocks: now, and when the motion began
};

}  // namespace voussoir::app::studies::converge
