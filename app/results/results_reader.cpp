#include "app/results/results_reader.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/recorded_checks.h"
#include "app/results/scene_vectors.h"
#include "app/results/settings.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

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
    return mesh;
}

/// The names and types of the stages, from the settings.
void read_stages(const Hdf5File& file, const std::string& place, RecordedModel& model)
{
    try {
        for (const auto& stage : nlohmann::json::parse(file.read_text("/case/settings"))) {
            model.stage_names.push_back(stage.at("name").get<std::string>());
            const bool is_dynamic = stage.at("type") == name_of(StageType::dynamic);
            model.stage_is_dynamic.push_back(is_dynamic);
            model.stage_moves.push_back(stage.value("moves", is_dynamic));
        }
    } catch (const nlohmann::json::exception&) {
        throw InputError(place, "settings that are no list of stages", "the file is damaged: run the case again");
    }
}

/// Values of a list that must have `count` of them for each of `blocks`.
std::vector<double> read_for_each(const Hdf5File& file, const std::string& name, std::size_t count,
                                  const std::string& place)
{
    std::vector<double> values = file.read<double>(name);
    if (values.size() == count) return values;
    throw InputError(place, name + " has " + std::to_string(values.size()) + " values",
                     "expected " + std::to_string(count) + ": the file is damaged, run the case again");
}

/// What they were at the start, without their patches.
std::vector<WatchedJoint> read_joints(const Hdf5File& file, Kinematics kinematics, const std::string& place)
{
    if (!file.has("/joints")) return {};
    const std::vector<std::int32_t> pairs = file.read<std::int32_t>("/joints/pair");
    const std::size_t count = pairs.size() / 2, dimension = axes_of(kinematics).size();
    const auto read = [&](const char* name, std::size_t each) {
        return read_for_each(file, std::string("/joints/") + name, each * count, place);
    };
    const std::vector<double> area = read("area", 1), facing = read("facing_area", 1),
                              centre = read("centre", dimension), normal = read("normal", dimension);
    std::vector<WatchedJoint> joints(count);
    for (std::size_t i = 0; i < count; ++i) {
        joints[i].block_a = pairs[2 * i];
        joints[i].block_b = pairs[2 * i + 1];
        joints[i].area = area[i];
        joints[i].facing_area = facing[i];
        joints[i].centre = vector_at(centre, i, kinematics);
        joints[i].normal = vector_at(normal, i, kinematics);
    }
    if (!file.has("/joints/bonded")) return joints;
    const std::vector<std::int32_t> bonded = file.read<std::int32_t>("/joints/bonded");
    for (std::size_t i = 0; i < std::min(count, bonded.size()); ++i) joints[i].bonded = bonded[i] != 0;
    return joints;
}

/// From the materials of the joints between the groups of blocks, and the factors of single blocks.
std::vector<JointBound> read_bounds(const Hdf5File& file, const RecordedModel& model, const std::string& place)
{
    if (model.joints.empty()) return {};
    const std::vector<std::int32_t> group = file.read<std::int32_t>("/model/block_group"),
                                    material = file.read<std::int32_t>("/model/joint_of_groups");
    const std::vector<double> angle = file.read<double>("/model/joint_materials/friction_angle"),
                              cohesion = file.read<double>("/model/joint_materials/cohesion");
    std::vector<double> factor(model.block_names.size(), 1.0);
    if (file.has("/model/friction_factor"))
        factor = read_for_each(file, "/model/friction_factor", factor.size(), place);
    const std::size_t groups = file.read_texts("/model/groups").size();
    std::vector<JointBound> bounds;
    for (const WatchedJoint& joint : model.joints) {
        const auto a = static_cast<std::size_t>(joint.block_a), b = static_cast<std::size_t>(joint.block_b);
        const bool known = std::max(a, b) < std::min(group.size(), factor.size());
        const std::size_t pair =
            known ? static_cast<std::size_t>(group[a]) * groups + static_cast<std::size_t>(group[b]) : 0;
        const std::size_t of = pair < material.size() ? static_cast<std::size_t>(material[pair]) : angle.size();
        if (!known || of >= std::min(angle.size(), cohesion.size()))
            throw InputError(place, "a joint without its material", "the file is damaged: run the case again");
        bounds.push_back({0.5 * (factor[a] + factor[b]) * std::tan(angle[of]), cohesion[of]});
    }
    return bounds;
}

