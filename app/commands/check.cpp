#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/commands/after_run.h"
#include "app/commands/certificate.h"
#include "app/commands/commands.h"
#include "app/commands/describe_case.h"
#include "app/commands/outputs.h"
#include "app/commands/say.h"
#include "app/commands/trust_watch.h"
#include "app/reader/automatic_steps.h"
#include "app/reader/case_file.h"
#include "app/results/scene_vectors.h"
#include "app/words/trust_words.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

// Floating-point operations: a second or two, and then modes are not sought (output: {trust: always} insists).
constexpr double worth_waiting_for = 1e9;

/// All contact patches of one pair of blocks.
struct PairContact {
    int points = 0;
    double area = 0;                                    // m2
    double smallest_gap = 1e300;                        // m, < 0 overlapping
    double least_stiffness = 1e300, max_stiffness = 0;  // Pa/m
};

using PairContacts = std::map<std::pair<int, int>, PairContact>;

template <int D>
void add_contacts(const ContactSetIn<D>& contacts, PairContacts& pairs)
{
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        PairContact& pair = pairs[std::minmax(patch.block_a, patch.block_b)];
        pair.points += patch.point_count;
        pair.least_stiffness = std::min(pair.least_stiffness, patch.stiffness);
        pair.max_stiffness = std::max(pair.max_stiffness, patch.stiffness);
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts.points[i];
            pair.area += point.area;
            pair.smallest_gap = std::min(pair.smallest_gap, point.gap + point.rest_gap);
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
    say("blocks:");
    say(fmt::format("  {:<24} {:<14} {:<12} {:>12} {:>12}  centroid m", "name", "group", "material", "volume m3",
                    "mass kg"));
    double volume = 0, mass = 0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const Block& block = model.blocks[i];
        const std::vector<double> centroid =
            results::stored_vector(block.moments.centroid + model.origin, model.kinematics);
        volume += block.moments.volume;
        mass += model.mass(static_cast<int>(i));
        if (i == max_rows) say("  ... (--json has all blocks)");
        if (i >= max_rows) continue;
        say(fmt::format("  {:<24} {:<14} {:<12} {:>12.6g} {:>12.6g}  [{:.4f}]", block.name,
                        model.groups[block.group], model.materials[block.material].name, block.moments.volume,
                        model.mass(static_cast<int>(i)), fmt::join(centroid, ", ")));
    }
    say(fmt::format("  {:<24} {:<14} {:<12} {:>12.6g} {:>12.6g}", "all", "", "", volume, mass));
}

void print_foundations(const Model& model)
{
    std::size_t row = 0;
    for (const Foundation& foundation : model.foundations) {
        if (row++ == max_rows) say(fmt::format("and {} more foundations", model.foundations.size() - max_rows));
        if (row > max_rows) return;
        std::string held;
        for (const int axis : axes_of(model.kinematics))
            held += fmt::format("{} {}, ", static_cast<char>('x' + axis),
                                foundation.translation_held[axis] ? "fixed" : "free");
        say(fmt::format("foundation {}: {}rotation {}", model.blocks[foundation.block].name, held,
                        foundation.rotation_held ? "fixed" : "free"));
    }
}

void print_initial_motions(const Model& model)
{
    std::size_t row = 0;
    for (const InitialMotion& motion : model.initial_motions) {
        if (row++ == max_rows)
            say(fmt::format("and {} more initial motions", model.initial_motions.size() - max_rows));
        if (row > max_rows) return;
        say(fmt::format("initial motion of {}: velocity [{:g}, {:g}, {:g}] m/s, spin [{:g}, {:g}, {:g}] rad/s",
                        model.blocks[motion.block].name, motion.velocity.x(), motion.velocity.y(),
                        motion.velocity.z(), motion.spin.x(), motion.spin.y(), motion.spin.z()));
    }
}

void print_contacts(const Model& model)
{
    const auto pairs = contacts_by_pair(model);
    std::size_t row = 0;
    int points = 0;
    double area = 0;
    say("contacts:");
    say(fmt::format("  {:<49} {:>6} {:>10} {:>13} {:>12}  joint", "blocks", "points", "area m2", "smallest gap",
                    "Pa/m"));
    for (const auto& [pair, contact] : pairs) {
        const auto& [a, b] = pair;
        points += contact.points;
        area += contact.area;
        if (row++ == max_rows) say("  ... (contact_graph.csv of -o DIR has all pairs)");
        if (row > max_rows) continue;
        say(fmt::format("  {:<24} {:<24} {:>6} {:>10.4g} {:>11.1e} m {:>12.4g}  {}", model.blocks[a].name,
                        model.blocks[b].name, contact.points, contact.area, contact.smallest_gap,
                        contact.max_stiffness, model.joint_between(a, b).name));
    }
    say(fmt::format("  {} pair{} of blocks, {} points, {:.6g} m2", pairs.size(), pairs.size() == 1 ? "" : "s",
                    points, area));
}

