#include "app/results/summary.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/results/energy_terms.h"
#include "app/results/joint_summary.h"
#include "app/results/results_writer.h"
#include "app/results/settings.h"
#include "app/results/trust_json.h"
#include "app/results/verdict_json.h"
#include "app/version/version.h"
#include "app/words/diagnosis_words.h"
#include "app/words/doubts.h"
#include "libdda/analysis/bar_forces.h"
#include "libdda/analysis/crushing.h"

namespace voussoir::app::results
{

namespace
{

using Json = nlohmann::ordered_json;

Json energy(const EnergyLedger& ledger)
{
    Json json;
    for (const auto& [name, value] : energy_terms(ledger)) json[name] = value;
    json["residual"] = ledger.relative_residual();
    return json;
}

Json fallen_blocks(const Model& model, const std::vector<FallenBlock>& fallen)
{
    Json json = Json::array();
    for (const FallenBlock& block : fallen)
        json.push_back({{"block", model.blocks[block.block].name}, {"time_s", block.time}, {"left", block.left}});
    return json;
}

Json crushed_joints(const Model& model, const std::vector<CrushedJoint>& crushed)
{
    Json json = Json::array();
    for (const CrushedJoint& joint : crushed) {
        json.push_back({{"blocks", {model.blocks[joint.block_a].name, model.blocks[joint.block_b].name}},
                        {"compressive_strength_Pa", joint.strength},
                        {"first_time_s", joint.first_time},
                        {"worst_time_s", joint.worst_time},
                        {"worst_edge_stress_Pa", joint.worst_stress},
                        {"duration_s", joint.duration},
                        {"longest_s", joint.longest},
                        {"at_rest", joint.at_rest},
                        {"lasting", is_lasting(joint)}});
    }
    return json;
}

Json bars(const Model& model, const State& state, const RunReport& report)
{
    Json json = Json::array();
    const std::vector<BarNow> now = bars_now(model, state);
    for (std::size_t i = 0; i < now.size(); ++i) {
        const BarPeaks peaks = i < report.bars.size() ? report.bars[i] : BarPeaks{};
        json.push_back(
            {{"name", model.bars[i].name},
             {"blocks", {model.blocks[model.bars[i].block_a].name, model.blocks[model.bars[i].block_b].name}},
             {"tension_N", now[i].axial},
             {"shear_N", now[i].shear},
             {"elongation_m", now[i].elongation},
             {"yielded_m", now[i].yielded},
             {"largest_tension_N", peaks.tension},
             {"largest_compression_N", peaks.compression},
             {"largest_shear_N", peaks.shear},
             {"yielded_time_s", peaks.yielded ? Json(*peaks.yielded) : Json(nullptr)},
             {"out_time_s", peaks.out ? Json(*peaks.out) : Json(nullptr)}});
    }
    return json;
}

Json deepest_overlap(const Model& model, const DeepestOverlap& overlap)
{
    if (overlap.block_a < 0) return nullptr;
    return {{"blocks", {model.blocks[overlap.block_a].name, model.blocks[overlap.block_b].name}},
            {"depth_m", overlap.depth},
            {"forgiven_m", overlap.forgiven},
            {"drawn_m", overlap.drawn},
            {"fraction_of_width", overlap.share},
            {"share_of_width", overlap.share},  // its former name, for one release
            {"time_s", overlap.time}};
}

Json time_by_part(const RunReport& report)
{
    Json json;
    for (int part = 0; part < static_cast<int>(Part::count); ++part) {
        json[std::string(name_of(static_cast<Part>(part)))] = report.seconds[part];
    }
    return json;
}

Json motions(const std::vector<MotionNote>& notes)
{
    Json json = Json::array();
    for (const MotionNote& note : notes) {
        json.push_back({{"description", note.description},
                        {"peak_acceleration_m_s2", note.peak_acceleration},
                        {"residual_velocity_m_s", note.residual_velocity},
                        {"residual_displacement_m", note.residual_displacement}});
    }
    return json;
}

Json integrators(const std::vector<Stage>& stages)
{
    Json json = Json::array();
    for (const Stage& stage : stages) {
        Json entry = {{"stage", stage.name},
                      {"type", name_of(stage.type)},
                      {"integrator", name_of(stage.control.integrator)},
                      {"time_step_s", stage.control.time_step},
                      {"automatic_time_step", stage.control.automatic}};
        if (stage.control.integrator == Integrator::energy_decaying) {
            entry["dissipation"] = stage.control.dissipation_used();
        }
        json.push_back(entry);
    }
    return json;
}

/// What the places and velocities of one block take; contacts come on top, as many as there are.
double state_bytes_per_block(const State& state, std::size_t blocks)
{
    if (blocks == 0) return 0;
    const std::size_t numbers = state.coordinates.size() + state.velocities.size();
    return static_cast<double>(numbers * sizeof(double)) / static_cast<double>(blocks);
}

/// Puts the joints where the text has the one list of that name, still empty. (A quotation mark within a text
/// would have a backslash before it.)
std::string with_list(std::string text, const std::string& lines)
{
    const std::string empty = "\"list\": []";
    if (!lines.empty()) text.replace(text.find(empty), empty.size(), "\"list\": [" + lines + "\n    ]");
    return text;
}

}  // namespace

std::string summary_json(const Case& the_case, const std::vector<WatchedJoint>& joints, const State& state,
                         const RunReport& report, const RunQuality& quality, const CommandTimes& times,
                         const std::vector<std::string>& files)
{
    const Model& model = the_case.model;
    std::vector<std::string> warnings = the_case.warnings;
    for (std::string& doubt : words::doubts_of(report, quality.trust, model, the_case.stages))
        warnings.push_back(std::move(doubt));
    if (quality.estimate)
        for (std::string& doubt : doubts_of(*quality.estimate, report.outcome))
            warnings.push_back(std::move(doubt));
    Json json;
    json["case"] = the_case.file.string();
    json["title"] = the_case.title;
    json["voussoir_version"] = version::engine_version().version;
    json["engine"] = Json::parse(version::engine_json());
    json["outcome"] = name_of(report.outcome);
    json["message"] = words::message_of(report, model, the_case.stages);
    json["kinematics"] = name_of(model.kinematics);
    if (is_planar(model.kinematics)) json["thickness_m"] = model.thickness;
    if (model.kinematics == Kinematics::planar_deformable) json["plane"] = name_of(model.plane);
    json["blocks"] = model.blocks.size();
    json["unknowns_per_block"] = unknowns_per_block(model.kinematics);
    json["state_bytes_per_block"] = state_bytes_per_block(state, model.blocks.size());
    json["factor_entries"] = report.factor_entries;
    json["fit_tolerance_m"] = model.fit_tolerance;
    json["contacts"] = state.contacts.patches.size() + state.planar_contacts.patches.size();
    json["integrator"] = integrators(the_case.stages);
    json["steps"] = report.steps;
    json["step_cuts"] = report.step_cuts;
    if (report.refused_steps > 0) json["refused_steps"] = report.refused_steps;
    for (const ShorterSteps& shorter : report.shorter_steps)
        json["shorter_steps"].push_back({{"stage", the_case.stages[shorter.stage].name},
                                         {"time_s", shorter.time},
                                         {"time_step_s", shorter.time_step}});
    json["unconverged_steps"] = report.unconverged_steps;
    json["open_close_iterations"] = report.open_close_iterations;
    json["iteration_acted"] = {{"stones_relaxed", report.acted.relaxed},
                               {"whole_tangents", report.acted.whole_tangents},
                               {"shortened_directions", report.acted.shortened}};
    json["blows"] = {{"solved", report.blows.solved}, {"unfinished", report.blows.unfinished}};
    json["factorisations"] = report.factorisations;
    json["linear_iterations"] = report.linear_iterations;
    json["simulated_time_s"] = report.simulated_time;
    json["wall_time_s"] = times.wall;
    json["cpu_time_s"] = times.cpu;
    json["time_by_part"] = time_by_part(report);
    json["max_penetration_m"] = report.max_penetration;
    json["deepest_overlap"] = deepest_overlap(model, report.deepest);
    json["static_unbalanced"] = report.static_unbalanced;
    json["energy"] = energy(report.energy);
    if (quality.trust) json["trust"] = Json::parse(trust_json(*quality.trust, the_case.stages));
    if (quality.estimate) json["error_estimate"] = Json::parse(estimate_json(*quality.estimate));
    if (report.verdict) json["verdict"] = Json::parse(verdict_json(*report.verdict, model));
    json["fallen_blocks"] = fallen_blocks(model, report.fallen);
    if (has_compressive_strength(model)) json["crushed_joints"] = crushed_joints(model, report.crushed);
    const std::vector<JointNow> now = joints_now(model, joints, state, joint_resultants(model, state));
    json["joints"] = Json::parse(joint_counts(report.joints, now));
    if (!model.bars.empty()) json["bars"] = bars(model, state, report);
    json["motions"] = motions(the_case.motions);
    json["overrides"] = the_case.overrides;
    json["defaults"] = the_case.defaults;
    json["left_out"] = left_out(the_case);
    json["warnings"] = warnings;
    json["files"] = files;
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    return with_list(text, joint_lines(model, joints, report.joints, now));
}

}  // namespace voussoir::app::results
