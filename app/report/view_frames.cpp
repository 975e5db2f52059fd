#include "app/report/view_frames.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/render/stone_values.h"
#include "app/report/base64.h"
#include "app/report/course.h"

namespace voussoir::app::report
{
namespace
{

using Eigen::Vector3d;
using Json = nlohmann::json;

constexpr std::uint16_t none = 65535;
constexpr double steps = 65534;

/// The vector part of the unit quaternion of a block's turn, its scalar part >= 0.
Vector3d turn_of(const Eigen::Matrix3d& map, bool deformable)
{
    Eigen::Matrix3d turn = map;
    if (deformable) {
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
        turn = svd.matrixU() * svd.matrixV().transpose();
    }
    const Eigen::Quaterniond quaternion(turn);
    return quaternion.w() < 0 ? Vector3d(-quaternion.vec()) : Vector3d(quaternion.vec());
}

void add_vector(const Vector3d& vector, std::vector<float>& values)
{
    for (const double value : vector) values.push_back(static_cast<float>(value));
}

/// Of the stones, by the names that the script knows.
std::vector<std::pair<const char*, SnapshotColor>> stone_quantities(Kinematics kinematics)
{
    std::vector<std::pair<const char*, SnapshotColor>> quantities = {{"speed", SnapshotColor::velocity}};
    if (is_deformable(kinematics)) {
        quantities.emplace_back("stress", SnapshotColor::principal_stress);
        quantities.emplace_back("strain", SnapshotColor::principal_strain);
    }
    return quantities;
}

constexpr std::array<const char*, 4> joint_quantities = {"opening", "slip", "force", "friction"};

void add_joints(const results::RecordedModel& model, const results::RecordedFrame& frame, ViewFrames& frames)
{
    for (std::size_t i = 0; i < frame.joints.size(); ++i) {
        const JointNow& now = frame.joints[i];
        const double use = results::friction_use(model.bounds[i], model.joints[i].bonded, now)
                               .value_or(std::numeric_limits<double>::quiet_NaN());
        const std::array<double, 4> values = {now.motion.opening, now.motion.largest_slip,
                                              std::max(0.0, now.normal_force), use};
        for (std::size_t k = 0; k < values.size(); ++k) frames.joints[k].values.push_back(values[k]);
    }
}

Json quantity_as_json(const ViewQuantity& quantity)
{
    double lowest = 0, largest = 0;
    for (const double value : quantity.values) {
        if (std::isnan(value)) continue;
        lowest = std::min(lowest, value);
        largest = std::max(largest, value);
    }
    std::vector<std::uint16_t> shares;
    shares.reserve(quantity.values.size());
    for (const double value : quantity.values) {
        const double share = largest > lowest ? (value - lowest) / (largest - lowest) : 0;
        shares.push_back(std::isnan(value) ? none : static_cast<std::uint16_t>(std::lround(steps * share)));
    }
    return {{"lowest", lowest}, {"largest", largest}, {"shares", packed(shares)}};
}

}  // namespace

std::size_t bytes_of_a_frame(const results::RecordedModel& model)
{
    return (6 * sizeof(float) + 2 * stone_quantities(model.kinematics).size()) * model.block_names.size() +
           2 * joint_quantities.size() * model.joints.size();
}

void add_frame(const results::RecordedModel& model, const results::RecordedFrame& frame, ViewFrames& frames)
{
    frames.times.push_back(frame.time);
    const auto stage = static_cast<std::size_t>(frame.stage);
    frames.stages.push_back(stage < model.stage_names.size() ? model.stage_names[stage] : "");
    const bool deformable = is_deformable(model.kinematics);
    for (std::size_t b = 0; b < model.block_names.size(); ++b) {
        add_vector(moved(model, frame, static_cast<int>(b)), frames.moves);
        add_vector(turn_of(map_since(model, frame, static_cast<int>(b)), deformable), frames.moves);
    }
    const auto of_stones = stone_quantities(model.kinematics);
    if (frames.joints.empty()) {
        for (const auto& [name, color] : of_stones) frames.stones.push_back({name, {}});
        for (const char* name : joint_quantities) frames.joints.push_back({name, {}});
    }
    for (std::size_t k = 0; k < of_stones.size(); ++k) {
        const std::vector<double> values = render::stone_values(model, frame, of_stones[k].second, {});
        frames.stones[k].values.insert(frames.stones[k].values.end(), values.begin(), values.end());
    }
    add_joints(model, frame, frames);
}

std::string frames_as_json(const ViewFrames& frames)
{
    Json data;
    data["times"] = Json::array();
    for (const double time : frames.times) data["times"].push_back(std::round(time * 1e9) / 1e9);
    data["stages"] = frames.stages;
    data["moves"] = packed(frames.moves);
    data["of_stones"] = data["of_joints"] = Json::object();
    for (const ViewQuantity& quantity : frames.stones)
        data["of_stones"][quantity.name] = quantity_as_json(quantity);
    for (const ViewQuantity& quantity : frames.joints)
        data["of_joints"][quantity.name] = quantity_as_json(quantity);
    return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace voussoir::app::report
