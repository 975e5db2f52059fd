// What happened: the first line, the key results, the mechanism, the tables of stones and joints.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/report/base_shear.h"
#include "app/report/mechanism_words.h"
#include "app/report/onset.h"
#include "app/report/sections.h"
#include "app/report/uncertainty.h"
#include "libdda/model/verdict.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

std::string millimetres(double metres)
{
    return fmt::format("{:.3g}", 1e3 * metres);
}

/// "12.3 mm at 1.24 s".
std::string at(const Peak& peak, const std::string& what)
{
    return fmt::format("{} at t = {:.3g} s", what, peak.time);
}

/// The place of the largest, by what `of` gives.
template <typename List, typename Of>
std::size_t place_of_largest(const List& list, const Of& of)
{
    std::size_t best = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (of(list[i]) > of(list[best])) best = i;
    return best;
}

std::string pair_of(const RunRecord& record, std::size_t joint)
{
    const results::RecordedModel& model = record.results.model;
    return model.block_names[model.joints[joint].block_a] + " and " +
           model.block_names[model.joints[joint].block_b];
}

/// Rows of key results that concern joints.
/// Of the largest peak of a joint that is not within the soil.
std::size_t place_in_structure(const Course& course, const std::vector<Peak>& peaks)
{
    std::size_t place = 0;
    double most = -1;
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        if (course.within_ground[i] || peaks[i].value <= most) continue;
        most = peaks[i].value;
        place = i;
    }
    return place;
}

void add_joint_rows(const RunRecord& record, std::vector<std::vector<std::string>>& rows)
{
    const Course& course = record.course;
    if (course.joint_opening.empty()) return;
    const std::size_t opened = place_in_structure(course, course.joint_opening),
                      slid = place_in_structure(course, course.joint_slip),
                      pressed = place_in_structure(course, course.joint_normal_force);
    rows.push_back({"largest opening of a joint",
                    at(course.joint_opening[opened], length_in_words(course.joint_opening[opened].value)),
                    pair_of(record, opened)});
    rows.push_back({"largest slip of a joint",
                    at(course.joint_slip[slid], length_in_words(course.joint_slip[slid].value)),
                    pair_of(record, slid)});
    rows.push_back(
        {"largest thrust in a joint",
         at(course.joint_normal_force[pressed], figure(course.joint_normal_force[pressed].value / 1e3) + " kN"),
         pair_of(record, pressed)});
}

void add_stress_rows(const RunRecord& record, std::vector<std::vector<std::string>>& rows)
{
    const results::RecordedModel& model = record.results.model;
    if (!is_deformable(model.kinematics)) return;
    const std::vector<BlockCourse>& blocks = record.course.blocks;
    const std::size_t pressed = place_of_largest(blocks, [](const BlockCourse& b) { return b.compression.value; });
    const std::size_t pulled = place_of_largest(blocks, [](const BlockCourse& b) { return b.tension.value; });
    rows.push_back({"largest compressive stress (mean of a stone)",
                    at(blocks[pressed].compression, stress_in_words(blocks[pressed].compression.value)),
                    model.block_names[pressed]});
    rows.push_back({"largest tensile stress (mean of a stone)",
                    at(blocks[pulled].tension, stress_in_words(blocks[pulled].tension.value)),
                    model.block_names[pulled]});
}

Table fallen_table(const RunRecord& record)
{
    Table table{"fallen", "Stones that fell, in their order", {"stone", "time [s]", "left the scene"}, {}};
    const Json summary = Json::parse(record.summary);
    if (!summary.contains("fallen_blocks")) return table;
    for (const Json& block : summary.at("fallen_blocks"))
        table.rows.push_back({block.at("block").get<std::string>(), figure(block.at("time_s").get<double>()),
                              block.at("left").get<bool>() ? "yes" : "no"});
    return table;
}

Table lost_contact_table(const RunRecord& record)
{
    Table table{"lost_contact", "Stones that touch nothing at the end", {"stone", "since [s]"}, {}};
    const std::vector<bool> foundation = foundation_marks(record.results.model);
    for (std::size_t b = 0; b < foundation.size(); ++b)
        if (!foundation[b] && record.course.blocks[b].lost_contact >= 0)
            table.rows.push_back(
                {record.results.model.block_names[b], figure(record.course.blocks[b].lost_contact)});
    return table;
}

