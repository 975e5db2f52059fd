#include "app/results/model_records.h"

#include <cmath>

#include "app/results/results_writer.h"
#include "app/results/scene_vectors.h"
#include "app/results/settings.h"
#include "app/version/version.h"

namespace voussoir::app::results
{

namespace
{

void write_scene(const Model& model, Hdf5File& file)
{
    file.attribute("/", "kinematics", std::string(name_of(model.kinematics)));
    file.attribute("/", "unknowns_per_block", static_cast<std::int64_t>(unknowns_per_block(model.kinematics)));
    if (model.fit_tolerance > 0) file.attribute("/", "fit_tolerance_m", model.fit_tolerance);
    if (!is_planar(model.kinematics)) return;
    file.attribute("/", "thickness_m", model.thickness);
    if (is_deformable(model.kinematics)) file.attribute("/", "plane", std::string(name_of(model.plane)));
}

void write_engine(const version::EngineVersion& engine, Hdf5File& file)
{
    file.attribute("/", "voussoir_version", engine.version);
    file.attribute("/", "engine_commit", engine.commit);
    const char* const dirty = engine.dirty == version::Dirty::unknown ? "unknown"
                              : engine.dirty == version::Dirty::yes   ? "yes"
                                                                      : "no";
    file.attribute("/", "engine_dirty", std::string(dirty));
    file.attribute("/", "engine_sources", engine.sources);
    const Compilation& compiled = engine.compilation;
    file.attribute("/", "engine_compilation",
                   compiled.instruction_set + ", " + compiled.compiler + ", Eigen " + compiled.eigen);
}

void write_case(const Case& the_case, Hdf5File& file)
{
    file.attribute("/", "format", std::string("voussoir results 2"));
    write_engine(version::engine_version(), file);
    file.attribute("/", "title", the_case.title);
    write_scene(the_case.model, file);
    file.make_group("/case");
    file.write_text("/case/file", the_case.file.filename().string());
    file.write_text("/case/text", the_case.text);
    file.write_texts("/case/overrides", the_case.overrides);
    file.write_texts("/case/defaults", the_case.defaults);
    file.write_texts("/case/warnings", the_case.warnings);
    file.write_texts("/case/left_out", left_out(the_case));
    file.write_text("/case/settings", settings_json(the_case.stages, the_case.model.kinematics));
}

/// Only if a material has any.
void write_rayleigh(const Model& model, Hdf5File& file)
{
    std::vector<double> rows;
    bool any = false;
    for (const BlockMaterial& material : model.materials) {
        rows.insert(rows.end(), {material.rayleigh.of_mass, material.rayleigh.of_stiffness});
        any = any || material.rayleigh.any();
    }
    if (!any) return;
    file.write("/model/materials/rayleigh", rows, {rows.size() / 2, 2});
    file.attribute("/model/materials/rayleigh", "columns",
                   std::vector<std::string>{"of_mass_1_s", "of_stiffness_s"});
}

/// Only if a material has any.
void write_branches(const Model& model, Hdf5File& file)
{
    std::vector<double> rows;
    for (std::size_t material = 0; material < model.materials.size(); ++material)
        for (const MaxwellBranch& branch : model.materials[material].branches)
            rows.insert(rows.end(), {static_cast<double>(material), branch.share, branch.time});
    if (rows.empty()) return;
    file.write("/model/materials/branches", rows, {rows.size() / 3, 3});
    file.attribute("/model/materials/branches", "columns",
                   std::vector<std::string>{"material", "share", "time_s"});
}

void write_materials(const Model& model, Hdf5File& file)
{
    std::vector<std::string> names;
    std::vector<double> density, young, poisson;
    for (const BlockMaterial& material : model.materials) {
        names.push_back(material.name);
        density.push_back(material.density);
        young.push_back(material.young);
        poisson.push_back(material.poisson);
    }
    file.make_group("/model/materials");
    file.write_texts("/model/materials/name", names);
    file.write("/model/materials/density", density);
    file.write("/model/materials/young", young);
    file.write("/model/materials/poisson", poisson);
    write_rayleigh(model, file);
    write_branches(model, file);
}

/// Only if there are any.
void write_side_ties(const Model& model, Hdf5File& file)
{
    if (model.side_ties.empty()) return;
    std::vector<std::int32_t> faces;
    std::vector<double> stiffness;
    for (const SideTie& tie : model.side_ties) {
        faces.insert(faces.end(), {tie.a.block, tie.a.part, tie.a.face, tie.b.block, tie.b.part, tie.b.face});
        stiffness.insert(stiffness.end(), {tie.normal, tie.shear});
    }
    file.make_group("/model/side_ties");
    file.write("/model/side_ties/faces", faces, {faces.size() / 6, 6});
    file.attribute("/model/side_ties/faces", "columns",
                   std::vector<std::string>{"block_a", "part_a", "face_a", "block_b", "part_b", "face_b"});
    file.write("/model/side_ties/stiffness", stiffness, {stiffness.size() / 2, 2});
    file.attribute("/model/side_ties/stiffness", "columns", std::vector<std::string>{"normal_Pa_m", "shear_Pa_m"});
}

/// Only if friction depends on the speed of slip in some joint.
void write_friction_at_speed(const Model& model, Hdf5File& file)
{
    std::vector<double> rows;
    for (std::size_t joint = 0; joint < model.joints.size(); ++joint)
        for (const FrictionAtSpeed& point : model.joints[joint].friction_at_speed)
            rows.insert(rows.end(), {static_cast<double>(joint), point.speed, point.angle});
    if (!rows.empty()) file.write("/model/joint_materials/friction_at_speed", rows, {rows.size() / 3, 3});
}

void write_joints(const Model& model, Hdf5File& file)
{
    std::vector<std::string> names, kinds, faces;
    std::vector<double> friction, cohesion, tension, stiffness, factor, shear, dashpot, restitution;
    for (const JointMaterial& joint : model.joints) {
        names.push_back(joint.name);
        friction.push_back(joint.friction_angle);
        cohesion.push_back(joint.cohesion);
        tension.push_back(joint.tensile_strength);
        kinds.emplace_back(name_of(joint.stiffness.kind));
        stiffness.push_back(joint.stiffness.value);
        factor.push_back(joint.stiffness.factor);
        shear.push_back(joint.shear_to_normal_stiffness);
        faces.emplace_back(name_of(joint.face));
        dashpot.push_back(joint.relaxation_time);
        restitution.push_back(joint.has_landing_law() ? *joint.restitution : std::nan(""));
    }
    file.make_group("/model/joint_materials");
    file.write_texts("/model/joint_materials/name", names);
    file.write("/model/joint_materials/friction_angle", friction);
    file.write("/model/joint_materials/cohesion", cohesion);
    file.write("/model/joint_materials/tensile_strength", tension);
    file.write_texts("/model/joint_materials/stiffness_kind", kinds);
    file.write("/model/joint_materials/stiffness", stiffness);
    file.write("/model/joint_materials/stiffness_factor", factor);
    file.write("/model/joint_materials/shear_to_normal_stiffness", shear);
    file.write_texts("/model/joint_materials/face", faces);
    file.write("/model/joint_materials/dashpot", dashpot);
    file.write("/model/joint_materials/restitution",
               restitution);  // NaN: impacts are left to springs and dashpots
    write_friction_at_speed(model, file);
    std::vector<std::int32_t> of_groups(model.joint_of_groups.begin(), model.joint_of_groups.end());
    file.write("/model/joint_of_groups", of_groups, {model.groups.size(), model.groups.size()});
}

void write_blocks(const Model& model, Hdf5File& file)
{
    std::vector<std::string> names;
    std::vector<std::int32_t> group, material;
    std::vector<double> volume, mass, centroid, second;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const Block& block = model.blocks[b];
        names.push_back(block.name);
        group.push_back(block.group);
        material.push_back(block.material);
        volume.push_back(block.moments.volume);
        mass.push_back(model.mass(static_cast<int>(b)));
        append_vector(centroid, block.moments.centroid, model.kinematics);
        for (const int axis : axes_of(model.kinematics))
            append_vector(second, block.moments.second.col(axis), model.kinematics);
    }
    const std::uint64_t count = names.size(), dimension = axes_of(model.kinematics).size();
    file.write_texts("/model/block_names", names);
    file.write("/model/block_group", group);
    file.write("/model/block_material", material);
    file.write("/model/volume", volume);
    file.write("/model/mass", mass);
    file.write("/model/centroid", centroid, {count, dimension});
    file.write("/model/second_moments", second, {count, dimension, dimension});
    std::vector<double> friction_factor;
    for (const Block& block : model.blocks) friction_factor.push_back(block.friction_factor);
    if (std::any_of(friction_factor.begin(), friction_factor.end(), [](double factor) { return factor != 1; }))
        file.write("/model/friction_factor", friction_factor);
}

void write_foundations(const Model& model, Hdf5File& file)
{
    if (model.foundations.empty()) return;
    std::vector<std::int32_t> block, held;
    for (const Foundation& foundation : model.foundations) {
        block.push_back(foundation.block);
        for (const int axis : axes_of(model.kinematics)) held.push_back(foundation.translation_held[axis] ? 1 : 0);
        held.push_back(foundation.rotation_held ? 1 : 0);
    }
    std::vector<std::string> columns = axis_names(model.kinematics);
    columns.emplace_back("rotation");
    file.make_group("/model/foundations");
    file.write("/model/foundations/block", block);
    file.write("/model/foundations/held", held, {block.size(), columns.size()});
    file.attribute("/model/foundations/held", "columns", columns);
}

/// Only if there are any. A strength that is not given is infinite.
void write_bars(const Model& model, Hdf5File& file)
{
    if (model.bars.empty()) return;
    std::vector<std::string> names;
    std::vector<std::int32_t> blocks, is_rod;
    std::vector<double> ends, springs;
    for (const Bar& bar : model.bars) {
        names.push_back(bar.name);
        blocks.insert(blocks.end(), {bar.block_a, bar.block_b});
        is_rod.push_back(bar.is_rod);
        for (const Eigen::Vector3d& anchor : {bar.anchor_a, bar.anchor_b})
            for (const int axis : axes_of(model.kinematics)) ends.push_back(anchor[axis]);
        springs.insert(springs.end(),
                       {bar.axial, bar.lateral, bar.tension, bar.compression, bar.shear, bar.prestress});
    }
    const std::size_t dimension = axes_of(model.kinematics).size();
    file.make_group("/model/bars");
    file.write_texts("/model/bars/name", names);
    file.write("/model/bars/blocks", blocks, {names.size(), 2});
    file.write("/model/bars/is_rod", is_rod);
    file.write("/model/bars/anchors", ends, {names.size(), 2 * dimension});
    file.write("/model/bars/springs", springs, {names.size(), 6});
    file.attribute("/model/bars/springs", "columns",
                   std::vector<std::string>{"axial_N_m", "lateral_N_m", "tension_N", "compression_N", "shear_N",
                                            "prestress_N"});
}

/// Only if there are any.
void write_boundaries(const Model& model, Hdf5File& file)
{
    if (!model.tied_sides.empty())
        file.write("/model/tied_sides",
                   std::vector<std::int32_t>(model.tied_sides.begin(), model.tied_sides.end()));
    write_side_ties(model, file);
    if (model.boundaries.empty()) return;
    std::vector<std::string> names, at_rest;
    std::vector<std::int32_t> faces;
    std::vector<std::int32_t> free_field;
    for (std::size_t b = 0; b < model.boundaries.size(); ++b) {
        const std::vector<int>& columns = model.boundaries[b].free_field;
        for (std::size_t i = 0; i < columns.size(); ++i)
            free_field.insert(free_field.end(),
                              {static_cast<std::int32_t>(b), static_cast<std::int32_t>(i), columns[i]});
        names.push_back(model.boundaries[b].name);
        at_rest.emplace_back(name_of(model.boundaries[b].at_rest));
        for (const BlockFace& face : model.boundaries[b].faces)
            faces.insert(faces.end(), {static_cast<std::int32_t>(b), face.block, face.part, face.face});
    }
    file.make_group("/model/boundaries");
    file.write_texts("/model/boundaries/name", names);
    file.write_texts("/model/boundaries/at_rest", at_rest);
    file.write("/model/boundaries/faces", faces, {faces.size() / 4, 4});
    file.attribute("/model/boundaries/faces", "columns",
                   std::vector<std::string>{"boundary", "block", "part", "face"});
    if (free_field.empty()) return;
    file.write("/model/boundaries/free_field", free_field, {free_field.size() / 3, 3});
    file.attribute("/model/boundaries/free_field", "columns",
                   std::vector<std::string>{"boundary", "face_of_it", "block"});
}

/// Polygons as XDMF wants mixed cells: kind 3 (polygon), number of corners, corners.
std::vector<std::int32_t> xdmf_topology(const SurfaceMesh& mesh)
{
    std::vector<std::int32_t> cells;
    for (std::size_t f = 0; f < mesh.face_block.size(); ++f) {
        cells.push_back(3);
        cells.push_back(mesh.face_first[f + 1] - mesh.face_first[f]);
        for (int i = mesh.face_first[f]; i < mesh.face_first[f + 1]; ++i) cells.push_back(mesh.face_vertices[i]);
    }
    return cells;
}

void write_mesh(const SurfaceMesh& mesh, Hdf5File& file)
{
    file.make_group("/model/mesh");
    file.write("/model/mesh/levers", mesh.levers,
               {mesh.vertex_block.size(), static_cast<std::uint64_t>(mesh.dimension)});
    file.write("/model/mesh/block_first_vertex", mesh.block_first_vertex);
    file.write("/model/mesh/face_first", mesh.face_first);
    file.write("/model/mesh/face_vertices", mesh.face_vertices);
    file.write("/model/mesh/face_block", mesh.face_block);
    file.write("/model/mesh/face_part", mesh.face_part);
    file.write("/model/mesh/xdmf_topology", xdmf_topology(mesh));
}

/// One motion of one stage, with all that follow it.
struct MotionUse {
    int stage = 0;
    const GroundMotion* motion = nullptr;
    std::vector<std::string> followers;  // "abutment_left x", "body acceleration of abutment_left x"
};

std::vector<MotionUse> motion_uses(const Case& the_case)
{
    const char* const axes[] = {"x", "y", "z"};
    std::vector<MotionUse> uses;
    const auto add = [&](int stage, const GroundMotion* motion, const std::string& follower) {
        for (MotionUse& use : uses) {
            if (use.stage != stage || use.motion != motion) continue;
            use.followers.push_back(follower);
            return;
        }
        uses.push_back({stage, motion, {follower}});
    };
    const Model& model = the_case.model;
    for (std::size_t s = 0; s < the_case.stages.size(); ++s) {
        for (const FoundationMotion& motion : the_case.stages[s].motions) {
            const Block& block = model.blocks[model.foundations[motion.foundation].block];
            add(static_cast<int>(s), motion.motion.get(), block.name + " " + axes[motion.component]);
        }
        for (const BodyAcceleration& body : the_case.stages[s].body_accelerations) {
            add(static_cast<int>(s), body.motion.get(),
                "body acceleration of " + model.blocks[body.block].name + " " + axes[body.component]);
        }
        for (const IncomingWave& wave : the_case.stages[s].incoming_waves) {
            const std::string share = wave.share == 1 ? "" : ", half of it";
            add(static_cast<int>(s), wave.motion.get(),
                "wave through " + model.boundaries[wave.boundary].name + " " + axes[wave.component] + share);
        }
    }
    return uses;
}

void write_motion(const Case& the_case, const MotionUse& use, const std::string& group, Hdf5File& file)
{
    const Stage& stage = the_case.stages[use.stage];
    const double step = stage.control.time_step;
    const auto count = static_cast<std::int64_t>(std::ceil(stage.duration / step - 1e-9)) + 1;
    std::vector<double> values;
    for (std::int64_t i = 0; i < count; ++i) {
        const double time = static_cast<double>(i) * step;
        values.insert(values.end(), {time, use.motion->acceleration(time), use.motion->velocity(time),
                                     use.motion->displacement(time)});
    }
    file.make_group(group);
    file.attribute(group, "source", use.motion->source());
    file.attribute(group, "stage", stage.name);
    file.attribute(group, "peak_acceleration_m_s2", use.motion->peak_acceleration());
    file.attribute(group, "residual_velocity_m_s", use.motion->residual_velocity());
    file.attribute(group, "residual_displacement_m", use.motion->residual_displacement());
    file.write_texts(group + "/followers", use.followers);
    file.write(group + "/samples", values, {static_cast<std::uint64_t>(count), 4});
    file.attribute(group + "/samples", "columns",
                   std::vector<std::string>{"time_s", "acceleration_m_s2", "velocity_m_s", "displacement_m"});
}

void write_motions(const Case& the_case, Hdf5File& file)
{
    const std::vector<MotionUse> uses = motion_uses(the_case);
    if (uses.empty()) return;
    file.make_group("/motions");
    std::vector<std::string> notes;
    for (const MotionNote& note : the_case.motions) notes.push_back(note.description);
    file.write_texts("/motions/descriptions", notes);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        write_motion(the_case, uses[i], "/motions/motion_" + std::to_string(i + 1), file);
    }
}

}  // namespace

void write_model_records(const Case& the_case, const SurfaceMesh& mesh, Hdf5File& file)
{
    const Model& model = the_case.model;
    write_case(the_case, file);
    file.make_group("/model");
    file.write("/model/origin", stored_vector(model.origin, model.kinematics));
    file.write_texts("/model/groups", model.groups);
    write_blocks(model, file);
    write_materials(model, file);
    write_joints(model, file);
    write_foundations(model, file);
    write_bars(model, file);
    write_boundaries(model, file);
    write_mesh(mesh, file);
    write_motions(the_case, file);
}

}  // namespace voussoir::app::results
