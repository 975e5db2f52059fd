// Limit analysis of a case: the body force, in one direction, under which its stones become a mechanism.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "libdda/limit/limit_factor.h"

namespace voussoir::app::studies::limit
{

/// A joint of the mechanism.
struct MovingJoint {
    int block_a = 0, block_b = 0;  // indices into Model::blocks, a < b
    bool slides = false;           // it slides by more than its corners part; else it opens about an edge
};

struct MovingStone {
    int block = 0;                                       // index into Model::blocks
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // -, of its centroid
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();      // 1/m
};

/// The answer. Factors are accelerations over standard gravity.
struct LimitStudy {
    std::string case_name;
    std::vector<std::string> block_names;                // of all stones
    Eigen::Vector3d towards = Eigen::Vector3d::UnitX();  // unit
    int contact_points = 0, bonded_points = 0, bars = 0;
    voussoir::limit::CollapseLoad associated;
    std::optional<voussoir::limit::SlidingBracket> sliding;
    std::vector<MovingStone> stones;  // the fastest first, whose velocity or spin times its size is 1
    std::vector<MovingJoint> joints;  // that open or slide
    double tilt = 0;                  // deg, of a table, where that is the same question; 0: it is not
    std::vector<std::string> left_out;
};

/// Contacts open by less than this share of the smaller stone's size are taken to bear.
constexpr double bearing_reach = 1e-3;

/// Rigid stones where the case puts them, under the gravity of its first stage.
/// @param towards of any length but 0
/// @param between called between searches; what it throws ends the study
/// @throws InputError where limit analysis cannot know the answer
LimitStudy limit_study(
    const Case& the_case, const Eigen::Vector3d& towards, const std::function<void()>& between = [] {});

/// What the study says, in sentences.
std::vector<std::string> in_words(const LimitStudy& study);
/// For a terminal.
std::string limit_table(const LimitStudy& study);
/// limit.md. @param command how the page was made
std::string limit_page(const LimitStudy& study, const std::string& command);
/// See docs/limit.md for the fields; what does not exist is null.
std::string limit_json(const LimitStudy& study);

}  // namespace voussoir::app::studies::limit