std::vector<RecordedRod> read_rods(const Hdf5File& file, const RecordedModel& model, const std::string& place)
{
    if (!file.has("/model/bars")) return {};
    const std::vector<std::int32_t> blocks = file.read<std::int32_t>("/model/bars/blocks"),
                                    is_rod = file.read<std::int32_t>("/model/bars/is_rod");
    const std::size_t count = is_rod.size(), dimension = axes_of(model.kinematics).size();
    const std::vector<double> anchors = read_for_each(file, "/model/bars/anchors", 2 * dimension * count, place);
    const auto is_block = [&](std::int32_t block) {
        return block >= 0 && static_cast<std::size_t>(block) < model.block_names.size();
    };
    if (blocks.size() != 2 * count || !std::all_of(blocks.begin(), blocks.end(), is_block))
        throw InputError(place, "a bar without its blocks", "the file is damaged: run the case again");
    std::vector<RecordedRod> rods;
    for (std::size_t i = 0; i < count; ++i)
        if (is_rod[i] != 0)
            rods.push_back(
                {{blocks[2 * i], blocks[2 * i + 1]},
                 {vector_at(anchors, 2 * i, model.kinematics), vector_at(anchors, 2 * i + 1, model.kinematics)}});
    return rods;
}

RecordedModel read_model(const Hdf5File& file, const std::string& place)
{
    RecordedModel model;
    model.title = file.text_attribute("/", "title");
    model.version = file.text_attribute("/", "voussoir_version");
    model.kinematics = kinematics_named(file.text_attribute("/", "kinematics"));
    if (is_planar(model.kinematics)) model.thickness = file.number_attribute("/", "thickness_m");
    model.block_names = file.read_texts("/model/block_names");
    read_stages(file, place, model);
    const std::size_t dimension = axes_of(model.kinematics).size();
    const std::vector<double> centroids =
        read_for_each(file, "/model/centroid", dimension * model.block_names.size(), place);
    for (std::size_t b = 0; b < model.block_names.size(); ++b)
        model.centroids.push_back(vector_at(centroids, b, model.kinematics));
    if (file.has("/model/foundations")) model.foundations = file.read<std::int32_t>("/model/foundations/block");
    if (file.has("/model/soil")) {
        model.soil = file.read<std::int32_t>("/model/soil/block");
        model.foot = file.read<std::int32_t>("/model/soil/foot");
    }
    model.mesh = read_mesh(file);
    model.mesh.dimension = dimension_of(model.kinematics);
    model.joints = read_joints(file, model.kinematics, place);
    check_recorded(model, place);
    model.bounds = read_bounds(file, model, place);
    model.rods = read_rods(file, model, place);
    for (std::size_t b = 0; b + 1 < model.mesh.block_first_vertex.size(); ++b)
        model.mesh.vertex_block.resize(model.mesh.block_first_vertex[b + 1], static_cast<std::int32_t>(b));
    return model;
}

}  // namespace

Vector3d moved(const RecordedModel& model, const RecordedFrame& frame, int block)
{
    const Vector3d now = pose_of(model.kinematics, frame.state, block).centroid - frame.ground;
    if (!model.counts_from_rest(frame)) return now - model.centroids[block];
    return now - (pose_of(model.kinematics, model.rest.state, block).centroid - model.rest.foot);
}

Matrix3d map_since(const RecordedModel& model, const RecordedFrame& frame, int block)
{
    Matrix3d now = pose_of(model.kinematics, frame.state, block).map;
    if (!model.counts_from_rest(frame)) return now;
    return now * pose_of(model.kinematics, model.rest.state, block).map.inverse();
}

