#include "app/report/interactive_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/render/extrusion.h"
#include "app/render/joint_faces.h"
#include "app/report/base64.h"
#include "app/report/view_frames.h"
#include "importers/process/child_process.h"

namespace voussoir::app::report
{
namespace
{

using Eigen::Vector3d;
using Json = nlohmann::json;

// A page of 15 MB has room for these, a film, pictures, the script and 500 stones.
constexpr std::size_t most_bytes = 2250000;  // of all frames
constexpr std::size_t most_mesh_bytes = 6000000;
constexpr std::size_t most_frames = 150;

struct Meshes {
    std::vector<float> centroids, levers;  // m, about the middle of the scene
    std::vector<std::uint32_t> vertex_block, triangles, edges;
    std::vector<std::uint32_t> outline_first = {0}, outlines;  // of the joints, as edges

    std::size_t bytes() const
    {
        return 4 * (centroids.size() + levers.size() + vertex_block.size() + triangles.size() + edges.size() +
                    outlines.size());
    }
};

void add_vector(const Vector3d& vector, std::vector<float>& values)
{
    for (const double value : vector) values.push_back(static_cast<float>(value));
}

void add_faces(const results::SurfaceMesh& mesh, Meshes& meshes)
{
    for (std::size_t face = 0; face < mesh.face_block.size(); ++face) {
        const std::int32_t* loop = mesh.face_vertices.data() + mesh.face_first[face];
        const int corners = mesh.face_first[face + 1] - mesh.face_first[face];
        const auto corner = [&](int i) { return static_cast<std::uint32_t>(loop[i % corners]); };
        for (int i = 0; i < corners; ++i)
            if (corner(i) < corner(i + 1))  // the face beyond has it the other way round
                meshes.edges.insert(meshes.edges.end(), {corner(i), corner(i + 1)});
        for (int i = 1; i + 1 < corners; ++i)
            meshes.triangles.insert(meshes.triangles.end(), {corner(0), corner(i), corner(i + 1)});
    }
}

void add_outlines(const results::RecordedModel& model, Meshes& meshes)
{
    const results::SurfaceMesh& mesh = model.mesh;
    std::vector<Vector3d> places;
    places.reserve(mesh.vertex_block.size());
    for (std::size_t v = 0; v < mesh.vertex_block.size(); ++v)
        places.push_back(model.centroids[static_cast<std::size_t>(mesh.vertex_block[v])] +
                         Vector3d(mesh.levers.data() + 3 * v));
    for (const WatchedJoint& joint : model.joints) {
        for (const int face : render::faces_of_joint(mesh, places, joint)) {
            const int first = mesh.face_first[static_cast<std::size_t>(face)],
                      end = mesh.face_first[static_cast<std::size_t>(face) + 1];
            for (int i = first; i < end; ++i)
                for (const int k : {i, i + 1 < end ? i + 1 : first})
                    meshes.outlines.push_back(
                        static_cast<std::uint32_t>(mesh.face_vertices[static_cast<std::size_t>(k)]));
        }
        meshes.outline_first.push_back(static_cast<std::uint32_t>(meshes.outlines.size()));
    }
}

Meshes meshes_of(const results::RecordedModel& model)
{
    Meshes meshes;
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& centroid : model.centroids)
        middle += centroid / static_cast<double>(model.centroids.size());
    for (const Vector3d& centroid : model.centroids) add_vector(centroid - middle, meshes.centroids);
    meshes.levers.assign(model.mesh.levers.begin(), model.mesh.levers.end());
    meshes.vertex_block.assign(model.mesh.vertex_block.begin(), model.mesh.vertex_block.end());
    add_faces(model.mesh, meshes);
    add_outlines(model, meshes);
    return meshes;
}

void put_model(const RunRecord& record, const results::RecordedModel& model, const Meshes& meshes, Json& data)
{
    const std::vector<bool> marks = foundation_marks(model);
    data["names"] = model.block_names;
    data["counted_from"] = results::counted_from(model);
    data["groups"] = record.groups;
    data["group_of"] = packed(std::vector<std::uint32_t>(record.block_group.begin(), record.block_group.end()));
    data["foundation"] = packed(std::vector<std::uint32_t>(marks.begin(), marks.end()));
    data["planar"] = is_planar(model.kinematics);
    std::vector<std::uint32_t> pairs;
    pairs.reserve(2 * model.joints.size());
    for (const WatchedJoint& joint : model.joints)
        for (const int block : {joint.block_a, joint.block_b}) pairs.push_back(static_cast<std::uint32_t>(block));
    data["joints"] = packed(pairs);
    data["centroids"] = packed(meshes.centroids);
    data["levers"] = packed(meshes.levers);
    data["vertex_block"] = packed(meshes.vertex_block);
    data["triangles"] = packed(meshes.triangles);
    data["edges"] = packed(meshes.edges);
    data["outline_first"] = packed(meshes.outline_first);
    data["outlines"] = packed(meshes.outlines);
}

/// In a page nothing in a text may end the element that holds it.
std::string safe_in_a_page(const std::string& json)
{
    std::string safe;
    safe.reserve(json.size());
    for (const char c : json) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    return safe;
}

}  // namespace

std::vector<std::size_t> kept_frames(std::size_t count, std::size_t most, std::size_t wanted)
{
    std::vector<std::size_t> kept;
    if (count == 0 || most == 0) return kept;
    kept.reserve(most + 2);
    const std::size_t even = std::min(count, std::max<std::size_t>(most, 2));
    for (std::size_t i = 0; i < even; ++i) kept.push_back(even > 1 ? i * (count - 1) / (even - 1) : 0);
    if (wanted < count && std::find(kept.begin(), kept.end(), wanted) == kept.end()) kept.push_back(wanted);
    std::sort(kept.begin(), kept.end());
    return kept;
}

ViewScript view_script()
{
    std::ifstream stream(importers::process::helper_folder() / "voussoir-viewer.js", std::ios::binary);
    ViewScript script;
    std::getline(stream, script.hash);
    script.text.assign(std::istreambuf_iterator<char>(stream), {});
    return script;
}

std::string view_data(const RunRecord& record, double magnification)
{
    const results::RecordedModel model = render::in_space(record.results.model);
    const Meshes meshes = meshes_of(model);
    const std::size_t each = bytes_of_a_frame(model);
    if (meshes.bytes() > most_mesh_bytes || 3 * each > most_bytes) return "";
    ViewFrames frames;
    for (const std::size_t frame : kept_frames(
             record.results.times.size(), std::min(most_frames, most_bytes / std::max<std::size_t>(each, 1) - 1),
             record.mechanism.frame))
        add_frame(model, record.results.frame(frame), frames);
    Json data = Json::parse(frames_as_json(frames));
    put_model(record, model, meshes, data);
    data["magnification"] = magnification;
    data["threshold_m"] = noteworthy_opening;
    return safe_in_a_page(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace voussoir::app::report