Table reactions_table(const RunRecord& record)
{
    Table table{"reactions",
                "What the foundations carry at the end: forces on the structure",
                {"foundation", "x [kN]", "y [kN]", "z [kN]"},
                {}};
    const results::RecordedModel& model = record.results.model;
    const std::vector<bool> foundation = foundation_marks(model);
    std::vector<Eigen::Vector3d> forces(foundation.size(), Eigen::Vector3d::Zero());
    for (const JointResultant& contact : record.results.frame(record.results.times.size() - 1).contacts) {
        if (foundation[contact.block_a] == foundation[contact.block_b]) continue;
        forces[foundation[contact.block_a] ? contact.block_a : contact.block_b] +=
            foundation[contact.block_a] ? -contact.force : contact.force;
    }
    for (const std::int32_t b : model.foundations)
        table.rows.push_back({model.block_names[b], figure(forces[b].x() / 1e3), figure(forces[b].y() / 1e3),
                              figure(forces[b].z() / 1e3)});
    return table;
}

Table groups_table(const RunRecord& record)
{
    Table table{
        "groups",
        "By group: the largest of each over the run, and what remains",
        {"group", "stones", "displacement [mm]", "at the end [mm]", "joint opening [mm]", "joint slip [mm]"},
        {}};
    for (std::size_t g = 0; g < record.groups.size(); ++g) {
        BlockCourse most;
        int stones = 0;
        for (std::size_t b = 0; b < record.course.blocks.size(); ++b) {
            if (record.block_group[b] != static_cast<std::int32_t>(g)) continue;
            const BlockCourse& block = record.course.blocks[b];
            ++stones;
            most.displacement.see(block.displacement.value, 0);
            most.residual = std::max(most.residual, block.residual);
            most.opening.see(block.opening.value, 0);
            most.slip.see(block.slip.value, 0);
        }
        if (stones > 0)
            table.rows.push_back({record.groups[g], std::to_string(stones), millimetres(most.displacement.value),
                                  millimetres(most.residual), millimetres(most.opening.value),
                                  millimetres(most.slip.value)});
    }
    return table;
}

Table stones_table(const RunRecord& record)
{
    Table table{"stones",
                "Stones, those first that moved furthest (" + results::counted_from(record.results.model) + ")",
                {"stone", "displacement [mm]", "at [s]", "at the end [mm]", "joint opening [mm]",
                 "joint slip [mm]", "compression [MPa]"},
                {}};
    const std::vector<bool> foundation = foundation_marks(record.results.model);
    std::vector<std::size_t> order(foundation.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return record.course.blocks[a].displacement.value > record.course.blocks[b].displacement.value;
    });
    const bool stressed = is_deformable(record.results.model.kinematics);
    for (const std::size_t b : order) {
        if (foundation[b]) continue;
        const BlockCourse& block = record.course.blocks[b];
        table.rows.push_back({record.results.model.block_names[b], millimetres(block.displacement.value),
                              figure(block.displacement.time), millimetres(block.residual),
                              millimetres(block.opening.value), millimetres(block.slip.value),
                              stressed ? figure(block.compression.value / 1e6) : "rigid"});
    }
    table.shown = 15;
    return table;
}

Table joints_table(const RunRecord& record)
{
    Table table{"joints",
                "Joints, those first that opened or slid most",
                {"between", "and", "opening [mm]", "at [s]", "slip [mm]", "at [s]", "opening at the end [mm]",
                 "slip at the end [mm]", "normal force at the end [kN]"},
                {}};
    const results::RecordedModel& model = record.results.model;
    const results::RecordedFrame last = record.results.frame(record.results.times.size() - 1);
    std::vector<std::size_t> order(model.joints.size());
    std::iota(order.begin(), order.end(), 0);
    const auto most = [&](std::size_t i) {
        return std::max(record.course.joint_opening[i].value, record.course.joint_slip[i].value);
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return most(a) > most(b); });
    for (const std::size_t i : order) {
        const Peak &opening = record.course.joint_opening[i], &slip = record.course.joint_slip[i];
        table.rows.push_back(
            {model.block_names[model.joints[i].block_a], model.block_names[model.joints[i].block_b],
             millimetres(opening.value), figure(opening.time), millimetres(slip.value), figure(slip.time),
             millimetres(last.joints[i].motion.opening), millimetres(last.joints[i].motion.largest_slip),
             figure(last.joints[i].normal_force / 1e3)});
    }
    table.shown = 15;
    return table;
}

void add_unless_empty(Table table, Section& section)
{
    if (!table.rows.empty()) section.tables.push_back(std::move(table));
}

}  // namespace