bool RecordedModel::counts_from_rest(const RecordedFrame& frame) const
{
    return frame.in_motion && !rest.state.coordinates.empty();
}

void begin_motion(RecordedFrame& frame)
{
    if (frame.in_motion) return;
    frame.in_motion = true;
    for (JointNow& joint : frame.joints) joint.motion = {};
}

std::string counted_from(const RecordedModel& model, bool in_motion)
{
    const std::string since =
        in_motion && !model.rest.state.coordinates.empty() ? "since the motion began" : "since the start";
    if (!model.foot.empty()) return since + ", relative to the stones that stand on the soil";
    return since + (model.foundations.empty() ? "" : ", relative to the supports");
}

ResultsReader::ResultsReader(const std::filesystem::path& path)
    : file_(Hdf5File::open(path)), place_(path.string())
{
    if (file_.text_attribute("/", "format") != "voussoir results 2") {
        throw InputError(place_, "results in the format \"" + file_.text_attribute("/", "format") + "\"",
                         "give a results file of this version of voussoir");
    }
    model = read_model(file_, place_);
    const std::int64_t count = one<std::int64_t>("/frames/count", 0);
    if (count < 0) throw InputError(place_, std::to_string(count) + " frames", "the file is damaged");
    times = rows<double>("/frames/time", 0, count, 1);
    stages = rows<std::int32_t>("/frames/stage", 0, count, 1);
    const auto first = std::find_if(stages.begin(), stages.end(), [&](int stage) { return has_moved(stage); });
    if (first == stages.begin()) return;
    const RecordedFrame last = frame(static_cast<std::size_t>(first - stages.begin()) - 1);
    model.rest = {last.state, last.ground, last.joints};
}

bool ResultsReader::has_moved(int stage) const
{
    const std::vector<bool>& moves = model.stage_moves;
    const auto first = std::find(moves.begin(), moves.end(), true) - moves.begin();
    return first <= stage && first < static_cast<std::ptrdiff_t>(moves.size());
}

template <typename T>
std::vector<T> ResultsReader::rows(const std::string& name, std::int64_t first, std::int64_t count,
                                   std::size_t columns) const
{
    std::vector<T> values;
    if (first >= 0 && count >= 0)
        values = file_.read_rows<T>(name, static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(count));
    if (first >= 0 && count >= 0 && values.size() == columns * static_cast<std::size_t>(count)) return values;
    throw InputError(place_, name + " does not have the expected " + std::to_string(columns) + " columns and rows",
                     "the file is damaged: run the case again");
}

template <typename T>
T ResultsReader::one(const std::string& name, std::size_t row) const
{
    return rows<T>(name, static_cast<std::int64_t>(row), 1, 1)[0];
}

RecordedFrame ResultsReader::frame(std::size_t index) const
{
    const auto row = static_cast<std::int64_t>(index);
    const std::size_t blocks = model.block_names.size(), dimension = axes_of(model.kinematics).size();
    RecordedFrame frame;
    frame.time = one<double>("/frames/time", index);
    frame.step = one<std::int64_t>("/frames/step", index);
    frame.stage = one<std::int32_t>("/frames/stage", index);
    frame.in_motion = has_moved(frame.stage);
    frame.state.time = frame.time;
    frame.state.step = frame.step;
    frame.state.stage = frame.stage;
    frame.state.coordinates = rows<double>(
        "/frames/coordinates", row, 1, blocks * static_cast<std::size_t>(coordinates_per_block(model.kinematics)));
    frame.state.velocities = rows<double>("/frames/velocities", row, 1,
                                          blocks * static_cast<std::size_t>(unknowns_per_block(model.kinematics)));
    frame.ground = vector_at(rows<double>("/frames/ground_displacement", row, 1, dimension), 0, model.kinematics);
    if (is_deformable(model.kinematics)) frame.stresses = stresses(index);
    frame.joints = joints(index);
    if (frame.in_motion)
        for (std::size_t i = 0; i < model.rest.joints.size(); ++i)
            frame.joints[i].motion = since(model.rest.joints[i].motion, frame.joints[i].motion);
    frame.contacts = contacts(index);
    check_recorded(frame, model, place_);
    return frame;
}

