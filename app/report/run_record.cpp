#include "app/report/run_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "libdda/errors.h"
#include "libdda/model/verdict.h"

namespace voussoir::app::report
{
namespace
{

using results::Hdf5File;

Columns columns_of(const Hdf5File& file, const std::string& name)
{
    if (!file.has(name)) return {};
    return {file.texts_attribute(name, "columns"), file.read<double>(name)};
}

/// The list, or none in a file of an earlier version.
template <typename T>
std::vector<T> values(const Hdf5File& file, const std::string& name, std::size_t count)
{
    std::vector<T> list = file.read<T>(name);
    list.resize(count);
    return list;
}

void read_case(const Hdf5File& file, RunRecord& record)
{
    record.case_file = file.read_text("/case/file");
    record.case_text = file.read_text("/case/text");
    record.settings = file.read_text("/case/settings");
    record.overrides = file.read_texts("/case/overrides");
    record.defaults = file.read_texts("/case/defaults");
    record.warnings = file.read_texts("/case/warnings");
    record.left_out = file.read_texts("/case/left_out");
    record.engine = "voussoir " + file.text_attribute("/", "voussoir_version") + ", commit " +
                    file.text_attribute("/", "engine_commit") +
                    " (changed since: " + file.text_attribute("/", "engine_dirty") + "), sources " +
                    file.text_attribute("/", "engine_sources") + ", " +
                    file.text_attribute("/", "engine_compilation");
}

/// "Rayleigh, 0.5 1/s and 1e-05 s", "hysteretic".
void read_damping(const Hdf5File& file, RunRecord& record)
{
    if (file.has("/model/materials/rayleigh")) {
        const auto rows = file.read<double>("/model/materials/rayleigh");
        for (std::size_t i = 0; i < std::min(record.materials.size(), rows.size() / 2); ++i)
            if (rows[2 * i] > 0 || rows[2 * i + 1] > 0)
                record.materials[i].damping =
                    fmt::format("Rayleigh, {:g} 1/s and {:g} s", rows[2 * i], rows[2 * i + 1]);
    }
    if (!file.has("/model/materials/branches")) return;
    const auto rows = file.read<double>("/model/materials/branches");  // material, share, time
    for (std::size_t i = 0; i < rows.size(); i += 3)
        if (rows[i] >= 0 && rows[i] < static_cast<double>(record.materials.size()))
            record.materials[static_cast<std::size_t>(rows[i])].damping = "hysteretic";
}

/// "10 E/L", "2e+09 Pa/m", "1e+08 N/m a point", each times a factor where there is one.
std::string stiffness_in_words(const std::string& kind, double value, double factor)
{
    const std::string times = factor == 1 ? "" : fmt::format(" x {:g}", factor);
    if (kind == "per_area_Pa_m") return fmt::format("{:g} Pa/m{}", value, times);
    if (kind == "per_point_N_m") return fmt::format("{:g} N/m a point{}", value, times);
    return value > 0 ? fmt::format("{:g} E/L{}", value, times) : "by the rule" + times;
}

void read_stiffness(const Hdf5File& file, RunRecord& record)
{
    const std::string of = "/model/joint_materials/";
    const std::size_t count = record.joint_materials.size();
    if (!file.has(of + "stiffness_kind") || !file.has(of + "face")) return;
    std::vector<std::string> kinds = file.read_texts(of + "stiffness_kind"), faces = file.read_texts(of + "face");
    kinds.resize(count);
    faces.resize(count);
    const auto value = values<double>(file, of + "stiffness", count),
               factor = values<double>(file, of + "stiffness_factor", count),
               dashpot = values<double>(file, of + "dashpot", count);
    for (std::size_t i = 0; i < count; ++i) {
        record.joint_materials[i].stiffness = stiffness_in_words(kinds[i], value[i], factor[i]);
        record.joint_materials[i].face = faces[i];
        record.joint_materials[i].relaxation_time = dashpot[i];
    }
}

void read_materials(const Hdf5File& file, RunRecord& record)
{
    const std::vector<std::string> names = file.read_texts("/model/materials/name");
    const auto of = [&](const std::string& group, const char* what, std::size_t count) {
        return values<double>(file, group + what, count);
    };
    const std::string stones = "/model/materials/", joints = "/model/joint_materials/";
    const std::vector<double> density = of(stones, "density", names.size()),
                              young = of(stones, "young", names.size()),
                              poisson = of(stones, "poisson", names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        record.materials.push_back({names[i], density[i], young[i], poisson[i], "none"});
    const std::vector<std::string> kinds = file.read_texts(joints + "name");
    const std::vector<double> angle = of(joints, "friction_angle", kinds.size()),
                              cohesion = of(joints, "cohesion", kinds.size()),
                              tension = of(joints, "tensile_strength", kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i)
        record.joint_materials.push_back({kinds[i], angle[i], cohesion[i], tension[i], "", "", 0});
    read_damping(file, record);
    read_stiffness(file, record);
}

/// A summary lists the warnings of the case, which are those that were known at the start, and then what the run
/// found. A remark about the engine may have come in between.
void read_warnings(const std::vector<std::string>& all, RunRecord& record)
{
    std::vector<std::string> of_case = std::exchange(record.warnings, all);
    for (const std::string& warning : all) {
        const auto known = std::find(of_case.begin(), of_case.end(), warning);
        if (known == of_case.end())
            record.doubts.push_back(warning);
        else
            of_case.erase(known);
    }
}

/// The summary in the file tells more than what was known at the start; it is in a file of its own as well.
void read_summary(const Hdf5File& file, RunRecord& record)
{
    record.summary = file.has("/summary") ? file.read_text("/summary") : "{}";
    try {
        const nlohmann::json summary = nlohmann::json::parse(record.summary);
        if (summary.contains("warnings"))
            read_warnings(summary.at("warnings").get<std::vector<std::string>>(), record);
        const bool fell = summary.contains("fallen_blocks") && !summary.at("fallen_blocks").empty();
        const bool mechanism =
            record.end.outcome == "gave_up" && record.end.message.find("mechanism") != std::string::npos;
        if (record.end.outcome == "collapsed" || mechanism || (fell && record.end.outcome != "completed"))
            record.failed = true;
        if (!summary.contains("verdict")) return;
        record.standing = summary.at("verdict").at("standing").get<std::string>();
        record.verdict = summary.at("verdict").at("in_words").get<std::string>();
        if (record.standing != name_of(Standing::moves))
            record.failed = record.standing != name_of(Standing::stands);
    } catch (const nlohmann::json::exception&) {
        throw InputError(record.file.string(), "a summary that cannot be read",
                         "the file is damaged: run the case again");
    }
}

/// The run saw joints open between its frames too: what its summary counts is what the console said.
void take_joint_counts(const std::string& summary, Course& course)
{
    const nlohmann::json json = nlohmann::json::parse(summary);
    if (!json.contains("joints")) return;
    course.joints_opened = json.at("joints").value("opened", course.joints_opened);
    course.joints_slid = json.at("joints").value("slid", course.joints_slid);
}

}  // namespace

std::vector<double> Columns::column(const std::string& name) const
{
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw InputError("results", "no column \"" + name + "\"", "run the case again");
    std::vector<double> column;
    for (std::size_t i = static_cast<std::size_t>(found - names.begin()); i < values.size(); i += names.size())
        column.push_back(values[i]);
    return column;
}

RunRecord::RunRecord(const std::filesystem::path& results_file)
    : file(results_file), results(results_file), end(results::run_end_of(results_file))
{
    if (results.times.empty())
        throw InputError(file.string(), "no frame", "give the results of a run that has written a frame");
    const Hdf5File open = Hdf5File::open(results_file);
    read_case(open, *this);
    read_materials(open, *this);
    read_summary(open, *this);
    const std::size_t blocks = results.model.block_names.size();
    groups = open.read_texts("/model/groups");
    block_group = values<std::int32_t>(open, "/model/block_group", blocks);
    for (std::int32_t& group : block_group)
        group = std::clamp(group, 0, std::max(0, static_cast<std::int32_t>(groups.size()) - 1));
    mass = values<double>(open, "/model/mass", blocks);
    volume = values<double>(open, "/model/volume", blocks);
    const auto of_joints = [&](const std::string& name) {
        return results.model.joints.empty() ? std::vector<double>()
                                            : values<double>(open, name, results.model.joints.size());
    };
    joint_area = of_joints("/joints/area");
    joint_facing_area = of_joints("/joints/facing_area");
    energy = columns_of(open, "/frames/energy");
    steps = columns_of(open, "/frames/report");
    for (Columns* columns : {&energy, &steps})  // of the whole frames alone
        columns->values.resize(std::min(columns->values.size(), columns->names.size() * results.times.size()));
    histories = columns_of(open, "/histories/values");
    motions = results::recorded_motions(results_file);
    if (open.has("/motions/descriptions")) motion_descriptions = open.read_texts("/motions/descriptions");
    bars = bars_of(open, results.times, summary);
    course = course_of(results);
    take_joint_counts(summary, course);
    mechanism = mechanism_in(results, course, failed);
    mechanism.goes_on = standing.empty() ? end.outcome != "completed" : standing == name_of(Standing::moves);
}

}  // namespace voussoir::app::report
