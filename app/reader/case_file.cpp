#include "app/reader/case_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/reader/attached_masses.h"
#include "app/reader/automatic_steps.h"
#include "app/reader/bars.h"
#include "app/reader/blocks.h"
#include "app/reader/boundaries.h"
#include "app/reader/drawn_fit.h"
#include "app/reader/foundation.h"
#include "app/reader/initial_state.h"
#include "app/reader/materials.h"
#include "app/reader/motion.h"
#include "app/reader/output.h"
#include "app/reader/overrides.h"
#include "app/reader/plane.h"
#include "app/reader/stages.h"
#include "app/reader/yaml_cursor.h"
#include "libdda/contact/normal_stiffness.h"

namespace voussoir::app::reader
{
namespace
{

std::string read_text(const std::filesystem::path& file)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        throw InputError(file.string(), std::filesystem::exists(file, error) ? "not a file" : "no such file",
                         "give a YAML case file");
    if (std::filesystem::file_size(file, error) > largest_case_file)
        throw InputError(file.string(), "larger than 16 MiB", "a case file is much smaller");
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
    if (!stream.good() && !stream.eof())
        throw InputError(file.string(), "cannot be read", "check its permissions");
    return text.str();
}

/// The model: what is there. Everything is read even when something is wrong, so that all faults are listed.
void read_model(YamlCursor& top, Case& result, Findings& findings, std::vector<FoundationEntry>& foundations)
{
    Model& model = result.model;
    model.kinematics = top.choice_or<Kinematics>("kinematics",
                                                 {{"spatial_deformable", Kinematics::spatial_deformable},
                                                  {"spatial_rigid", Kinematics::spatial_rigid},
                                                  {"planar_deformable", Kinematics::planar_deformable},
                                                  {"planar_rigid", Kinematics::planar_rigid}},
                                                 Kinematics::spatial_deformable);
    read_plane_condition(top, model);
    model.materials = read_materials(top, model.kinematics);
    model.joints = read_joints(top);
    const std::optional<double> fit_tolerance = read_fit_tolerance(top);
    model.fit_tolerance = fit_tolerance.value_or(0);
    const std::vector<InitialEntry> initial_state = read_initial_state(top, model.kinematics);
    result.mesh_files = read_blocks(top, result.file.parent_path(), initial_state, model, findings);
    model.joint_of_groups = read_joint_rules(top, model.joints, model.groups);
    read_attached_masses(top, model);
    foundations = read_foundations(top, model);
    read_boundaries(top, model);
    give_initial_motions(initial_state, model);
    findings.apart = blocks_named_in(initial_state, model);
    settle_fit(top, fit_tolerance, result, findings);
    read_bars(top, model);  // dowels in the joints that the run will have
}

/// Whether nothing but a steady weight acts in the stages, and none sees stones move that begin turned or moving.
/// Who raises the weight slowly wants to see them fall, and has stones that rattle.
/// @param apart blocks that begin turned or moving
bool has_weight_alone(const std::vector<Stage>& stages, const std::vector<std::string>& apart)
{
    const auto is_lively = [&](const Stage& stage) {
        return stage.type == StageType::dynamic &&
               (!apart.empty() || stage.gravity_ramp.duration > 0 || !stage.motions.empty() ||
                !stage.body_accelerations.empty() || !stage.incoming_waves.empty());
    };
    return std::none_of(stages.begin(), stages.end(), is_lively);
}

void read_everything(YamlCursor& top, Case& result, Findings& findings)
{
    result.title = top.find_text("title").value_or(result.file.stem().string());
    std::vector<FoundationEntry> foundations;
    read_model(top, result, findings, foundations);
    MotionContext motions{result.file.parent_path(), result.model, result.motions};
    result.stages = read_stages(top, result.model, foundations, motions);
    if (has_weight_alone(result.stages, findings.apart)) contact::stiffen_for_rest(result.model);
    result.output = read_output(top, result.model, result.stages);
    if (findings.faults.empty()) choose_time_steps(result, findings);
    refuse_rounded_stresses(result, findings);
    refuse_soft_joints(result, findings);
    top.reject_unknown_keys();
}

}  // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides, CaseStones* stones)
{
    return read_case_text(file, read_text(file), overrides, stones);
}

Case read_case_text(const std::filesystem::path& file, const std::string& text,
                    const std::vector<std::string>& overrides, CaseStones* stones)
{
    Case result;
    result.file = file;
    result.text = text;
    result.overrides = overrides;
    Findings findings;
    findings.file = file.string();

    YamlNode root = parse_yaml(result.text, findings.file);
    if (root.kind == YamlNode::Kind::null) throw InputError(findings.file, "the file is empty", "give a case");
    if (root.kind != YamlNode::Kind::map)
        throw InputError(findings.file + ":" + std::to_string(root.line), describe(root),
                         "a case is a map of keys: materials, joints, blocks, stages, ...");
    for (const std::string& setting : overrides) apply_override(setting, root, findings);

    YamlCursor top(root, "", findings);
    try {
        read_everything(top, result, findings);
    } catch (const InputError&) {  // more faults than anybody reads
        if (stones) *stones = {std::move(findings.geometry), result.model, std::move(findings.apart)};
        throw;
    }
    if (stones) *stones = {std::move(findings.geometry), result.model, std::move(findings.apart)};
    if (!findings.faults.empty()) throw InputError(std::move(findings.faults));
    result.defaults = in_words(findings.defaults);
    result.warnings = std::move(findings.warnings);
    return result;
}

}  // namespace voussoir::app::reader