std::vector<Matrix3d> ResultsReader::stresses(std::size_t frame) const
{
    const std::vector<std::string> names = file_.texts_attribute("/frames/stress", "columns");
    const auto is_component = [](const std::string& name) {
        return name.size() == 2 && name.find_first_not_of("xyz") == std::string::npos;
    };
    if (names.empty() || !std::all_of(names.begin(), names.end(), is_component))
        throw InputError(place_, "stresses without the names of their components", "the file is damaged");
    const std::vector<double> values = rows<double>("/frames/stress", static_cast<std::int64_t>(frame), 1,
                                                    model.block_names.size() * names.size());
    std::vector<Matrix3d> stresses;
    for (std::size_t i = 0; i < values.size(); i += names.size())
        stresses.push_back(tensor_of(names, values.data() + i));
    return stresses;
}

std::vector<JointNow> ResultsReader::joints(std::size_t frame) const
{
    std::vector<JointNow> joints(model.joints.size());
    if (joints.empty()) return joints;
    const auto read = [&](const char* name, const auto& put) {
        const std::vector<float> values =
            rows<float>(std::string("/frames/joints/") + name, static_cast<std::int64_t>(frame), 1, joints.size());
        for (std::size_t i = 0; i < joints.size(); ++i) put(joints[i]) = static_cast<double>(values[i]);
    };
    read("opening", [](JointNow& joint) -> double& { return joint.motion.opening; });
    read("mean_opening", [](JointNow& joint) -> double& { return joint.motion.mean_opening; });
    read("slip", [](JointNow& joint) -> double& { return joint.motion.slip; });
    read("largest_slip", [](JointNow& joint) -> double& { return joint.motion.largest_slip; });
    read("normal_force", [](JointNow& joint) -> double& { return joint.normal_force; });
    read("shear_force", [](JointNow& joint) -> double& { return joint.shear_force; });
    read("eccentricity", [](JointNow& joint) -> double& { return joint.eccentricity; });
    read("area_in_use", [](JointNow& joint) -> double& { return joint.area_in_use; });
    if (!file_.has("/frames/joints/broken")) return joints;
    const auto broken =
        rows<std::int32_t>("/frames/joints/broken", static_cast<std::int64_t>(frame), 1, joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) joints[i].broken = broken[i] != 0;
    return joints;
}

std::vector<JointResultant> ResultsReader::contacts(std::size_t frame) const
{
    const auto span = rows<std::int64_t>("/frames/contacts/rows", static_cast<std::int64_t>(frame), 1, 2);
    const std::size_t dimension = axes_of(model.kinematics).size();
    const auto read = [&](const char* name, std::size_t columns) {
        return rows<double>(std::string("/frames/contacts/") + name, span[0], span[1], columns);
    };
    const auto pair = rows<std::int32_t>("/frames/contacts/pair", span[0], span[1], 2);
    const std::vector<double> force = read("force", dimension),
                              moment = read("moment", is_planar(model.kinematics) ? 1 : dimension),
                              centre = read("centre", dimension), pressure = read("pressure_centre", dimension),
                              normal = read("normal", dimension), normal_force = read("normal_force", 1),
                              area = read("area", 1), closed = read("closed_area", 1);
    std::vector<JointResultant> contacts(static_cast<std::size_t>(span[1]));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        JointResultant& contact = contacts[i];
        contact.block_a = pair[2 * i];
        contact.block_b = pair[2 * i + 1];
        contact.force = vector_at(force, i, model.kinematics);
        contact.moment = moment_at(moment, i, model.kinematics);
        contact.centre = vector_at(centre, i, model.kinematics);
        contact.pressure_centre = vector_at(pressure, i, model.kinematics);
        contact.normal = vector_at(normal, i, model.kinematics);
        contact.normal_force = normal_force[i];
        contact.area = area[i];
        contact.closed_area = closed[i];
    }
    return contacts;
}

}  // namespace voussoir::app::results
