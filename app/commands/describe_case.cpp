#include "app/commands/describe_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/commands/say.h"
#include "app/results/results_writer.h"
#include "app/results/settings.h"
#include "importers/helper/repair_summary.h"
#include "libdda/analysis/integrator_accuracy.h"
#include "libdda/block/block_step.h"

namespace voussoir::app::commands
{
namespace
{

constexpr std::size_t line_width = 110;

/// Prints a list as lines "heading: a, b, ...", broken between words and indented below the first.
void print_wrapped(const std::string& text, const std::string& indent)
{
    std::string line;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        const std::string word = text.substr(start, end - start);
        if (line.size() > indent.size() && line.size() + 1 + word.size() > line_width) {
            say(line);
            line = indent + "  ";
        }
        if (line.empty()) line = indent;
        line += (line.find_first_not_of(' ') == std::string::npos ? "" : " ") + word;
        start = end + 1;
    }
    say(line);
}

void print_list(const std::string& heading, const std::vector<std::string>& lines)
{
    if (lines.empty()) return;
    say(fmt::format("{}:", heading));
    for (const std::string& line : lines) print_wrapped(line, "  ");
}

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string in_words(const ContactStiffness& stiffness)
{
    const std::string times = stiffness.factor == 1 ? "" : fmt::format(" x {:g}", stiffness.factor);
    if (stiffness.kind == ContactStiffness::Kind::per_area)
        return fmt::format("{:g} Pa/m{}", stiffness.value, times);
    if (stiffness.kind == ContactStiffness::Kind::per_point)
        return fmt::format("{:g} N/m per contact point{}", stiffness.value, times);
    if (stiffness.value > 0) return fmt::format("{:g} E/L of the blocks{}", stiffness.value, times);
    return "from the blocks' modulus and depth" + times;
}

/// "planar deformable (plane strain, 12 m thick)".
std::string in_words(const Model& model)
{
    std::string words(name_of(model.kinematics));
    if (!is_planar(model.kinematics)) return words;
    const std::string plane =
        is_deformable(model.kinematics) ? fmt::format("plane {}, ", results::name_of(model.plane)) : "";
    return fmt::format("{} ({}{:g} m thick)", words, plane, model.thickness);
}

constexpr double frequencies_of_damping[] = {0.5, 1, 2, 5, 10, 20};  // Hz

/// Damping ratios against frequency, of each material that has any and of the integrator beside them.
void print_damping(const Case& the_case)
{
    const Model& model = the_case.model;
    const auto print_row = [](const std::string& name, const auto& ratio) {
        say_part(fmt::format("  {:<28}", name));
        for (const double frequency : frequencies_of_damping)
            say_part(fmt::format(" {:>8.3g}", 100 * ratio(2 * std::numbers::pi * frequency)));
        say("");
    };
    if (std::none_of(model.materials.begin(), model.materials.end(),
                     [](const auto& m) { return m.rayleigh.any() || !m.branches.empty(); }))
        return;
    say_part("damping, % of critical, at   ");
    for (const double frequency : frequencies_of_damping) say_part(fmt::format(" {:>5g} Hz", frequency));
    say("");
    for (const BlockMaterial& material : model.materials)
        if (material.rayleigh.any() || !material.branches.empty())
            print_row(material.name, [&](double omega) {
                return 0.5 * material.rayleigh.of_mass / omega + 0.5 * material.rayleigh.of_stiffness * omega +
                       damping_ratio_of(material.branches, omega);
            });
    for (const Stage& stage : the_case.stages) {
        if (stage.type != StageType::dynamic) continue;
        if (stage.damping.rate > 0)
            print_row("damping of " + stage.name, [&](double omega) { return 0.5 * stage.damping.rate / omega; });
        print_row("integrator in " + stage.name, [&](double omega) {
            return integrator_accuracy(omega * stage.control.time_step, step::end_share(stage)).damping;
        });
    }
}

/// Metal between stones: a line for those that are alike.
void print_bars(const Model& model)
{
    const auto limit = [](double force) {
        return std::isinf(force) ? "elastic" : fmt::format("{:.4g} kN", force / 1e3);
    };
    const auto line = [&](const Bar& bar) {
        const std::string axial = bar.axial > 0
                                      ? fmt::format("tension {}, compression {}, {:.3g} N/m along it",
                                                    limit(bar.tension), limit(bar.compression), bar.axial)
                                      : "";
        const std::string shear =
            bar.lateral > 0 ? fmt::format("shear {}, {:.3g} N/m across it", limit(bar.shear), bar.lateral) : "";
        return axial + (axial.empty() || shear.empty() ? "" : "; ") + shear +
               (bar.prestress > 0 ? fmt::format("; {:.4g} kN at the start", bar.prestress / 1e3) : "");
    };
    for (std::size_t i = 0; i < model.bars.size();) {
        std::size_t end = i + 1;
        while (end < model.bars.size() && line(model.bars[end]) == line(model.bars[i])) ++end;
        const std::string others = end - i > 1 ? fmt::format(" and {} like it", end - i - 1) : "";
        print_wrapped(fmt::format("bar {}{}: {}", model.bars[i].name, others, line(model.bars[i])), "");
        i = end;
    }
}

/// Where the model ends in the ground.
void print_boundaries(const Model& model)
{
    for (const ViscousBoundary& boundary : model.boundaries)
        say(fmt::format("boundary {}: {} viscous {} of blocks {} ...; at rest {}{}", boundary.name,
                        boundary.faces.size(), boundary.faces.size() == 1 ? "face" : "faces",
                        model.blocks[boundary.faces[0].block].name, results::name_of(boundary.at_rest),
                        boundary.free_field.empty()
                            ? ""
                            : "; free field " + model.blocks[boundary.free_field[0]].name + " ..."));
    if (!model.tied_sides.empty()) say(fmt::format("tied sides: {} blocks", model.tied_sides.size()));
    if (!model.side_ties.empty())
        say(fmt::format("periodic sides: {} of faces",
                        model.side_ties.size() == 1 ? "1 pair" : fmt::format("{} pairs", model.side_ties.size())));
}

}  // namespace

