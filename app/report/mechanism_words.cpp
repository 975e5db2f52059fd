#include "app/report/mechanism_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/words/stones_in_words.h"

namespace voussoir::app::report
{

using Eigen::Vector3d;

namespace
{

// With the sentences around them a dozen, whatever the size of the structure.
constexpr std::size_t most_told = 9;         // joints and bodies, one by one
constexpr std::size_t most_kinds_told = 4;   // of joints that do the same between the same parts; the rest in one
constexpr std::size_t most_bodies_told = 3;  // the rest in one

std::string number(int n)
{
    constexpr std::array<const char*, 13> words = {"no",    "one",   "two",  "three", "four",   "five",  "six",
                                                   "seven", "eight", "nine", "ten",   "eleven", "twelve"};
    return n >= 0 && n < static_cast<int>(words.size()) ? words[n] : std::to_string(n);
}

std::string degrees(double radians)
{
    const double degrees = radians * 180 / std::numbers::pi;
    return degrees < 100 ? fmt::format("{:.2g}°", degrees) : fmt::format("{:.0f}°", degrees);
}

/// "upper edge", or "edge towards -x" in a joint that lies flat.
std::string edge_in_words(const Vector3d& edge)
{
    if (std::abs(edge.z()) > 0.4) return edge.z() > 0 ? "upper edge" : "lower edge";
    const int axis = std::abs(edge.x()) >= std::abs(edge.y()) ? 0 : 1;
    return fmt::format("edge towards {}{}", edge[axis] > 0 ? '+' : '-', "xy"[axis]);
}

std::string joint_in_words(const MovedJoint& moved, const results::RecordedModel& model)
{
    const WatchedJoint& joint = model.joints[moved.joint];
    const std::string pair = model.block_names[joint.block_a] + " and " + model.block_names[joint.block_b];
    const std::string opening = length_in_words(moved.opening), slip = length_in_words(moved.slip);
    if (moved.parted)
        return fmt::format("{} have come apart: {} open{}", pair, opening,
                           moved.slides ? ", " + slip + " of slip" : "");
    if (!moved.opens) return fmt::format("{} slide on each other: {} of slip", pair, slip);
    const std::string hinge = fmt::format("Hinge between {}: turns about its {}, {} open, {}", pair,
                                          edge_in_words(moved.edge), opening, degrees(moved.turn));
    return moved.slides ? hinge + ", and slides by " + slip : hinge;
}

std::string body_in_words(const Body& body, const results::RecordedModel& model)
{
    return fmt::format("{}{}: moved by {}, turned by {}.", body.blocks.size() > 1 ? "Moves as one: " : "",
                       words::stones_in_words(body.blocks, model.block_names), length_in_words(body.displacement),
                       degrees(body.turn));
}

/// "voussoir and voussoir" is "joints of voussoir".
std::string parts_of(const MovedJoint& moved, const results::RecordedModel& model)
{
    const WatchedJoint& joint = model.joints[static_cast<std::size_t>(moved.joint)];
    const std::string a = words::part_of(model.block_names[static_cast<std::size_t>(joint.block_a)]),
                      b = words::part_of(model.block_names[static_cast<std::size_t>(joint.block_b)]);
    return a == b ? "within " + a : "between " + std::min(a, b) + " and " + std::max(a, b);
}

/// Joints that do the same between the same parts: the most moved of them, and how many they are.
struct JointsAlike {
    const MovedJoint* most = nullptr;
    std::string where;
    int count = 0;
};

std::vector<JointsAlike> alike_in(const Mechanism& mechanism, const results::RecordedModel& model)
{
    std::vector<JointsAlike> kinds;
    for (const MovedJoint& joint : mechanism.joints) {
        const std::string where = parts_of(joint, model);
        const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const JointsAlike& kind) {
            return kind.where == where && kind.most->parted == joint.parted && kind.most->opens == joint.opens;
        });
        if (same == kinds.end())
            kinds.push_back({&joint, where, 1});
        else
            ++same->count;
    }
    std::stable_sort(kinds.begin(), kinds.end(), [](const JointsAlike& a, const JointsAlike& b) {
        return std::max(a.most->opening, a.most->slip) > std::max(b.most->opening, b.most->slip);
    });
    return kinds;
}

