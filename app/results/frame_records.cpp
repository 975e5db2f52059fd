#include "app/results/frame_records.h"

#include <Eigen/Eigenvalues>

#include "app/results/energy_terms.h"
#include "app/results/scene_vectors.h"
#include "libdda/analysis/joint_resultants.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

using Columns = std::vector<std::pair<std::string, double>>;

Columns report_columns(const RunReport& report)
{
    return {{"steps", static_cast<double>(report.steps)},
            {"step_cuts", static_cast<double>(report.step_cuts)},
            {"unconverged_steps", static_cast<double>(report.unconverged_steps)},
            {"open_close_iterations", static_cast<double>(report.open_close_iterations)},
            {"factorisations", static_cast<double>(report.factorisations)},
            {"linear_iterations", static_cast<double>(report.linear_iterations)},
            {"max_penetration_m", report.max_penetration},
            {"static_unbalanced", report.static_unbalanced}};
}

std::vector<std::string> names_of(const Columns& columns)
{
    std::vector<std::string> names;
    for (const auto& [name, value] : columns) names.push_back(name);
    return names;
}

std::vector<double> values_of(const Columns& columns)
{
    std::vector<double> values;
    for (const auto& [name, value] : columns) values.push_back(value);
    return values;
}

/// |displacement of the block's centroid - that of the ground| for each face [m].
std::vector<float> face_displacements(const Model& model, const SurfaceMesh& mesh, const State& state,
                                      const Vector3d& ground)
{
    std::vector<float> values;
    for (const int block : mesh.face_block) {
        const Vector3d moved =
            pose_of(model.kinematics, state, block).centroid - model.blocks[block].moments.centroid;
        values.push_back(static_cast<float>((moved - ground).norm()));
    }
    return values;
}

}  // namespace

FrameRecords::FrameRecords(const Model& model, Hdf5File& file)
{
    const std::uint64_t blocks = model.blocks.size();
    const SurfaceMesh mesh = surface_mesh_of(model);
    const auto dimension = static_cast<std::uint64_t>(mesh.dimension);
    const std::uint64_t vertices = mesh.vertex_block.size(), faces = mesh.face_block.size();
    const auto real = ElementType::float64;
    file.make_group("/frames");
    file.write("/frames/count", std::vector<std::int64_t>{0});
    time_ = file.make_series("/frames/time", real, {});
    step_ = file.make_series("/frames/step", ElementType::int64, {});
    stage_ = file.make_series("/frames/stage", ElementType::int32, {});
    const auto coordinates = static_cast<std::uint64_t>(coordinates_per_block(model.kinematics));
    const auto unknowns = static_cast<std::uint64_t>(unknowns_per_block(model.kinematics));
    coordinates_ = file.make_series("/frames/coordinates", real, {blocks, coordinates});
    velocities_ = file.make_series("/frames/velocities", real, {blocks, unknowns});
    ground_ = file.make_series("/frames/ground_displacement", real, {dimension});
    positions_ = file.make_series("/frames/positions", ElementType::float32, {vertices, dimension});
    face_displacement_ = file.make_series("/frames/face_displacement", ElementType::float32, {faces});
    if (is_deformable(model.kinematics)) {
        const std::vector<std::string> components = stress_components(model);
        stress_ = file.make_series("/frames/stress", real, {blocks, components.size()});
        file.attribute("/frames/stress", "columns", components);
        face_least_stress_ = file.make_series("/frames/face_least_stress", ElementType::float32, {faces});
        face_greatest_stress_ = file.make_series("/frames/face_greatest_stress", ElementType::float32, {faces});
    }
    const std::vector<std::string> energies = names_of(energy_terms({})), figures = names_of(report_columns({}));
    energy_ = file.make_series("/frames/energy", real, {energies.size()});
    file.attribute("/frames/energy", "columns", energies);
    report_ = file.make_series("/frames/report", real, {figures.size()});
    file.attribute("/frames/report", "columns", figures);
    make_joints(model.kinematics, file);
}

