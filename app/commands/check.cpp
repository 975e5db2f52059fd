#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/case/case_file.h"
#include "app/commands/commands.h"
#include "app/commands/describe_case.h"
#include "app/results/scene_vectors.h"
#include "libdda/step/advance.h"

namespace voussoir
{
namespace
{

/// All contact patches of one pair of blocks.
struct PairContact {
    int points = 0;
    double area = 0;                                     // m2
    double smallest_gap = 1e300;                         // m, < 0 overlapping
    double least_stiffness = 1e300, most_stiffness = 0;  // Pa/m
};

using PairContacts = std::map<std::pair<int, int>, PairContact>;

template <int D>
void add_contacts(const ContactSetIn<D>& contacts, PairContacts& pairs)
{
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        PairContact& pair = pairs[std::minmax(patch.block_a, patch.block_b)];
        pair.points += patch.point_count;
        pair.least_stiffness = std::min(pair.least_stiffness, patch.stiffness);
        pair.most_stiffness = std::max(pair.most_stiffness, patch.stiffness);
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            pair.area += contacts.points[i].area;
            pair.smallest_gap = std::min(pair.smallest_gap, contacts.points[i].gap);
        }
    }
}

PairContacts contacts_by_pair(const Model& model)
{
    State state = initial_state(model);
    find_initial_contacts(model, state);
    PairContacts pairs;
    add_contacts(state.contacts, pairs);
    add_contacts(state.planar_contacts, pairs);
    return pairs;
}

void print_blocks(const Model& model)
{
    fmt::print("blocks:\n  {:<24} {:<14} {:<12} {:>12} {:>12}  centroid m\n", "name", "group", "material",
               "volume m3", "mass kg");
    double volume = 0, mass = 0;
    for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i) {
        const Block& block = model.blocks[i];
        const std::vector<double> centroid =
            stored_vector(block.moments.centroid + model.origin, model.kinematics);
        fmt::print("  {:<24} {:<14} {:<12} {:>12.6g} {:>12.6g}  [{:.4f}]\n", block.name, model.groups[block.group],
                   model.materials[block.material].name, block.moments.volume, model.mass(i),
                   fmt::join(centroid, ", "));
        volume += block.moments.volume;
        mass += model.mass(i);
    }
    fmt::print("  {:<24} {:<14} {:<12} {:>12.6g} {:>12.6g}\n", "all", "", "", volume, mass);
}

void print_foundations(const Model& model)
{
    for (const Foundation& foundation : model.foundations) {
        std::string held;
        for (const int axis : axes_of(model.kinematics))
            held += fmt::format("{} {}, ", static_cast<char>('x' + axis),
                                foundation.translation_held[axis] ? "fixed" : "free");
        fmt::print("foundation {}: {}rotation {}\n", model.blocks[foundation.block].name, held,
                   foundation.rotation_held ? "fixed" : "free");
    }
}

void print_contacts(const Model& model)
{
    const auto pairs = contacts_by_pair(model);
    std::vector<bool> touches(model.blocks.size(), false);
    int points = 0;
    double area = 0;
    fmt::print("contacts:\n  {:<49} {:>6} {:>10} {:>13} {:>12}  joint\n", "blocks", "points", "area m2",
               "smallest gap", "Pa/m");
    for (const auto& [pair, contact] : pairs) {
        const auto& [a, b] = pair;
        touches[a] = touches[b] = true;
        points += contact.points;
        area += contact.area;
        fmt::print("  {:<24} {:<24} {:>6} {:>10.4g} {:>11.1e} m {:>12.4g}  {}\n", model.blocks[a].name,
                   model.blocks[b].name, contact.points, contact.area, contact.smallest_gap,
                   contact.most_stiffness, model.joint_between(a, b).name);
    }
    fmt::print("  {} pairs of blocks, {} points, {:.6g} m2\n", pairs.size(), points, area);
    for (std::size_t i = 0; i < touches.size(); ++i)
        if (!touches[i]) fmt::print("warning: block {} touches no other\n", model.blocks[i].name);
}

void print_stages(const std::vector<Stage>& stages)
{
    for (const Stage& stage : stages) {
        const bool is_dynamic = stage.type == StageType::dynamic;
        fmt::print("stage {}: {}, time step {:g} s{}, {} motions, {} body accelerations\n", stage.name,
                   is_dynamic ? "dynamic" : "static", stage.control.time_step,
                   is_dynamic ? fmt::format(", {:g} s", stage.duration) : "", stage.motions.size(),
                   stage.body_accelerations.size());
    }
}

}  // namespace

int check_command(const CheckArguments& arguments)
{
    const Case the_case = read_case(arguments.case_file, arguments.overrides);
    print_case(the_case);
    print_materials(the_case.model);
    print_blocks(the_case.model);
    print_foundations(the_case.model);
    print_contacts(the_case.model);
    print_stages(the_case.stages);
    fmt::print("the case can be run\n");
    return exit_done;
}

}  // namespace voussoir
