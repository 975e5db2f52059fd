#include "app/report/geometry_table.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "app/render/extrusion.h"
#include "app/report/sections.h"

namespace voussoir::app::report
{
namespace
{

using Eigen::Vector3d;

constexpr double partial = 0.25;  // of the area that faces another stone: less is an edge that touches, not a face

Vector3d place(const results::RecordedModel& model, std::int32_t vertex)
{
    return model.centroids[static_cast<std::size_t>(model.mesh.vertex_block[static_cast<std::size_t>(vertex)])] +
           Vector3d(model.mesh.levers.data() + 3 * static_cast<std::size_t>(vertex));
}

/// The corners of a face one after the other, and again the first.
std::vector<std::int32_t> loop_of(const results::SurfaceMesh& mesh, std::size_t face)
{
    std::vector<std::int32_t> loop(mesh.face_vertices.begin() + mesh.face_first[face],
                                   mesh.face_vertices.begin() + mesh.face_first[face + 1]);
    if (!loop.empty()) loop.push_back(loop.front());
    return loop;
}

/// Stones with an edge that not two faces run along, once each way.
std::vector<bool> open_surfaces(const results::RecordedModel& model)
{
    std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
    for (std::size_t face = 0; face < model.mesh.face_block.size(); ++face) {
        const std::vector<std::int32_t> loop = loop_of(model.mesh, face);
        for (std::size_t i = 0; i + 1 < loop.size(); ++i) ++edges[{loop[i], loop[i + 1]}];
    }
    std::vector<bool> open(model.block_names.size(), false);
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (count != 1 || back == edges.end() || back->second != 1)
            open[static_cast<std::size_t>(model.mesh.vertex_block[static_cast<std::size_t>(edge.first)])] = true;
    }
    return open;
}

/// What the surface of each stone encloses [m3], by the divergence theorem.
std::vector<double> enclosed_volumes(const results::RecordedModel& model)
{
    std::vector<double> volumes(model.block_names.size(), 0);
    for (std::size_t face = 0; face < model.mesh.face_block.size(); ++face) {
        const auto block = static_cast<std::size_t>(model.mesh.face_block[face]);
        const std::vector<std::int32_t> loop = loop_of(model.mesh, face);
        const auto lever = [&](std::size_t i) -> Vector3d {
            return place(model, loop[i]) - model.centroids[block];
        };
        for (std::size_t i = 1; i + 2 < loop.size(); ++i)
            volumes[block] += lever(0).dot(lever(i).cross(lever(i + 1))) / 6;
    }
    return volumes;
}

/// Stones that joints connect with a foundation, through others too.
std::vector<bool> held_stones(const results::RecordedModel& model)
{
    std::vector<bool> held = foundation_marks(model);
    for (bool more = true; more;) {
        more = false;
        for (const WatchedJoint& joint : model.joints)
            if (held[static_cast<std::size_t>(joint.block_a)] != held[static_cast<std::size_t>(joint.block_b)])
                held[static_cast<std::size_t>(joint.block_a)] = held[static_cast<std::size_t>(joint.block_b)] =
                    more = true;
    }
    return held;
}

/// "3", and the first of their names.
std::vector<std::string> counted(const std::string& what, const std::vector<std::string>& names)
{
    std::string some;
    for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 3); ++i)
        some += (i > 0 ? ", " : "") + names[i];
    return {what, std::to_string(names.size()), names.size() > 3 ? some + ", ..." : some};
}

std::vector<std::string> names_where(const results::RecordedModel& model, const std::vector<bool>& marked)
{
    std::vector<std::string> names;
    for (std::size_t b = 0; b < marked.size(); ++b)
        if (marked[b]) names.push_back(model.block_names[b]);
    return names;
}

void add_sizes(const RunRecord& record, const results::RecordedModel& model, Table& table)
{
    const std::vector<bool> foundation = foundation_marks(model);
    Eigen::AlignedBox3d box;
    for (std::size_t v = 0; v < model.mesh.vertex_block.size(); ++v)
        if (!foundation[static_cast<std::size_t>(model.mesh.vertex_block[v])])
            box.extend(place(model, static_cast<std::int32_t>(v)));
    if (box.isEmpty()) return;
    table.rows.push_back(
        {"extent of the structure along x, y, z [m]",
         fmt::format("{} x {} x {}", figure(box.sizes().x()), figure(box.sizes().y()), figure(box.sizes().z())),
         "without the foundations"});
    std::vector<std::size_t> stones;
    for (std::size_t b = 0; b < foundation.size(); ++b)
        if (!foundation[b]) stones.push_back(b);
    const auto [least, most] =
        std::minmax_element(stones.begin(), stones.end(),
                            [&](std::size_t a, std::size_t b) { return record.volume[a] < record.volume[b]; });
    table.rows.push_back({"smallest stone [m3]", figure(record.volume[*least]), model.block_names[*least]});
    table.rows.push_back({"largest stone [m3]", figure(record.volume[*most]), model.block_names[*most]});
}

void add_surfaces(const RunRecord& record, const results::RecordedModel& model, Table& table)
{
    table.rows.push_back(counted("stones whose surface is not closed", names_where(model, open_surfaces(model))));
    const std::vector<double> enclosed = enclosed_volumes(model);
    double most = 0;
    std::string where;
    for (std::size_t b = 0; b < enclosed.size(); ++b) {
        const double share = std::abs(enclosed[b] - record.volume[b]) / record.volume[b];
        if (!(share > std::max(most, 1e-9))) continue;
        most = share;
        where = model.block_names[b];
    }
    table.rows.push_back({"largest difference between what a surface encloses and the volume computed with [%]",
                          figure(100 * most), where});
}

void add_joints(const RunRecord& record, const results::RecordedModel& model, Table& table)
{
    const std::vector<WatchedJoint>& joints = model.joints;
    const double area = std::accumulate(record.joint_area.begin(), record.joint_area.end(), 0.0);
    table.rows.push_back({"joints, and their contact area [m2]", std::to_string(joints.size()), figure(area)});
    std::vector<std::string> edges;
    std::vector<bool> without(model.block_names.size(), true);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const auto a = static_cast<std::size_t>(joints[i].block_a),
                   b = static_cast<std::size_t>(joints[i].block_b);
        without[a] = without[b] = false;
        if (record.joint_area[i] < partial * record.joint_facing_area[i])
            edges.push_back(model.block_names[a] + " and " + model.block_names[b]);
    }
    table.rows.push_back(counted("joints that touch on less than a quarter of what faces the other stone", edges));
    table.rows.push_back(counted("blocks without a joint at the start", names_where(model, without)));
    std::vector<bool> loose = held_stones(model);
    loose.flip();
    table.rows.push_back(
        counted("stones that no chain of joints connects with a foundation", names_where(model, loose)));
}

}  // namespace

Table geometry_table(const RunRecord& record)
{
    Table table{"geometry", "Geometry, as computed with", {"quantity", "value", "where"}, {}};
    const results::RecordedModel model = render::in_space(record.results.model);
    add_sizes(record, model, table);
    add_surfaces(record, model, table);
    add_joints(record, model, table);
    return table;
}

}  // namespace voussoir::app::report
