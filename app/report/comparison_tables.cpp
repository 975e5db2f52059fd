#include "app/report/comparison_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/report/base_shear.h"
#include "app/report/sections.h"

namespace voussoir::app::report
{
namespace
{

using Row = std::vector<std::string>;

/// "quantity", A, B, B - A, B / A.
Row compared(const std::string& quantity, double a, double b)
{
    return {quantity, figure(a), figure(b), figure(b - a), std::abs(a) > 0 ? figure(b / a) : ""};
}

double largest(const std::vector<double>& list)
{
    return list.empty() ? 0 : *std::max_element(list.begin(), list.end());
}

double largest_of_blocks(const RunRecord& record, double (*of)(const BlockCourse&))
{
    double most = 0;
    for (const BlockCourse& block : record.course.blocks) most = std::max(most, of(block));
    return most;
}

/// Of the height, at every stored moment or at the last one.
double drift(const RunRecord& record, bool at_the_end)
{
    double most = 0;
    if (!(record.course.height > 0)) return 0;
    for (const Eigen::Vector3d& moved : record.course.drift) {
        const double now = moved.head<2>().norm() / record.course.height;
        most = at_the_end ? now : std::max(most, now);
    }
    return most;
}

double largest_base_shear(const RunRecord& record)
{
    double most = 0;
    for (const Eigen::Vector3d& force : record.course.base_force) most = std::max(most, force.head<2>().norm());
    return most;
}

double largest_thrust(const Course& course)
{
    double most = 0;
    for (std::size_t i = 0; i < course.within_ground.size(); ++i)
        if (!course.within_ground[i]) most = std::max(most, course.joint_normal_force[i].value);
    return most;
}

double without_contact(const RunRecord& record)
{
    return static_cast<double>(std::count_if(record.course.blocks.begin(), record.course.blocks.end(),
                                             [](const BlockCourse& block) { return block.lost_contact >= 0; }));
}

std::map<std::string, std::size_t> stones_by_name(const RunRecord& record)
{
    std::map<std::string, std::size_t> places;
    for (std::size_t b = 0; b < record.results.model.block_names.size(); ++b)
        places.emplace(record.results.model.block_names[b], b);
    return places;
}

std::map<std::pair<std::string, std::string>, std::size_t> joints_by_name(const RunRecord& record)
{
    std::map<std::pair<std::string, std::string>, std::size_t> places;
    const results::RecordedModel& model = record.results.model;
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
        const auto names = std::minmax(model.block_names[static_cast<std::size_t>(model.joints[i].block_a)],
                                       model.block_names[static_cast<std::size_t>(model.joints[i].block_b)]);
        places.emplace(names, i);
    }
    return places;
}

/// Rows in falling order of how far they differ.
struct Differing {
    std::vector<std::pair<double, Row>> rows;
    std::size_t only_a = 0, only_b = 0;

