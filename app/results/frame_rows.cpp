#include "app/results/frame_rows.h"

#include <Eigen/Eigenvalues>

#include "app/results/bar_rows.h"
#include "app/results/energy_terms.h"
#include "app/results/joint_rows.h"
#include "app/results/scene_vectors.h"

namespace voussoir::app::results
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

/// |displacement of the block's centroid - that of the foot| for each face [m], since the first motion began;
/// before, since the start.
std::vector<float> face_displacements(const Model& model, const SurfaceMesh& mesh, const Rest& rest,
                                      const State& state)
{
    State from;
    if (rest.is_over) from.coordinates = rest.coordinates;
    if (from.coordinates.empty()) from = initial_state(model);
    const Vector3d foot = rest.foot.displacement(model, state) - rest.foot.displacement(model, from);
    std::vector<float> of_blocks;
    for (int block = 0; block < static_cast<int>(model.blocks.size()); ++block) {
        const Vector3d moved =
            pose_of(model.kinematics, state, block).centroid - pose_of(model.kinematics, from, block).centroid;
        of_blocks.push_back(static_cast<float>((moved - foot).norm()));
    }
    std::vector<float> values;
    for (const int block : mesh.face_block) values.push_back(of_blocks[block]);
    return values;
}

void add_contact_datasets(Kinematics kinematics, std::vector<GrowingDataset>& datasets)
{
    const auto real = ElementType::float64;
    const Extents vector = {static_cast<std::uint64_t>(dimension_of(kinematics))};
    const std::string group = "/frames/contacts/";
    datasets.push_back({group + "rows", ElementType::int64, {2}, {"first", "count"}});
    datasets.push_back({group + "pair", ElementType::int32, {2}, {}});
    for (const char* name : {"force", "moment", "centre", "pressure_centre", "normal"})
        datasets.push_back({group + name, real, vector, {}});
    if (is_planar(kinematics)) datasets[datasets.size() - 4].row = {};  // the moment
    for (const char* name : {"normal_force", "area", "closed_area"})
        datasets.push_back({group + name, real, {}, {}});
}

/// Of all contacts, those of no joint too.
void add_contact_rows(Kinematics kinematics, const std::vector<JointResultant>& contacts, std::int64_t& first,
                      std::vector<Rows>& rows)
{
    std::vector<std::int32_t> pair;
    std::vector<double> force, moment, centre, pressure_centre, normal, normal_force, area, closed;
    for (const JointResultant& contact : contacts) {
        pair.insert(pair.end(), {contact.block_a, contact.block_b});
        append_vector(force, contact.force, kinematics);
        append_moment(moment, contact.moment, kinematics);
        append_vector(centre, contact.centre, kinematics);
        append_vector(pressure_centre, contact.pressure_centre, kinematics);
        append_vector(normal, contact.normal, kinematics);
        normal_force.push_back(contact.normal_force);
        area.push_back(contact.area);
        closed.push_back(contact.closed_area);
    }
    const auto count = static_cast<std::int64_t>(contacts.size());
    const auto add = [&](const char* name, auto& values) {
        rows.push_back({std::string("/frames/contacts/") + name, std::move(values), contacts.size()});
    };
    rows.push_back({"/frames/contacts/rows", std::vector<std::int64_t>{first, count}});
    add("pair", pair);
    add("force", force);
    add("moment", moment);
    add("centre", centre);
    add("pressure_centre", pressure_centre);
    add("normal", normal);
    add("normal_force", normal_force);
    add("area", area);
    add("closed_area", closed);
    first += count;
}

void add_stress_rows(const Model& model, const SurfaceMesh& mesh, const State& state, std::vector<Rows>& rows)
{
    const std::vector<std::string> components = stress_components(model);
    std::vector<double> stresses;
    std::vector<float> least, greatest;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const Eigen::Matrix3d s = stress_of(model, state, static_cast<int>(b));
        for (const std::string& name : components) stresses.push_back(component(s, name));
        const Vector3d principal =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(s, Eigen::EigenvaluesOnly).eigenvalues();
        least.push_back(static_cast<float>(principal[0]));
        greatest.push_back(static_cast<float>(principal[2]));
    }
    std::vector<float> face_least, face_greatest;
    for (const int block : mesh.face_block) {
        face_least.push_back(least[block]);
        face_greatest.push_back(greatest[block]);
    }
    rows.push_back({"/frames/stress", std::move(stresses)});
    rows.push_back({"/frames/face_least_stress", std::move(face_least)});
    rows.push_back({"/frames/face_greatest_stress", std::move(face_greatest)});
}

}  // namespace