std::string figure(double value)
{
    // Thousands of kN are read as a number; powers of ten are for what is far from 1.
    const bool large = std::abs(value) >= 1e4 && std::abs(value) < 1e7;
    return large ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

namespace
{

/// "COLLAPSED: the structure has fallen: ..."
std::string verdict_line(const RunRecord& record)
{
    const std::string why = record.end.message.empty() ? "" : " (" + record.end.message + ")";
    if (record.failed.value_or(false)) return fmt::format("COLLAPSED: {}{}.", record.verdict, why);
    if (record.standing == name_of(Standing::moves)) return fmt::format("UNDECIDED: {}.", record.verdict);
    std::string sentence = record.verdict + ".";
    sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
    return sentence;
}

}  // namespace

std::string first_line_of(const RunRecord& record)
{
    const results::RunEnd& end = record.end;
    const std::string why = end.message.empty() ? "" : ": " + end.message;
    if (end.outcome.empty())
        return fmt::format(
            "UNFINISHED: the run was killed or is still going on; this report covers {:.3g} of {:g} s.",
            end.reached, end.planned);
    if (!record.verdict.empty()) return verdict_line(record);
    if (end.outcome == "collapsed") return "COLLAPSED" + why;
    if (end.outcome == "gave_up")
        return fmt::format("FAILED: the computation gave up at t = {:.3g} of {:g} s{}", end.reached, end.planned,
                           why);
    if (end.outcome == "undecided") return "UNDECIDED" + why;
    if (end.outcome == "interrupted")
        return fmt::format("INTERRUPTED at t = {:.3g} of {:g} s{}", end.reached, end.planned, why);
    return end.planned > 0 ? fmt::format("Completed: the run went to its end at {:g} s.", end.reached)
                           : "Completed: the structure came to rest.";
}

bool is_alarming(const RunRecord& record)
{
    return record.end.outcome != "completed" || record.standing == name_of(Standing::moves);
}

Section key_results(const RunRecord& record)
{
    Section section{"Key results", {}, {}, {}, {}, {}};
    const results::RecordedModel& model = record.results.model;
    Table table{"key_results", "The largest of each over the run", {"quantity", "value", "where"}, {}};
    const Course& course = record.course;
    const std::size_t moved =
        place_of_largest(course.blocks, [](const BlockCourse& b) { return b.displacement.value; });
    const std::size_t stays = place_of_largest(course.blocks, [](const BlockCourse& b) { return b.residual; });
    if (!course.blocks.empty()) {
        const Peak& peak = course.blocks[moved].displacement;
        table.rows.push_back({"largest displacement " + results::counted_from(model),
                              at(peak, length_in_words(peak.value)), model.block_names[moved]});
        table.rows.push_back({"largest displacement at the end", length_in_words(course.blocks[stays].residual),
                              model.block_names[stays]});
        const std::size_t settled =
            place_of_largest(course.blocks, [](const BlockCourse& b) { return b.settlement; });
        if (course.blocks[settled].settlement > 0)
            table.rows.push_back({"settlement at rest, before the motion",
                                  length_in_words(course.blocks[settled].settlement), model.block_names[settled]});
    }
    if (course.highest >= 0 && course.height > 0) {
        Peak drift;
        for (std::size_t i = 0; i < course.times.size(); ++i)
            drift.see(course.drift[i].head<2>().norm() / course.height, course.times[i]);
        table.rows.push_back({"largest drift of the highest stone", at(drift, figure(100 * drift.value) + " %"),
                              model.block_names[course.highest]});
        table.rows.push_back({"drift at the end",
                              figure(100 * course.drift.back().head<2>().norm() / course.height) + " %",
                              model.block_names[course.highest]});
    }
    add_joint_rows(record, table.rows);
    add_stress_rows(record, table.rows);
    for (const std::vector<std::string>& row : {base_shear_row(record), bar_row(record), onset_row(record)})
        if (!row.empty()) table.rows.push_back(row);
    add_uncertainty(record.summary, table);
    section.tables.push_back(table);
    add_unless_empty(fallen_table(record), section);
    add_unless_empty(lost_contact_table(record), section);
    return section;
}

Section mechanism_section(const RunRecord& record)
{
    Section section{"How it moved", {}, {}, {}, {}, {}};
    const MechanismWords words = words_of(record.mechanism, record.results.model, record.course);
    section.paragraphs.push_back(words.headline);
    if (!words.joints.empty())
        section.paragraphs.push_back(fmt::format(
            "At t = {:.3g} s, joints that moved by more than 0.1 mm and more than a tenth of what moved most:",
            record.mechanism.time));
    section.points = words.joints;
    for (const std::string& body : words.bodies) section.points.push_back(body);
    return section;
}

Section stones_and_joints(const RunRecord& record)
{
    Section section{"Stones and joints", {}, {}, {}, {}, {}};
    for (Table table : {groups_table(record), stones_table(record), joints_table(record), reactions_table(record)})
        add_unless_empty(std::move(table), section);
    return section;
}

}  // namespace voussoir::app::report
