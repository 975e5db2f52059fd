// What was analysed, how well, and how it can be done again.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <string_view>
#include <utility>

#include "app/report/energy_table.h"
#include "app/report/geometry_table.h"
#include "app/report/sections.h"
#include "records/measures/measures.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

std::string text_of(const Json& value)
{
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_integer()) return value.dump();
    if (value.is_number()) return figure(value.get<double>());
    return value.is_null() ? "none" : value.dump();
}

Table materials_table(const RunRecord& record)
{
    Table table{"materials",
                "Stone",
                {"material", "density [kg/m3]", "Young's modulus [GPa]", "Poisson's ratio", "damping"},
                {}};
    for (const RecordedMaterial& material : record.materials)
        table.rows.push_back({material.name, figure(material.density), figure(material.young / 1e9),
                              figure(material.poisson), material.damping});
    return table;
}

Table joint_materials_table(const RunRecord& record)
{
    Table table{"joint_materials",
                "Joints",
                {"joint", "friction [deg]", "cohesion [kPa]", "tensile strength [kPa]", "normal stiffness", "face",
                 "dashpots, relaxation time [ms]"},
                {}};
    for (const RecordedJointMaterial& joint : record.joint_materials)
        table.rows.push_back({joint.name, figure(joint.friction_angle * 180 / std::numbers::pi),
                              figure(joint.cohesion / 1e3), figure(joint.tensile_strength / 1e3),
                              joint.stiffness.empty() ? "not stored" : joint.stiffness,
                              joint.face.empty() ? "not stored" : joint.face,
                              joint.relaxation_time > 0 ? figure(1e3 * joint.relaxation_time) : "none"});
    return table;
}

/// "energy_decaying, dissipation 0.02".
std::string integrator_of(const Json& control)
{
    const std::string name = control.value("integrator", std::string("not stored"));
    return name == "energy_decaying" ? fmt::format("{}, dissipation {:g}", name, control.value("dissipation", 0.0))
                                     : name;
}

/// Of the velocities, by the stage.
std::string damping_of(const Json& stage)
{
    const double rate = stage.value("damping_rate_1_s", 0.0), factor = stage.value("damping_factor_per_step", 1.0);
    if (rate > 0) return fmt::format("{:g} 1/s", rate);
    return factor < 1 ? fmt::format("x {:g} a step", factor) : "none";
}

/// ", 2 from 1.2 s on": where the steps of a stage became shorter.
std::string shorter_steps_of(const std::string& stage, const Json& summary)
{
    std::string told;
    for (const Json& shorter : summary.value("shorter_steps", Json::array()))
        if (shorter.value("stage", "") == stage)
            told += fmt::format(", {} from {} s on", figure(1e3 * shorter.value("time_step_s", 0.0)),
                                figure(shorter.value("time_s", 0.0)));
    return told;
}

/// Steps of a static stage are a way to rest, no time.
Table stages_table(const RunRecord& record, const Json& summary)
{
    Table table{"stages",
                "Stages",
                {"stage", "type", "duration [s]", "time step [ms]", "integrator", "damping of velocities"},
                {}};
    for (const Json& stage : Json::parse(record.settings)) {
        const bool is_dynamic = stage.contains("duration_s");
        const Json control = stage.value("control", Json::object());
        const double step_error = control.value("step_error_m", 0.0);
        std::string step = is_dynamic ? figure(1e3 * control.value("time_step_s", 0.0)) : "to rest";
        if (is_dynamic && step_error > 0)
            step = fmt::format("at most {}, step error {:g} mm", step, 1e3 * step_error);
        if (control.value("automatic_time_step", false))
            step = fmt::format("auto: {}{}", step, shorter_steps_of(stage.at("name").get<std::string>(), summary));
        table.rows.push_back({text_of(stage.at("name")), text_of(stage.at("type")),
                              is_dynamic ? figure(stage.at("duration_s").get<double>()) : "to rest", step,
                              is_dynamic ? integrator_of(control) : "none", damping_of(stage)});
    }
    return table;
}

/// FNV-1a over bytes, sixteen digits.
std::string checksum(std::string_view bytes)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return fmt::format("{:016x}", hash);
}

