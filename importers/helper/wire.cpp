#include "importers/helper/wire.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "importers/helper/wire_index.h"
#include "libdda/errors.h"

namespace voussoir::importers::helper
{

using nlohmann::json;

namespace
{

constexpr double largest_planarity_tolerance =
    1e-2;  // what a user may allow at most; the helper has judged by his

/// Names that are not UTF-8 get replacement characters; nothing else can fail.
std::string dump(const json& value)
{
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json to_json_value(const Eigen::Vector3d& x)
{
    return json::array({x.x(), x.y(), x.z()});
}

Eigen::Vector3d vector_from(const json& value)
{
    const auto numbers = value.get<std::array<double, 3>>();
    return {numbers[0], numbers[1], numbers[2]};
}

json to_json_value(const std::vector<Eigen::Vector3d>& points)
{
    json value = json::array();
    for (const Eigen::Vector3d& x : points) value.push_back(to_json_value(x));
    return value;
}

std::vector<Eigen::Vector3d> points_from(const json& value)
{
    std::vector<Eigen::Vector3d> points;
    for (const json& x : value) points.push_back(vector_from(x));
    return points;
}

std::vector<std::vector<int>> loops_from(const json& value)
{
    std::vector<std::vector<int>> loops;
    for (const json& loop : value) {
        loops.emplace_back();
        for (const json& corner : loop) loops.back().push_back(index_from(corner));
    }
    return loops;
}

json to_json_value(const ConvexPolyhedron& part)
{
    return {{"vertices", to_json_value(part.vertices)}, {"faces", part.faces}, {"glued", part.glued}};
}

ConvexPolyhedron part_from(const json& value, const std::string& name)
{
    ConvexPolyhedron part = make_convex_polyhedron(
        points_from(value.at("vertices")), loops_from(value.at("faces")), name, largest_planarity_tolerance);
    part.glued = value.at("glued").get<std::vector<bool>>();
    if (!part.glued.empty() && part.glued.size() != part.faces.size())
        throw InputError(name, "marks of glued faces do not fit the faces", "one mark a face");
    return part;
}

json to_json_value(const Moments& moments)
{
    json second = json::array();
    for (int k = 0; k < 3; ++k) second.push_back(to_json_value(Eigen::Vector3d(moments.second.col(k))));
    return {{"volume", moments.volume}, {"centroid", to_json_value(moments.centroid)}, {"second", second}};
}

Moments moments_from(const json& value)
{
    Moments moments{value.at("volume"), vector_from(value.at("centroid")), Eigen::Matrix3d::Zero()};
    for (int k = 0; k < 3; ++k) moments.second.col(k) = vector_from(value.at("second").at(k));
    return moments;
}

json to_json_value(const mesh::MarkedFeature& feature)
{
    json lines = json::array(), polygons = json::array();
    for (const auto& [from, to] : feature.lines) lines.push_back({to_json_value(from), to_json_value(to)});
    for (const std::vector<Eigen::Vector3d>& polygon : feature.polygons)
        polygons.push_back(to_json_value(polygon));
    return {{"label", feature.label},
            {"points", to_json_value(feature.points)},
            {"lines", std::move(lines)},
            {"polygons", std::move(polygons)}};
}

mesh::MarkedFeature feature_from(const json& value)
{
    mesh::MarkedFeature feature{value.at("label"), points_from(value.at("points")), {}, {}};
    for (const json& line : value.at("lines"))
        feature.lines.push_back({vector_from(line.at(0)), vector_from(line.at(1))});
    for (const json& polygon : value.at("polygons")) feature.polygons.push_back(points_from(polygon));
    return feature;
}

json to_json_value(const std::vector<mesh::Repair>& repairs)
{
    json value = json::array();
    for (const mesh::Repair& repair : repairs)
        value.push_back({{"kind", repair.kind},
                         {"text", repair.text},
                         {"count", repair.count},
                         {"counted", repair.counted},
                         {"worst", repair.worst},
                         {"unit", repair.unit}});
    return value;
}

std::vector<mesh::Repair> repairs_from(const json& value)
{
    std::vector<mesh::Repair> repairs;
    for (const json& repair : value)
        repairs.push_back({repair.at("kind"), repair.at("text"), index_from(repair.at("count")),
                           repair.at("counted"), repair.at("worst"), repair.at("unit")});
    return repairs;
}

json to_json_value(const Stone& stone)
{
    json parts = json::array();
    for (const ConvexPolyhedron& part : stone.parts) parts.push_back(to_json_value(part));
    json features = json::array();
    for (const mesh::MarkedFeature& feature : stone.features) features.push_back(to_json_value(feature));
    return {{"name", stone.name},
            {"closed", stone.closed},
            {"convex", stone.convex},
            {"reason", stone.reason},
            {"cure", stone.cure},
            {"repairs", to_json_value(stone.repairs)},
            {"parts", std::move(parts)},
            {"moments", to_json_value(stone.moments)},
            {"volume_error", stone.volume_error},
            {"fit_move", stone.fit_move},
            {"fit_volume_change", stone.fit_volume_change},
            {"features", std::move(features)},
            {"vertices", to_json_value(stone.vertices)},
            {"faces", stone.faces}};
}

/// @throws InputError when figures of a stone are none, or its picture names corners that are not there
void check(const Stone& stone)
{
    const auto require = [&](bool holds, const char* found) {
        if (!holds) throw InputError(stone.name, found, "the answer was damaged on the way");
    };
    const Moments& moments = stone.moments;
    require(std::isfinite(moments.volume) && moments.centroid.allFinite() && moments.second.allFinite(),
            "moments that are no numbers");
    require(!stone.reason.empty() || (moments.volume > 0 && !stone.parts.empty()), "a stone without volume");
    const auto is_vertex = [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < stone.vertices.size(); };
    for (const std::vector<int>& face : stone.faces)
        require(std::all_of(face.begin(), face.end(), is_vertex), "a face with a corner that is not there");
}

Stone stone_from(const json& value)
{
    Stone stone;
    stone.name = value.at("name");
    stone.closed = value.at("closed");
    stone.convex = value.at("convex");
    stone.reason = value.at("reason");
    stone.cure = value.at("cure");
    stone.repairs = repairs_from(value.at("repairs"));
    for (const json& part : value.at("parts")) stone.parts.push_back(part_from(part, stone.name));
    stone.moments = moments_from(value.at("moments"));
    stone.volume_error = value.at("volume_error");
    stone.fit_move = value.at("fit_move");
    stone.fit_volume_change = value.at("fit_volume_change");
    for (const json& feature : value.at("features")) stone.features.push_back(feature_from(feature));
    stone.vertices = points_from(value.at("vertices"));
    stone.faces = loops_from(value.at("faces"));
    check(stone);
    return stone;
}

json to_json_value(const ImportedMesh& mesh)
{
    json stones = json::array();
    for (const Stone& stone : mesh.stones) stones.push_back(to_json_value(stone));
    json skipped = json::array(), unmatched = json::array();
    for (const SkippedStone& stone : mesh.skipped) skipped.push_back({stone.name, stone.why});
    for (const UnmatchedPattern& pattern : mesh.unmatched) unmatched.push_back({pattern.key, pattern.pattern});
    return {{"file", mesh.file},
            {"accepted", mesh.accepted},
            {"reason", mesh.reason},
            {"metres_per_unit", mesh.metres_per_unit},
            {"unit_from", mesh.unit_from},
            {"repairs", to_json_value(mesh.repairs)},
            {"stones", std::move(stones)},
            {"skipped", std::move(skipped)},
            {"unmatched", std::move(unmatched)}};
}

ImportedMesh mesh_from(const json& value)
{
    ImportedMesh mesh;
    mesh.file = value.at("file");
    mesh.accepted = value.at("accepted");
    mesh.reason = value.at("reason");
    mesh.metres_per_unit = value.at("metres_per_unit");
    if (!(mesh.metres_per_unit > 0)) throw InputError(mesh.file, "a unit without length", "must be > 0 m");
    mesh.unit_from = value.at("unit_from");
    mesh.repairs = repairs_from(value.at("repairs"));
    for (const json& stone : value.at("stones")) mesh.stones.push_back(stone_from(stone));
    for (const json& stone : value.at("skipped")) mesh.skipped.push_back({stone.at(0), stone.at(1)});
    for (const json& pattern : value.at("unmatched")) mesh.unmatched.push_back({pattern.at(0), pattern.at(1)});
    return mesh;
}

}  // namespace

std::string formats_request()
{
    return R"({"formats":true})";
}

std::string to_json(const std::vector<mesh::MeshFormat>& formats)
{
    json list = json::array();
    for (const mesh::MeshFormat& format : formats)
        list.push_back({{"name", format.name},
                        {"extensions", format.extensions},
                        {"reader", format.own ? "voussoir" : "assimp"},
                        {"lost", format.lost}});
    return dump(list);
}

std::vector<mesh::MeshFormat> formats_from_json(const std::string& text)
{
    std::vector<mesh::MeshFormat> formats;
    for (const json& format : json::parse(text))
        formats.push_back({format.at("name"), format.at("extensions").get<std::vector<std::string>>(),
                           format.at("reader").get<std::string>() == "voussoir", format.at("lost")});
    return formats;
}

std::string to_json(const Geometry& geometry)
{
    json meshes = json::array(), overlaps = json::array();
    for (const ImportedMesh& mesh : geometry.meshes) meshes.push_back(to_json_value(mesh));
    for (const Overlap& overlap : geometry.overlaps)
        overlaps.push_back({{"a", overlap.stone_a},
                            {"b", overlap.stone_b},
                            {"volume", overlap.volume},
                            {"fraction", overlap.fraction}});
    const json fit = {{"joints", geometry.fit.joints},
                      {"left", geometry.fit.left},
                      {"misfit_before", geometry.fit.misfit_before},
                      {"misfit_after", geometry.fit.misfit_after}};
    return dump({{"origin", to_json_value(geometry.origin)},
                 {"fit", fit},
                 {"meshes", std::move(meshes)},
                 {"overlaps", std::move(overlaps)}});
}

Geometry geometry_from_json(const std::string& text)
{
    const json value = json::parse(text);
    Geometry geometry;
    geometry.origin = vector_from(value.at("origin"));
    for (const json& mesh : value.at("meshes")) geometry.meshes.push_back(mesh_from(mesh));
    const json& fit = value.at("fit");
    geometry.fit = {index_from(fit.at("joints")), index_from(fit.at("left")), fit.at("misfit_before"),
                    fit.at("misfit_after")};
    for (const json& overlap : value.at("overlaps"))
        geometry.overlaps.push_back(
            {overlap.at("a"), overlap.at("b"), overlap.at("volume"), overlap.at("fraction")});
    return geometry;
}

}  // namespace voussoir::importers::helper
