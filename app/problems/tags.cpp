#include "app/problems/tags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace voussoir::app::problems
{

namespace
{

using Tags = std::vector<std::string>;

constexpr double at_rest = 1e-4;  // m/s of a block, below which it rests
constexpr double turning = 0.01;  // rad/s of a block, from which it rocks
constexpr double upright = 0.5;   // z of the normal of a joint, below which its stones knock rather than land

void add_if(bool holds, const char* tag, Tags& tags)
{
    if (holds) tags.emplace_back(tag);
}

void add_of_model(const Model& model, Tags& tags)
{
    const auto any_joint = [&](const auto& has) {
        return std::any_of(model.joints.begin(), model.joints.end(), has);
    };
    const auto any_material = [&](const auto& has) {
        return std::any_of(model.materials.begin(), model.materials.end(), has);
    };
    tags.emplace_back(is_planar(model.kinematics) ? "planar" : "spatial");
    tags.emplace_back(is_deformable(model.kinematics) ? "deformable" : "rigid");
    add_if(!model.bars.empty(), "bars", tags);
    add_if(!model.boundaries.empty(), "boundary", tags);
    add_if(!model.tied_sides.empty(), "tied sides", tags);
    add_if(!model.side_ties.empty(), "periodic sides", tags);
    add_if(any_joint([](const JointMaterial& joint) { return joint.has_strength(); }), "bonds", tags);
    add_if(any_joint([](const JointMaterial& joint) { return !joint.friction_at_speed.empty(); }),
           "friction at speed", tags);
    add_if(any_joint([](const JointMaterial& joint) { return joint.relaxation_time > 0; }), "dashpots", tags);
    add_if(any_material([](const BlockMaterial& stone) { return stone.rayleigh.any(); }), "Rayleigh damping",
           tags);
}

template <int D>
int intact_patches(const ContactSetIn<D>& contacts)
{
    return static_cast<int>(std::count_if(contacts.patches.begin(), contacts.patches.end(),
                                          [](const ContactPatchIn<D>& patch) { return patch.intact; }));
}

/// The points of a state that press, by what names them from step to step.
template <int D>
auto pressing_points(const ContactSetIn<D>& contacts)
{
    std::map<std::array<std::uint32_t, 5>, const ContactPointIn<D>*> points;
    const auto number = [](int index) { return static_cast<std::uint32_t>(index); };
    for (const ContactPatchIn<D>& patch : contacts.patches)
        for (int i = 0; i < patch.point_count; ++i) {
            const auto& point = contacts.points[static_cast<std::size_t>(patch.first_point + i)];
            if (point.normal_force > 0)
                points[{number(patch.block_a), number(patch.block_b), number(patch.part_a), number(patch.part_b),
                        point.feature}] = &point;
        }
    return points;
}

/// What became of points that slid: whether one rubs the other way, and whether one has come to stick.
template <int D>
void add_of_slip(const ContactSetIn<D>& before, const ContactSetIn<D>& after, Tags& tags)
{
    const auto old = pressing_points(before), now = pressing_points(after);
    bool slides = false, turns = false, sticks = false;
    for (const auto& [name, point] : now) {
        slides = slides || point->status == ContactStatus::sliding;
        const auto found = old.find(name);
        if (found == old.end() || found->second->status != ContactStatus::sliding) continue;
        turns = turns || found->second->shear_force.dot(point->shear_force) < 0;
        sticks = sticks || point->status == ContactStatus::locked;
    }
    add_if(slides, "sliding", tags);
    add_if(turns, "reversal", tags);
    add_if(sticks, "sticking", tags);
}

/// Joints that have opened at some of their points and carry at others, of blocks that turn.
template <int D>
bool rocks(const Model& model, const State& state)
{
    const ContactSetIn<D>& contacts = contacts_in<D>(state);
    const auto turns = [&](int block) { return angular_velocity_of(model, state, block).norm() > turning; };
    return std::any_of(contacts.patches.begin(), contacts.patches.end(), [&](const ContactPatchIn<D>& patch) {
        const auto first = contacts.points.begin() + patch.first_point, end = first + patch.point_count;
        const auto open = std::count_if(
            first, end, [](const ContactPointIn<D>& point) { return point.status == ContactStatus::open; });
        return open > 0 && open < patch.point_count && (turns(patch.block_a) || turns(patch.block_b));
    });
}

/// Stones that came to press on each other sideways in the step.
template <int D>
bool knocks(const ContactSetIn<D>& before, const ContactSetIn<D>& after)
{
    const auto pressed = [](const ContactSetIn<D>& contacts) {
        std::map<std::pair<int, int>, bool> pairs;
        for (const ContactPatchIn<D>& patch : contacts.patches)
            for (int i = 0; i < patch.point_count; ++i)
                if (std::abs(patch.normal[D - 1]) < upright &&
                    contacts.points[static_cast<std::size_t>(patch.first_point + i)].normal_force > 0)
                    pairs[std::minmax(patch.block_a, patch.block_b)] = true;
        return pairs;
    };
    const auto old = pressed(before), now = pressed(after);
    return std::any_of(now.begin(), now.end(), [&](const auto& pair) { return !old.contains(pair.first); });
}

bool rests(const Model& model, const State& state)
{
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (velocity_of(model.kinematics, state, b).norm() > at_rest ||
            angular_velocity_of(model, state, b).norm() * size_of(model, b) > at_rest)
            return false;
    return true;
}

template <int D>
void add_of_step(const Model& model, const SeenStep& step, Tags& tags)
{
    const ContactSetIn<D>&before = contacts_in<D>(step.before), &after = contacts_in<D>(step.after);
    add_if(rocks<D>(model, step.after), "rocking", tags);
    add_of_slip<D>(before, after, tags);
    add_if(step.impact > 0, "landing", tags);
    add_if(knocks<D>(before, after), "knocking", tags);
    add_if(step.fracture > 0 || intact_patches(after) < intact_patches(before), "breaking", tags);
}

}  // namespace

std::vector<std::string> tags_of(const Model& model, const Stage& stage, const SeenStep& step)
{
    Tags tags;
    add_of_model(model, tags);
    add_if(stage.type == StageType::static_equilibrium, "static", tags);
    const bool is_at_rest = rests(model, step.after);
    add_if(is_at_rest, "rest", tags);
    add_if(!is_at_rest && stage.type == StageType::dynamic, "moving", tags);
    if (is_planar(model.kinematics))
        add_of_step<2>(model, step, tags);
    else
        add_of_step<3>(model, step, tags);
    add_if(step.report.divided, "divided", tags);
    add_if(step.report.cuts > 0, "cut", tags);
    return tags;
}

}  // namespace voussoir::app::problems