void print_materials(const Model& model)
{
    for (const BlockMaterial& material : model.materials)
        say(fmt::format("material {}: density {:g} kg/m3, Young's modulus {:g} Pa, Poisson's ratio {:g}",
                        material.name, material.density, material.young, material.poisson));
    for (const JointMaterial& joint : model.joints) {
        say(fmt::format(
            "joint {}: friction {:g} deg, cohesion {:g} Pa, tensile strength {:g} Pa, contact stiffness {}, "
            "shear to normal {:g}, face {}, relaxation time {:g} s, restitution {}",
            joint.name, joint.friction_angle * 180 / std::numbers::pi, joint.cohesion, joint.tensile_strength,
            in_words(joint.stiffness), joint.shear_to_normal_stiffness, results::name_of(joint.face),
            joint.relaxation_time, joint.has_landing_law() ? fmt::format("{:g}", *joint.restitution) : "none"));
        for (const FrictionAtSpeed& point : joint.friction_at_speed)
            say(fmt::format("  friction {:g} deg when it slips at {:g} m/s", point.angle * 180 / std::numbers::pi,
                            point.speed));
    }
}

void print_repairs(const importers::helper::Geometry& geometry)
{
    std::vector<std::string> lines;
    for (const importers::helper::ImportedMesh& mesh : geometry.meshes)
        for (const std::string& repair : importers::helper::all_repairs(mesh))
            lines.push_back(fmt::format("{}: {}", mesh.file, repair));
    print_list("repairs", lines);
}

void print_case(const Case& the_case)
{
    const Model& model = the_case.model;
    double mass = 0;
    for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i) mass += model.mass(i);
    say(the_case.title);
    say(fmt::format("{} blocks, {:g} t, {}: {} unknowns per block; {} of them follow the ground",
                    model.blocks.size(), mass / 1000, in_words(model), unknowns_per_block(model.kinematics),
                    model.foundations.size()));
    print_wrapped("left out: " + joined(results::left_out(the_case)), "");
    print_bars(model);
    print_boundaries(model);
    print_damping(the_case);
    std::vector<std::string> motions;
    for (const MotionNote& note : the_case.motions)
        motions.push_back(fmt::format("{}; peak {:.3g} m/s2, residual {:.3g} m/s and {:.3g} m", note.description,
                                      note.peak_acceleration, note.residual_velocity, note.residual_displacement));
    print_list("motions", motions);
    print_list("defaults taken", the_case.defaults);
    print_list("warnings", the_case.warnings);
}

}  // namespace voussoir::app::commands