Table costs_table(const Json& summary)
{
    Table table{"computation", "The computation", {"quantity", "value"}, {}};
    const std::vector<std::pair<const char*, const char*>> figures = {
        {"steps", "steps"},
        {"step_cuts", "steps that were cut"},
        {"unconverged_steps", "steps that did not converge"},
        {"open_close_iterations", "open-close iterations"},
        {"factorisations", "factorisations"},
        {"max_penetration_m", "largest penetration [m]"},
        {"static_unbalanced", "unbalanced share of forces, static"},
        {"simulated_time_s", "simulated time [s]"},
        {"wall_time_s", "wall time [s]"},
        {"cpu_time_s", "CPU time [s]"},
    };
    for (const auto& [key, words] : figures)
        if (summary.contains(key)) table.rows.push_back({words, text_of(summary.at(key))});
    return table;
}

/// A share as a percentage of one decimal.
std::string percent(const Json& share)
{
    return share.is_number() ? fmt::format("{:.1f}", 100 * share.get<double>()) : text_of(share);
}

Table modes_table(const Json& summary)
{
    Table table{"modes", "Natural modes found", {"frequency [Hz]"}, {}};
    if (!summary.contains("trust") || !summary.at("trust").contains("modes")) return table;
    for (const char* axis : {"x", "y", "z"}) table.columns.push_back(fmt::format("mass along {} [%]", axis));
    for (const Json& mode : summary.at("trust").at("modes")) {
        table.rows.push_back({text_of(mode.at("frequency_Hz"))});
        for (const Json& share : mode.at("mass_fraction")) table.rows.back().push_back(percent(share));
        table.rows.back().resize(table.columns.size());
    }
    return table;
}

Table damping_table(const Json& summary)
{
    Table table{"damping",
                "What the integrator and the dashpots damp, fractions of critical",
                {"frequency [Hz]", "algorithmic", "dashpots", "asked for", "period error"},
                {}};
    if (!summary.contains("trust") || !summary.at("trust").contains("damping")) return table;
    for (const Json& mode : summary.at("trust").at("damping"))
        table.rows.push_back({text_of(mode.at("frequency_Hz")), text_of(mode.at("algorithmic_damping")),
                              text_of(mode.at("damping_by_dashpots")), text_of(mode.at("damping_asked_for")),
                              text_of(mode.at("period_error"))});
    return table;
}

Table estimate_table(const Json& summary)
{
    Table table{"error_estimate",
                "Differences with half the time step and with twice the stiffness",
                {"quantity", "largest", "half the step", "twice the stiffness"},
                {}};
    if (!summary.contains("error_estimate") || !summary.at("error_estimate").contains("quantities")) return table;
    const auto share = [](const Json& quantity, const char* key) {
        if (!quantity.contains(key)) return std::string("not run");
        const Json& relative = quantity.at(key).at("relative");
        return relative.is_number() ? figure(100 * relative.get<double>()) + " %" : "none";
    };
    for (const Json& quantity : summary.at("error_estimate").at("quantities"))
        table.rows.push_back({text_of(quantity.at("name")) + " [" + text_of(quantity.at("unit")) + "]",
                              text_of(quantity.at("largest")), share(quantity, "half_step"),
                              share(quantity, "twice_stiffness")});
    return table;
}

records::Channel channel_of(const results::RecordedMotion& motion)
{
    records::Channel channel;
    channel.time_step = motion.times.size() > 1 ? motion.times[1] - motion.times[0] : 0;
    channel.samples = motion.acceleration;
    channel.unit_in_file = "m/s2";
    return channel;
}

}  // namespace

Section what_was_analysed(const RunRecord& record)
{
    Section section{"What was analysed", {}, {}, {}, {}, {}};
    const results::RecordedModel& model = record.results.model;
    const double mass = std::accumulate(record.mass.begin(), record.mass.end(), 0.0);
    std::string kinematics = std::string(voussoir::name_of(model.kinematics));
    section.paragraphs.push_back(fmt::format(
        "{} blocks ({} of them foundations) of {:.4g} t in all, with {} joints between faces that touch at the "
        "start; "
        "kinematics: {}.",
        model.block_names.size(), model.foundations.size(), mass / 1e3, model.joints.size(), kinematics));
    section.tables = {geometry_table(record), materials_table(record), joint_materials_table(record),
                      stages_table(record, Json::parse(record.summary))};
    return section;
}