std::vector<GrowingDataset> frame_datasets(const Model& model, const SurfaceMesh& mesh,
                                           const std::vector<WatchedJoint>& joints)
{
    const std::uint64_t blocks = model.blocks.size();
    const auto dimension = static_cast<std::uint64_t>(mesh.dimension);
    const std::uint64_t vertices = mesh.vertex_block.size(), faces = mesh.face_block.size();
    const auto real = ElementType::float64, single = ElementType::float32;
    const auto coordinates = static_cast<std::uint64_t>(coordinates_per_block(model.kinematics));
    const auto unknowns = static_cast<std::uint64_t>(unknowns_per_block(model.kinematics));
    std::vector<GrowingDataset> datasets = {{"/frames/time", real, {}, {}},
                                            {"/frames/step", ElementType::int64, {}, {}},
                                            {"/frames/stage", ElementType::int32, {}, {}},
                                            {"/frames/coordinates", real, {blocks, coordinates}, {}},
                                            {"/frames/velocities", real, {blocks, unknowns}, {}},
                                            {"/frames/ground_displacement", real, {dimension}, {}},
                                            {"/frames/positions", single, {vertices, dimension}, {}},
                                            {"/frames/face_displacement", single, {faces}, {}}};
    if (is_deformable(model.kinematics)) {
        const std::vector<std::string> components = stress_components(model);
        datasets.push_back({"/frames/stress", real, {blocks, components.size()}, components});
        datasets.push_back({"/frames/face_least_stress", single, {faces}, {}});
        datasets.push_back({"/frames/face_greatest_stress", single, {faces}, {}});
    }
    const std::vector<std::string> energies = names_of(energy_terms({})), figures = names_of(report_columns({}));
    datasets.push_back({"/frames/energy", real, {energies.size()}, energies});
    datasets.push_back({"/frames/report", real, {figures.size()}, figures});
    add_contact_datasets(model.kinematics, datasets);
    add_joint_datasets(joints, datasets);
    add_bar_datasets(model, datasets);
    return datasets;
}

std::vector<Rows> frame_rows(const Model& model, const SurfaceMesh& mesh, const std::vector<WatchedJoint>& joints,
                             const Rest& rest, const State& state, const RunReport& report,
                             std::int64_t& first_contact)
{
    const Vector3d ground = rest.foot.displacement(model, state);
    const std::vector<double> places = positions_of(mesh, model.kinematics, state);
    std::vector<Rows> rows = {{"/frames/time", std::vector<double>{state.time}},
                              {"/frames/step", std::vector<std::int64_t>{state.step}},
                              {"/frames/stage", std::vector<std::int32_t>{state.stage}},
                              {"/frames/coordinates", state.coordinates},
                              {"/frames/velocities", state.velocities},
                              {"/frames/ground_displacement", stored_vector(ground, model.kinematics)},
                              {"/frames/positions", std::vector<float>(places.begin(), places.end())},
                              {"/frames/face_displacement", face_displacements(model, mesh, rest, state)},
                              {"/frames/energy", values_of(energy_terms(report.energy))},
                              {"/frames/report", values_of(report_columns(report))}};
    if (is_deformable(model.kinematics)) add_stress_rows(model, mesh, state, rows);
    const std::vector<JointResultant> contacts = joint_resultants(model, state, EdgeStress::left_out);
    add_contact_rows(model.kinematics, contacts, first_contact, rows);
    add_joint_rows(joints, joints_now(model, joints, state, contacts), rows);
    add_bar_rows(model, state, rows);
    return rows;
}

}  // namespace voussoir::app::results
