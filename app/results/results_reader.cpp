#include "app/results/results_reader.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/results/scene_vectors.h"
#include "app/results/settings.h"
#include "libdda/errors.h"

namespace voussoir
{

using Eigen::Matrix3d;

namespace
{

Kinematics kinematics_named(const std::string& name)
{
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::spatial_rigid,
                                        Kinematics::planar_deformable, Kinematics::planar_rigid})
        if (name == name_of(kinematics)) return kinematics;
    throw InputError("results", "the kinematics \"" + name + "\"",
                     "give a results file of this version of voussoir");
}

SurfaceMesh read_mesh(const Hdf5File& file)
{
    SurfaceMesh mesh;
    mesh.levers = file.read<double>("/model/mesh/levers");
    mesh.block_first_vertex = file.read<std::int32_t>("/model/mesh/block_first_vertex");
    mesh.face_first = file.read<std::int32_t>("/model/mesh/face_first");
    mesh.face_vertices = file.read<std::int32_t>("/model/mesh/face_vertices");
    mesh.face_block = file.read<std::int32_t>("/model/mesh/face_block");
    mesh.face_part = file.read<std::int32_t>("/model/mesh/face_part");
    for (std::size_t b = 0; b + 1 < mesh.block_first_vertex.size(); ++b) {
        mesh.vertex_block.resize(mesh.block_first_vertex[b + 1], static_cast<std::int32_t>(b));
    }
    return mesh;
}

RecordedModel read_model(const Hdf5File& file)
{
    RecordedModel model;
    model.title = file.text_attribute("/", "title");
    model.version = file.text_attribute("/", "voussoir_version");
    model.kinematics = kinematics_named(file.text_attribute("/", "kinematics"));
    if (is_planar(model.kinematics)) model.thickness = file.number_attribute("/", "thickness_m");
    model.block_names = file.read_texts("/model/block_names");
    for (const auto& stage : nlohmann::json::parse(file.read_text("/case/settings"))) {
        model.stage_names.push_back(stage.at("name").get<std::string>());
        model.stage_is_dynamic.push_back(stage.at("type") == name_of(StageType::dynamic));
    }
    const std::vector<double> centroids = file.read<double>("/model/centroid");
    for (std::size_t b = 0; b < model.block_names.size(); ++b)
        model.centroids.push_back(vector_at(centroids, b, model.kinematics));
    if (file.has("/model/foundations")) model.foundations = file.read<std::int32_t>("/model/foundations/block");
    model.mesh = read_mesh(file);
    model.mesh.dimension = dimension_of(model.kinematics);
    return model;
}

}  // namespace

ResultsReader::ResultsReader(const std::filesystem::path& path) : file_(Hdf5File::open(path))
{
    if (file_.text_attribute("/", "format") != "voussoir results 1") {
        throw InputError(path.string(), "results in the format \"" + file_.text_attribute("/", "format") + "\"",
                         "give a results file of this version of voussoir");
    }
    model = read_model(file_);
    const auto count = static_cast<std::uint64_t>(file_.read<std::int64_t>("/frames/count").at(0));
    times = file_.read_rows<double>("/frames/time", 0, count);
    stages = file_.read_rows<std::int32_t>("/frames/stage", 0, count);
}

RecordedFrame ResultsReader::frame(std::size_t index) const
{
    RecordedFrame frame;
    frame.time = file_.read_rows<double>("/frames/time", index, 1)[0];
    frame.step = file_.read_rows<std::int64_t>("/frames/step", index, 1)[0];
    frame.stage = file_.read_rows<std::int32_t>("/frames/stage", index, 1)[0];
    frame.state.time = frame.time;
    frame.state.step = frame.step;
    frame.state.stage = frame.stage;
    frame.state.coordinates = file_.read_rows<double>("/frames/coordinates", index, 1);
    frame.state.velocities = file_.read_rows<double>("/frames/velocities", index, 1);
    frame.ground =
        vector_at(file_.read_rows<double>("/frames/ground_displacement", index, 1), 0, model.kinematics);
    if (is_deformable(model.kinematics)) frame.stresses = stresses(index);
    frame.joints = joints(index);
    return frame;
}

std::vector<Matrix3d> ResultsReader::stresses(std::size_t frame) const
{
    const std::vector<std::string> names = file_.texts_attribute("/frames/stress", "columns");
    const std::vector<double> rows = file_.read_rows<double>("/frames/stress", frame, 1);
    std::vector<Matrix3d> stresses;
    for (std::size_t i = 0; i < rows.size(); i += names.size())
        stresses.push_back(tensor_of(names, rows.data() + i));
    return stresses;
}

std::vector<JointResultant> ResultsReader::joints(std::size_t frame) const
{
    const auto rows = file_.read_rows<std::int64_t>("/frames/joints/rows", frame, 1);
    const auto read = [&](const char* name) {
        return file_.read_rows<double>(std::string("/frames/joints/") + name, rows[0], rows[1]);
    };
    const auto pair = file_.read_rows<std::int32_t>("/frames/joints/pair", rows[0], rows[1]);
    const std::vector<double> force = read("force"), moment = read("moment"), centre = read("centre"),
                              pressure = read("pressure_centre"), normal = read("normal"),
                              normal_force = read("normal_force"), opening = read("opening"), slip = read("slip"),
                              area = read("area"), closed = read("closed_area");
    std::vector<JointResultant> joints(static_cast<std::size_t>(rows[1]));
    for (std::size_t i = 0; i < joints.size(); ++i) {
        JointResultant& joint = joints[i];
        joint.block_a = pair[2 * i];
        joint.block_b = pair[2 * i + 1];
        joint.force = vector_at(force, i, model.kinematics);
        joint.moment = moment_at(moment, i, model.kinematics);
        joint.centre = vector_at(centre, i, model.kinematics);
        joint.pressure_centre = vector_at(pressure, i, model.kinematics);
        joint.normal = vector_at(normal, i, model.kinematics);
        joint.normal_force = normal_force[i];
        joint.max_opening = opening[i];
        joint.slip = slip[i];
        joint.area = area[i];
        joint.closed_area = closed[i];
    }
    return joints;
}

}  // namespace voussoir