Section motion_section(const RunRecord& record)
{
    Section section{"Ground motion", {}, {}, {}, {}, {}};
    Table table{"motions",
                "Measures of the motions as applied",
                {"stage", "component", "source", "PGA [m/s2]", "PGV [m/s]", "PGD [m]", "Arias [m/s]",
                 "duration 5-95 % [s]", "left over [mm]"},
                {}};
    for (const results::RecordedMotion& motion : record.motions) {
        if (motion.times.size() < 2) continue;
        const records::measures::Measures measures = records::measures::measures_of(channel_of(motion));
        const std::string follower = motion.followers.empty() ? "?" : motion.followers.front();
        table.rows.push_back({motion.stage, follower.substr(follower.rfind(' ') + 1), motion.source,
                              figure(motion.peak_acceleration), figure(measures.peak_velocity),
                              figure(measures.peak_displacement), figure(measures.arias_intensity),
                              figure(measures.duration_5_95), figure(1e3 * motion.residual_displacement)});
    }
    if (table.rows.empty()) return section;
    section.tables.push_back(table);
    if (!record.motion_descriptions.empty())
        section.paragraphs.emplace_back("What they are, and what was done to them before they were applied:");
    section.points = record.motion_descriptions;
    return section;
}

Section how_well_computed(const RunRecord& record)
{
    Section section{"How well it was computed", {}, {}, {}, {}, {}};
    const Json summary = Json::parse(record.summary);
    if (summary.empty()) {
        section.paragraphs.emplace_back(
            "The run has not ended, so nothing is known of its energy balance, its error and its cost.");
        return section;
    }
    if (summary.contains("energy"))
        section.paragraphs.push_back(fmt::format(
            "Energy that no term accounts for: {} of what was put in, stored or lost. Largest penetration: {} m.",
            figure(summary.at("energy").value("residual", 0.0)), figure(summary.value("max_penetration_m", 0.0))));
    if (std::string words = energy_in_words(record.summary); !words.empty())
        section.paragraphs.push_back(std::move(words));
    if (!summary.contains("error_estimate"))
        section.paragraphs.emplace_back(
            "No error estimate was asked for (output: {error_estimate: true}); how far the figures depend on the "
            "time step "
            "and on the contact stiffness is not known from this run alone.");
    section.tables = {costs_table(summary), energy_table(record.summary), modes_table(summary),
                      damping_table(summary), estimate_table(summary)};
    std::erase_if(section.tables, [](const Table& table) { return table.rows.empty(); });
    for (Table& table : section.tables) table.shown = 40;
    return section;
}

Section assumptions(const RunRecord& record)
{
    Section section{"Assumptions and warnings", {}, {}, {}, {}, {}};
    section.paragraphs.push_back(record.warnings.empty() ? "There are no warnings."
                                                         : "Warnings, and repairs of the geometry:");
    section.points = record.warnings;
    const auto list = [&section](const char* name, const char* title, const std::vector<std::string>& texts) {
        Table table{name, title, {"what"}, {}};
        for (const std::string& text : texts) table.rows.push_back({text});
        if (!table.rows.empty()) section.tables.push_back(table);
    };
    list("defaults", "Defaults that were taken", record.defaults);
    list("left_out", "Left out: the case does not ask for it", record.left_out);
    return section;
}

Section how_to_reproduce(const RunRecord& record)
{
    Section section{"How to reproduce it", {}, {}, {}, {}, {}};
    std::string command = "voussoir run " + record.case_file;
    for (const std::string& setting : record.overrides) command += " --set '" + setting + "'";
    section.paragraphs = {
        "Made by " + record.engine + ".", "Command: " + command,
        "Checksum (FNV-1a) of the case file's text: " + checksum(record.case_text) +
            ". The same engine, case and records give the same bits. The case file ends this section."};
    section.verbatim = record.case_text;
    for (const results::RecordedMotion& motion : record.motions)
        section.points.push_back(fmt::format("Checksum of the accelerations of {} ({}) as applied: {}",
                                             motion.followers.empty() ? "the ground" : motion.followers.front(),
                                             motion.source,
                                             checksum({reinterpret_cast<const char*>(motion.acceleration.data()),
                                                       motion.acceleration.size() * sizeof(double)})));
    return section;
}

}  // namespace voussoir::app::report
