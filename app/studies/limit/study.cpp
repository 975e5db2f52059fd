#include "app/studies/limit/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "libdda/errors.h"
#include "libdda/limit/standing.h"
#include "libdda/model/standard_gravity.h"

namespace voussoir::app::studies::limit
{

namespace
{

using Eigen::Vector3d;
using voussoir::limit::BlockVelocity;
using voussoir::limit::FacePoints;
using voussoir::limit::LimitContact;
using voussoir::limit::LimitProblem;
using voussoir::limit::UnderLoad;

constexpr double moving = 0.02;  // of the fastest stone's speed: slower is not part of the mechanism

double speed_of(const Model& model, int block, const BlockVelocity& velocity)
{
    return std::max(velocity.centroid.norm(), velocity.spin.norm() * size_of(model, block));
}

double fastest_of(const Model& model, const std::vector<BlockVelocity>& velocities)
{
    double fastest = 0;
    for (std::size_t b = 0; b < velocities.size(); ++b)
        fastest = std::max(fastest, speed_of(model, static_cast<int>(b), velocities[b]));
    return fastest;
}

std::vector<MovingStone> moving_stones(const Model& model, const std::vector<BlockVelocity>& velocities)
{
    const double fastest = fastest_of(model, velocities);
    const auto speed = [&](int b) { return speed_of(model, b, velocities[static_cast<std::size_t>(b)]); };
    std::vector<MovingStone> stones;
    for (int b = 0; b < static_cast<int>(velocities.size()); ++b) {
        const BlockVelocity& velocity = velocities[static_cast<std::size_t>(b)];
        if (speed(b) > moving * fastest)
            stones.push_back({b, velocity.centroid / fastest, velocity.spin / fastest});
    }
    std::stable_sort(stones.begin(), stones.end(),
                     [&](const MovingStone& a, const MovingStone& b) { return speed(a.block) > speed(b.block); });
    return stones;
}

/// How fast the corners of one joint part and slide.
struct JointRates {
    double least_opening = std::numeric_limits<double>::infinity(),
           most_opening = -std::numeric_limits<double>::infinity();
    double least_slip = std::numeric_limits<double>::infinity(), most_slip = 0;
};

std::vector<MovingJoint> moving_joints(const Model& model, const LimitProblem& problem,
                                       const std::vector<BlockVelocity>& velocities)
{
    const double fastest = fastest_of(model, velocities);
    const auto velocity_at = [&](int block, const Vector3d& point) -> Vector3d {
        const auto b = static_cast<std::size_t>(block);
        return velocities[b].centroid + velocities[b].spin.cross(point - problem.blocks[b].centroid);
    };
    std::map<std::pair<int, int>, JointRates> rates;
    for (const LimitContact& contact : problem.contacts) {
        JointRates& rate = rates[std::minmax(contact.block_a, contact.block_b)];
        const Vector3d apart =
            velocity_at(contact.block_a, contact.position) - velocity_at(contact.block_b, contact.position);
        const double opening = apart.dot(contact.normal);
        const double slip = (apart - opening * contact.normal).norm();
        rate.least_opening = std::min(rate.least_opening, opening);
        rate.most_opening = std::max(rate.most_opening, opening);
        rate.least_slip = std::min(rate.least_slip, slip);
        rate.most_slip = std::max(rate.most_slip, slip);
    }
    std::vector<MovingJoint> joints;
    for (const auto& [pair, rate] : rates) {
        if (std::max(rate.most_opening, rate.most_slip) < moving * fastest) continue;
        const bool slides = rate.least_slip > rate.most_opening - rate.least_opening;
        joints.push_back({pair.first, pair.second, slides});
    }
    return joints;
}

/// A table that is tilted turns gravity; friction alone knows directions of forces, not their size.
double tilt_of(const LimitStudy& study, const Vector3d& gravity)
{
    const bool level = std::abs(study.towards.dot(gravity)) < 1e-9 * gravity.norm();
    if (!level || study.bonded_points > 0 || study.bars > 0) return 0;
    return std::atan(study.associated.factor * standard_gravity / gravity.norm()) * 180 / std::numbers::pi;
}

std::vector<std::string> left_out_of(const Case& the_case, const Stage& stage)
{
    std::vector<std::string> out;
    const auto any = [&](const auto& has) {
        return std::any_of(the_case.stages.begin(), the_case.stages.end(), has);
    };
    if (any([](const Stage& s) { return !s.motions.empty() || !s.incoming_waves.empty(); }))
        out.emplace_back("motions of the ground");
    if (any([](const Stage& s) { return !s.body_accelerations.empty(); })) out.emplace_back("body accelerations");
    if (any([&](const Stage& s) { return s.gravity != stage.gravity; }))
        out.push_back(fmt::format("gravity of stages after '{}'", stage.name));
    if (!the_case.model.initial_motions.empty()) out.emplace_back("initial motions");
    return out;
}

void expect_known(const Case& the_case, const Vector3d& gravity)
{
    const Model& model = the_case.model;
    if (!voussoir::limit::is_known_to_limit_analysis(model))
        throw InputError("limit", "ground that carries waves (boundary) takes any force",
                         "ask a case whose foundation is fixed");
    if (gravity.norm() == 0)
        throw InputError("limit", "the first stage has no gravity",
                         "give it: a structure without weight has no limit");
    if (model.foundations.empty())
        throw InputError("limit", "no block is a foundation",
                         "give one that holds the others (foundation: fixed)");
}

}  // namespace

LimitStudy limit_study(const Case& the_case, const Vector3d& towards, const std::function<void()>& between)
{
    const Model& model = the_case.model;
    const Stage& stage = the_case.stages.front();
    expect_known(the_case, stage.gravity);
    if (is_planar(model.kinematics) && towards.y() != 0)
        throw InputError("--towards", fmt::format("y = {:g} in a planar case", towards.y()),
                         "give a direction in x and z");
    LimitStudy study;
    study.case_name = the_case.file.filename().string();
    study.towards = towards.normalized();
    for (const Block& block : model.blocks) study.block_names.push_back(block.name);
    study.left_out = left_out_of(the_case, stage);

    const State state = initial_state(model);
    const Vector3d live = standard_gravity * study.towards;
    const auto problem = [&](FacePoints points) {
        return voussoir::limit::problem_in(model, state, stage.gravity, live, bearing_reach, points);
    };
    const LimitProblem corners = problem(FacePoints::corners);
    study.contact_points = static_cast<int>(corners.contacts.size());
    study.bonded_points =
        static_cast<int>(std::count_if(corners.contacts.begin(), corners.contacts.end(),
                                       [](const LimitContact& contact) { return contact.cohesion > 0; }));
    study.bars = static_cast<int>(corners.bars.size());
    study.associated = voussoir::limit::collapse_load(corners, between);
    if (study.associated.outcome != UnderLoad::limited) return study;
    study.stones = moving_stones(model, study.associated.velocities);
    study.joints = moving_joints(model, corners, study.associated.velocities);
    study.tilt = tilt_of(study, stage.gravity);
    study.sliding = voussoir::limit::sliding_bracket(problem(FacePoints::all), study.associated.factor, between);
    return study;
}

}  // namespace voussoir::app::studies::limit