/// "12 joints within wall turn, most of all: Hinge between ..."
std::vector<std::string> joints_together(const Mechanism& mechanism, const results::RecordedModel& model)
{
    std::vector<std::string> lines;
    const std::vector<JointsAlike> kinds = alike_in(mechanism, model);
    const std::size_t told = kinds.size() <= most_kinds_told + 1 ? kinds.size() : most_kinds_told;
    for (std::size_t i = 0; i < told; ++i) {
        const MovedJoint& most = *kinds[i].most;
        const char* does = most.parted ? "have come apart" : most.opens ? "turn" : "slide";
        const std::string one = joint_in_words(most, model) + ".";
        lines.push_back(kinds[i].count == 1 ? one
                                            : fmt::format("{} joints {} {}; the one that moved most: {}",
                                                          kinds[i].count, kinds[i].where, does, one));
    }
    int rest = 0;
    for (std::size_t i = told; i < kinds.size(); ++i) rest += kinds[i].count;
    if (rest > 0)
        lines.push_back(fmt::format("{} joints elsewhere moved less; the table of joints has all.", rest));
    return lines;
}

std::vector<std::string> bodies_together(const std::vector<const Body*>& moving,
                                         const results::RecordedModel& model)
{
    std::vector<std::string> lines;
    const std::size_t told = moving.size() <= most_bodies_told + 1 ? moving.size() : most_bodies_told;
    Body rest;
    for (std::size_t i = 0; i < moving.size(); ++i) {
        if (i < told) {
            lines.push_back(body_in_words(*moving[i], model));
            continue;
        }
        rest.blocks.insert(rest.blocks.end(), moving[i]->blocks.begin(), moving[i]->blocks.end());
        rest.displacement = std::max(rest.displacement, moving[i]->displacement);
        rest.turn = std::max(rest.turn, moving[i]->turn);
    }
    if (!rest.blocks.empty())
        lines.push_back(fmt::format("{} more bodies: {}; moved by up to {}, turned by up to {}.",
                                    moving.size() - told, words::stones_in_words(rest.blocks, model.block_names),
                                    length_in_words(rest.displacement), degrees(rest.turn)));
    return lines;
}

/// What opened and slid in all, and most.
std::string of_what_stands(const Mechanism& mechanism, const results::RecordedModel& model, const Course& course)
{
    const int opened = course.joints_opened, slid = course.joints_slid;
    const char* state = mechanism.goes_on ? "Nothing has come off as far as the run went" : "The structure stands";
    if (opened + slid == 0) return fmt::format("{}; no joint opened or slid by more than 0.1 mm.", state);
    if (mechanism.joints.empty())
        return fmt::format("{}. Of {} joints {} opened and {} slid by more than 0.1 mm.", state,
                           model.joints.size(), opened, slid);
    const MovedJoint& most = mechanism.joints.front();
    const WatchedJoint& joint = model.joints[most.joint];
    return fmt::format(
        "{}. Of {} joints {} opened and {} slid by more than 0.1 mm, most at t = {:.3g} s between {} and "
        "{}: {} open, {} of slip. At the end {} remain open and {} slid.",
        state, model.joints.size(), opened, slid, mechanism.time, model.block_names[joint.block_a],
        model.block_names[joint.block_b], length_in_words(most.opening), length_in_words(most.slip),
        length_in_words(course.opening.back()), length_in_words(course.slip.back()));
}

/// The blocks that move, and how far they have turned at the end.
struct Moving {
    std::vector<int> blocks;
    int bodies = 0;
    double last_turn = 0;  // rad
};

Moving moving_in(const Mechanism& mechanism)
{
    Moving moving;
    for (const Body& body : mechanism.bodies) {
        if (body.rests || !(std::max(body.displacement, body.last_displacement) > noteworthy_opening)) continue;
        ++moving.bodies;
        moving.blocks.insert(moving.blocks.end(), body.blocks.begin(), body.blocks.end());
        moving.last_turn = std::max(moving.last_turn, body.last_turn);
    }
    std::sort(moving.blocks.begin(), moving.blocks.end());
    return moving;
}

/// "one body", "three bodies".
std::string count_of(int n, const char* one, const char* several)
{
    return number(n) + " " + (n == 1 ? one : several);
}