void FrameRecords::make_joints(Kinematics kinematics, Hdf5File& file)
{
    const auto real = ElementType::float64;
    const Extents vector = {static_cast<std::uint64_t>(dimension_of(kinematics))};
    const std::string group = "/frames/joints/";
    file.make_group("/frames/joints");
    joints_.rows = file.make_series(group + "rows", ElementType::int64, {2});
    file.attribute(group + "rows", "columns", std::vector<std::string>{"first", "count"});
    joints_.pair = file.make_series(group + "pair", ElementType::int32, {2});
    joints_.force = file.make_series(group + "force", real, vector);
    joints_.moment = file.make_series(group + "moment", real, is_planar(kinematics) ? Extents{} : vector);
    joints_.centre = file.make_series(group + "centre", real, vector);
    joints_.pressure_centre = file.make_series(group + "pressure_centre", real, vector);
    joints_.normal = file.make_series(group + "normal", real, vector);
    joints_.normal_force = file.make_series(group + "normal_force", real, {});
    joints_.opening = file.make_series(group + "opening", real, {});
    joints_.slip = file.make_series(group + "slip", real, {});
    joints_.area = file.make_series(group + "area", real, {});
    joints_.closed_area = file.make_series(group + "closed_area", real, {});
}

void FrameRecords::append_joints(const Model& model, const State& state, Hdf5File& file)
{
    const std::vector<JointResultant> joints = joint_resultants(model, state);
    std::vector<std::int32_t> pair;
    std::vector<double> force, moment, centre, pressure_centre, normal, normal_force, opening, slip, area, closed;
    for (const JointResultant& joint : joints) {
        pair.insert(pair.end(), {joint.block_a, joint.block_b});
        append_vector(force, joint.force, model.kinematics);
        append_moment(moment, joint.moment, model.kinematics);
        append_vector(centre, joint.centre, model.kinematics);
        append_vector(pressure_centre, joint.pressure_centre, model.kinematics);
        append_vector(normal, joint.normal, model.kinematics);
        normal_force.push_back(joint.normal_force);
        opening.push_back(joint.max_opening);
        slip.push_back(joint.slip);
        area.push_back(joint.area);
        closed.push_back(joint.closed_area);
    }
    const std::uint64_t rows = joints.size();
    const auto first = static_cast<std::int64_t>(joints_.pair.extents[0]);
    file.append(joints_.pair, pair, rows);
    file.append(joints_.force, force, rows);
    file.append(joints_.moment, moment, rows);
    file.append(joints_.centre, centre, rows);
    file.append(joints_.pressure_centre, pressure_centre, rows);
    file.append(joints_.normal, normal, rows);
    file.append(joints_.normal_force, normal_force, rows);
    file.append(joints_.opening, opening, rows);
    file.append(joints_.slip, slip, rows);
    file.append(joints_.area, area, rows);
    file.append(joints_.closed_area, closed, rows);
    file.append(joints_.rows, std::vector<std::int64_t>{first, static_cast<std::int64_t>(rows)});
}

void FrameRecords::append_stresses(const Model& model, const SurfaceMesh& mesh, const State& state, Hdf5File& file)
{
    const std::vector<std::string> components = stress_components(model);
    std::vector<double> stresses;
    std::vector<float> least, greatest;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const Eigen::Matrix3d s = stress_of(model, state, static_cast<int>(b));
        for (const std::string& name : components) stresses.push_back(component(s, name));
        const Vector3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(s).eigenvalues();
        least.push_back(static_cast<float>(principal[0]));
        greatest.push_back(static_cast<float>(principal[2]));
    }
    std::vector<float> face_least, face_greatest;
    for (const int block : mesh.face_block) {
        face_least.push_back(least[block]);
        face_greatest.push_back(greatest[block]);
    }
    file.append(stress_, stresses);
    file.append(face_least_stress_, face_least);
    file.append(face_greatest_stress_, face_greatest);
}

void FrameRecords::append(const Model& model, const SurfaceMesh& mesh, const State& state, const RunReport& report,
                          Hdf5File& file)
{
    const Vector3d ground = ground_displacement(model, state);
    const std::vector<double> places = positions_of(mesh, model.kinematics, state);
    file.append(coordinates_, state.coordinates);
    file.append(velocities_, state.velocities);
    file.append(ground_, stored_vector(ground, model.kinematics));
    file.append(positions_, std::vector<float>(places.begin(), places.end()));
    file.append(face_displacement_, face_displacements(model, mesh, state, ground));
    if (is_deformable(model.kinematics)) append_stresses(model, mesh, state, file);
    append_joints(model, state, file);
    file.append(energy_, values_of(energy_terms(report.energy)));
    file.append(report_, values_of(report_columns(report)));
    file.append(stage_, std::vector<std::int32_t>{state.stage});
    file.append(step_, std::vector<std::int64_t>{state.step});
    file.append(time_, std::vector<double>{state.time});
    file.flush();
    file.overwrite("/frames/count", static_cast<std::int64_t>(time_.extents[0]));
    file.flush();
}

}  // namespace voussoir