/// "1 motion", "2 motions".
std::string counted(std::size_t count, const std::string& thing)
{
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

void print_stages(const std::vector<Stage>& stages)
{
    for (const Stage& stage : stages) {
        const bool is_dynamic = stage.type == StageType::dynamic;
        say(fmt::format(
            "stage {}: {}, time step {:g} s{}, {}, {}{}", stage.name, is_dynamic ? "dynamic" : "static",
            stage.control.time_step, is_dynamic ? fmt::format(", {:g} s", stage.duration) : "",
            counted(stage.motions.size(), "motion"), counted(stage.body_accelerations.size(), "body acceleration"),
            stage.incoming_waves.empty() ? "" : ", " + counted(stage.incoming_waves.size(), "incoming wave")));
    }
}

/// What can be said before the run of how much it is to be trusted, as it is drawn: every joint closed.
void tell_trust(const Case& the_case)
{
    if (the_case.output.trust == TrustFigures::never) return;
    const State state = initial_state(the_case.model);
    ModesSearch search;
    search.most_work = std::max(reader::most_work_of_modes(the_case), worth_waiting_for);
    const Trust trust = trust_in({false, natural_modes(the_case.model, state, search), {}}, the_case.stages, {});
    say(fmt::format("as drawn, all joints closed: {}", words::vibrations_in_words(trust)));
    for (const NaturalMode& mode : trust.start.modes.modes) {
        const Eigen::Vector3d share = 100 * mode.mass_share;
        say(fmt::format("  {:>8.4g} Hz, {:3.0f}, {:3.0f}, {:3.0f} % of the mass along x, y, z", mode.frequency,
                        share.x(), share.y(), share.z()));
    }
    for (const std::string& warning : words::warnings_of(trust, the_case.stages))
        say(fmt::format("warning: {}", warning));
}

void print_all(const Case& the_case)
{
    print_case(the_case);
    print_materials(the_case.model);
    print_blocks(the_case.model);
    print_foundations(the_case.model);
    print_initial_motions(the_case.model);
    print_contacts(the_case.model);
    print_stages(the_case.stages);
    tell_trust(the_case);
}

/// How the stones stand together. Of a case whose stones could not all be read, those of its meshes that could.
void examine(const reader::CaseStones& stones, bool complete, CertifiedCase& certified)
{
    importers::assembly::AssemblyOrigin origin;
    origin.from_case = true;
    origin.apart = {stones.apart.begin(), stones.apart.end()};
    certified.meshes = stones.geometry.meshes;
    certified.overlaps = stones.geometry.overlaps;
    certified.fit = stones.geometry.fit;
    certified.origin = stones.model.origin;
    certified.fit_tolerance = stones.model.fit_tolerance;
    if (certified.meshes.size() == 1) origin.metres_per_unit = certified.meshes.front().metres_per_unit;
    const bool has_refused = std::any_of(certified.meshes.begin(), certified.meshes.end(),
                                         [](const auto& mesh) { return !mesh.accepted; });
    if (!complete && has_refused) {
        const bool in_space = !is_planar(stones.model.kinematics);
        certified.assembly =
            assembly_of(certified.meshes, certified.overlaps, origin, in_space ? &stones.model : nullptr);
        return;
    }
    std::map<std::string, double> errors;
    for (const importers::helper::ImportedMesh& mesh : certified.meshes)
        for (const importers::helper::Stone& stone : mesh.stones) errors[stone.name] = stone.volume_error;
    certified.assembly = assembly_of(stones.model, errors, origin);
}

CertifiedCase certify(const CheckArguments& arguments, bool print)
{
    CertifiedCase certified;
    certified.file = arguments.case_file.string();
    certified.title = arguments.case_file.stem().string();
    reader::CaseStones stones;
    try {
        const Case the_case = reader::read_case(arguments.case_file, arguments.overrides, &stones);
        expect_tools(the_case);
        certified.title = the_case.title;
        certified.warnings = the_case.warnings;
        if (print) print_all(the_case);
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults) {
            certified.faults.push_back(to_sentence(fault));
            complain(certified.faults.back());
        }
    }
    if (print && arguments.verbose) print_repairs(stones.geometry);
    examine(stones, certified.faults.empty(), certified);
    return certified;
}

bool write_folder(const CertifiedCase& certified, const std::filesystem::path& folder)
{
    make_output_folder(folder);
    write_own_file(folder / "certificate.json", certificate_json(certified) + "\n");
    write_contact_graph(certified.assembly, folder / "contact_graph.csv");
    return draw_certificate(certified.title, certified.assembly, certified.meshes, folder);
}

}  // namespace

int check_command(const CheckArguments& arguments)
{
    expect_writable(arguments.json, arguments.folder);
    const bool print = !(arguments.json && *arguments.json == "-");
    const CertifiedCase certified = certify(arguments, print);
    const bool can_run = certified.faults.empty();
    if (print && !can_run) print_contact_graph(certified.assembly);
    if (print) print_findings(certified.assembly);
    if (arguments.json) write_json_text(*arguments.json, certificate_json(certified));
    const bool complete = !arguments.folder || write_folder(certified, *arguments.folder);
    if (print && arguments.folder) say(fmt::format("written to {}", arguments.folder->string()));
    if (print && can_run) say("the case can be run");
    if (!can_run) return exit_bad_input;
    return complete ? exit_done : exit_failure;
}

}  // namespace voussoir::app::commands