/// "two hinges" as words that follow others; empty when there are none.
std::string also(const char* before, int n, const char* one, const char* several)
{
    return n == 0 ? "" : before + count_of(n, one, several);
}

/// " What else moved stays, ..."; empty where all that moved has moved off.
std::string of_what_stays(const Mechanism& mechanism)
{
    double most = 0;
    for (const Body& body : mechanism.bodies)
        if (body.stays) most = std::max(most, body.last_displacement);
    return most > 0
               ? fmt::format(" What else moved stays, up to {} from its place at the end.", length_in_words(most))
               : "";
}

std::string of_what_moves_off(const Mechanism& mechanism, const results::RecordedModel& model)
{
    const Moving moving = moving_in(mechanism);
    const bool partly =
        std::any_of(mechanism.bodies.begin(), mechanism.bodies.end(), [](const Body& body) { return body.stays; });
    const char* subject = partly ? "Part of the structure" : "The structure";
    const std::string names = words::stones_in_words(moving.blocks, model.block_names);
    const int turning = mechanism.hinges + mechanism.parted, stones = static_cast<int>(moving.blocks.size());
    const std::string bodies = count_of(moving.bodies, "body of stones moves", "bodies of stones move"),
                      who = count_of(stones, "stone", "stones"), hinges = count_of(turning, "hinge", "hinges"),
                      places = count_of(mechanism.sliding, "place", "places");
    switch (mechanism.kind) {
        case MechanismKind::hinges:
            return fmt::format("{} fails as a mechanism of {}: {} ({}).", subject, hinges, bodies, names);
        case MechanismKind::slides:
            return fmt::format("{} fails by sliding at {}{}: {} ({}).", subject, places,
                               also(", while it turns at ", turning, "other", "others"), bodies, names);
        case MechanismKind::overturns:
            return fmt::format("{} overturns about {}: {} ({}); turned by up to {} at the end.", subject,
                               count_of(mechanism.hinges > 0 ? mechanism.hinges : turning, "edge", "edges"), who,
                               names, degrees(moving.last_turn));
        case MechanismKind::sheds:
            return fmt::format("The structure sheds its upper part by {}: {} off ({}), what is below stays.",
                               mechanism.slip > mechanism.opening ? "sliding" : "turning over",
                               count_of(stones, "stone comes", "stones come"), names);
        case MechanismKind::mixed:
            return fmt::format("{} fails by turning and sliding together: {}, sliding at {}; {} ({}).", subject,
                               hinges, places, bodies, names);
        case MechanismKind::loose:
            if (stones == 0)
                return "The structure did not stand, but no stone had moved by more than 0.1 mm in any stored "
                       "frame.";
            return fmt::format("Stones that no joint held at the start moved off: {} ({}).", who, names);
        case MechanismKind::stands:
            break;
    }
    return "";
}

}  // namespace

std::string stress_in_words(double pascals)
{
    const bool small = std::abs(pascals) < 1e5;
    return fmt::format("{:.3g} {}", pascals / (small ? 1e3 : 1e6), small ? "kPa" : "MPa");
}

const char* name_of(MechanismKind kind)
{
    constexpr std::array<const char*, 7> names = {"stands", "hinges", "slides", "overturns",
                                                  "sheds",  "mixed",  "loose"};
    return names.at(static_cast<std::size_t>(kind));
}

MechanismWords words_of(const Mechanism& mechanism, const results::RecordedModel& model, const Course& course)
{
    MechanismWords words;
    words.headline = mechanism.kind == MechanismKind::stands
                         ? of_what_stands(mechanism, model, course)
                         : of_what_moves_off(mechanism, model) + of_what_stays(mechanism);
    std::vector<const Body*> moving;
    for (const Body& body : mechanism.bodies)
        if (!body.rests) moving.push_back(&body);
    if (mechanism.joints.size() + moving.size() > most_told) {
        words.joints = joints_together(mechanism, model);
        words.bodies = bodies_together(moving, model);
        return words;
    }
    for (const MovedJoint& joint : mechanism.joints) words.joints.push_back(joint_in_words(joint, model) + ".");
    for (const Body* body : moving) words.bodies.push_back(body_in_words(*body, model));
    return words;
}

}  // namespace voussoir::app::report