    void sort_into(Table& table)
    {
        std::stable_sort(rows.begin(), rows.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
        for (auto& [by, row] : rows) table.rows.push_back(std::move(row));
        table.shown = 15;
    }
};

/// What both maps have, by `row_of(key, place in A, place in B)`.
template <typename Places, typename RowOf>
Differing differing(const Places& a, const Places& b, const RowOf& row_of)
{
    Differing result;
    for (const auto& [key, place] : a) {
        const auto other = b.find(key);
        if (other == b.end())
            ++result.only_a;
        else
            result.rows.push_back(row_of(key, place, other->second));
    }
    result.only_b = b.size() - result.rows.size();
    return result;
}

std::string millimetres(double metres)
{
    return fmt::format("{:.3g}", 1e3 * metres);
}

Differing stones_of(const RunRecord& a, const RunRecord& b)
{
    return differing(stones_by_name(a), stones_by_name(b),
                     [&](const std::string& name, std::size_t in_a, std::size_t in_b) {
                         const BlockCourse &one = a.course.blocks[in_a], &other = b.course.blocks[in_b];
                         return std::pair<double, Row>{
                             std::abs(one.displacement.value - other.displacement.value),
                             {name, millimetres(one.displacement.value), millimetres(other.displacement.value),
                              millimetres(other.displacement.value - one.displacement.value),
                              millimetres(one.residual), millimetres(other.residual)}};
                     });
}

Differing joints_of(const RunRecord& a, const RunRecord& b)
{
    return differing(
        joints_by_name(a), joints_by_name(b),
        [&](const std::pair<std::string, std::string>& names, std::size_t in_a, std::size_t in_b) {
            const double open_a = a.course.joint_opening[in_a].value, open_b = b.course.joint_opening[in_b].value,
                         slip_a = a.course.joint_slip[in_a].value, slip_b = b.course.joint_slip[in_b].value;
            return std::pair<double, Row>{std::max(std::abs(open_a - open_b), std::abs(slip_a - slip_b)),
                                          {names.first, names.second, millimetres(open_a), millimetres(open_b),
                                           millimetres(slip_a), millimetres(slip_b)}};
        });
}

}  // namespace

Section key_figures_compared(const RunRecord& a, const RunRecord& b)
{
    Table table{"key_figures", "The largest of each over the run", {"quantity", "A", "B", "B - A", "B / A"}, {}};
    const auto add = [&](const std::string& quantity, const auto& of) {
        table.rows.push_back(compared(quantity, of(a), of(b)));
    };
    add("time computed [s]", [](const RunRecord& r) { return r.end.reached; });
    add("largest displacement " + results::counted_from(a.results.model) + " [mm]",
        [](const RunRecord& r) { return 1e3 * largest(r.course.displacement); });
    add("displacement at the end [mm]", [](const RunRecord& r) {
        return 1e3 * largest_of_blocks(r, [](const BlockCourse& block) { return block.residual; });
    });
    add("drift of the highest stone [%]", [](const RunRecord& r) { return 100 * drift(r, false); });
    add("drift at the end [%]", [](const RunRecord& r) { return 100 * drift(r, true); });
    add("joint opening [mm]", [](const RunRecord& r) { return 1e3 * largest(r.course.opening); });
    add("joint slip [mm]", [](const RunRecord& r) { return 1e3 * largest(r.course.slip); });
    add("joints that opened by more than 0.1 mm",
        [](const RunRecord& r) { return static_cast<double>(r.course.joints_opened); });
    add("joints that slid by more than 0.1 mm",
        [](const RunRecord& r) { return static_cast<double>(r.course.joints_slid); });
    add("thrust in a joint [kN]", [](const RunRecord& r) { return largest_thrust(r.course) / 1e3; });
    add("base shear [kN]", [](const RunRecord& r) { return largest_base_shear(r) / 1e3; });
    if (base_shear_of(a) && base_shear_of(b))
        add("base shear over weight", [](const RunRecord& r) { return base_shear_of(r)->value; });
    add("stones that touch nothing at the end", without_contact);
    if (is_deformable(a.results.model.kinematics) && is_deformable(b.results.model.kinematics))
        add("compressive stress, mean of a stone [MPa]", [](const RunRecord& r) {
            return largest_of_blocks(r, [](const BlockCourse& block) { return block.compression.value; }) / 1e6;
        });
    Section section{"Key figures", {}, {}, {}, {}, {}};
    section.tables.push_back(std::move(table));
    return section;
}

Section stones_compared(const RunRecord& a, const RunRecord& b)
{
    Section section{"Stones and joints", {}, {}, {}, {}, {}};
    Differing stones = stones_of(a, b), joints = joints_of(a, b);
    section.paragraphs.push_back(fmt::format(
        "Of the stones, {} are in both, {} only in A, {} only in B; of the joints {}, {} and {}.",
        stones.rows.size(), stones.only_a, stones.only_b, joints.rows.size(), joints.only_a, joints.only_b));
    Table by_stone{"stones",
                   "Stones, those first whose largest displacements differ most",
                   {"stone", "A [mm]", "B [mm]", "B - A [mm]", "A at the end [mm]", "B at the end [mm]"},
                   {}};
    Table by_joint{"joints",
                   "Joints, those first that differ most",
                   {"between", "and", "opening A [mm]", "opening B [mm]", "slip A [mm]", "slip B [mm]"},
                   {}};
    stones.sort_into(by_stone);
    joints.sort_into(by_joint);
    for (Table* table : {&by_stone, &by_joint})
        if (!table->rows.empty()) section.tables.push_back(std::move(*table));
    return section;
}

Section computations_compared(const RunRecord& a, const RunRecord& b)
{
    Table table{"computation", "The computation", {"quantity", "A", "B", "B - A", "B / A"}, {}};
    const nlohmann::json one = nlohmann::json::parse(a.summary), other = nlohmann::json::parse(b.summary);
    for (const char* name : {"blocks", "steps", "step_cuts", "unconverged_steps", "open_close_iterations",
                             "factorisations", "max_penetration_m", "cpu_time_s", "wall_time_s"})
        if (one.contains(name) && other.contains(name) && one.at(name).is_number() && other.at(name).is_number())
            table.rows.push_back(compared(name, one.at(name).get<double>(), other.at(name).get<double>()));
    if (one.contains("energy") && other.contains("energy"))
        for (const auto& [name, value] : one.at("energy").items())
            if (value.is_number() && other.at("energy").contains(name) &&
                other.at("energy").at(name).is_number() && (value != 0.0 || other.at("energy").at(name) != 0.0))
                table.rows.push_back(
                    compared("energy: " + name, value.get<double>(), other.at("energy").at(name).get<double>()));
    table.shown = 40;
    Section section{"How well they were computed", {}, {}, {}, {}, {}};
    if (!table.rows.empty()) section.tables.push_back(std::move(table));
    return section;
}

}  // namespace voussoir::app::report
