#include "app/geometry/wire.h"

#include <nlohmann/json.hpp>

#include "libdda/errors.h"

namespace voussoir
{

using nlohmann::json;

namespace
{

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

json to_json_value(const ConvexPolyhedron& part)
{
    json vertices = json::array();
    for (const Eigen::Vector3d& x : part.vertices) vertices.push_back(to_json_value(x));
    return {{"vertices", std::move(vertices)}, {"faces", part.faces}};
}

ConvexPolyhedron part_from(const json& value, const std::string& name)
{
    std::vector<Eigen::Vector3d> vertices;
    for (const json& x : value.at("vertices")) vertices.push_back(vector_from(x));
    return make_convex_polyhedron(std::move(vertices), value.at("faces").get<std::vector<std::vector<int>>>(),
                                  name);
}

json to_json_value(const Stone& stone)
{
    json parts = json::array();
    for (const ConvexPolyhedron& part : stone.parts) parts.push_back(to_json_value(part));
    return {{"name", stone.name},     {"closed", stone.closed},   {"convex", stone.convex},
            {"reason", stone.reason}, {"repairs", stone.repairs}, {"parts", std::move(parts)}};
}

Stone stone_from(const json& value)
{
    Stone stone;
    stone.name = value.at("name");
    stone.closed = value.at("closed");
    stone.convex = value.at("convex");
    stone.reason = value.at("reason");
    stone.repairs = value.at("repairs").get<std::vector<std::string>>();
    for (const json& part : value.at("parts")) stone.parts.push_back(part_from(part, stone.name));
    if (!stone.parts.empty()) stone.moments = moments_of(stone.parts);
    return stone;
}

json to_json_value(const ImportedMesh& mesh)
{
    json stones = json::array();
    for (const Stone& stone : mesh.stones) stones.push_back(to_json_value(stone));
    return {{"file", mesh.file},       {"accepted", mesh.accepted},
            {"reason", mesh.reason},   {"metres_per_unit", mesh.metres_per_unit},
            {"repairs", mesh.repairs}, {"stones", std::move(stones)}};
}

ImportedMesh mesh_from(const json& value)
{
    ImportedMesh mesh;
    mesh.file = value.at("file");
    mesh.accepted = value.at("accepted");
    mesh.reason = value.at("reason");
    mesh.metres_per_unit = value.at("metres_per_unit");
    mesh.repairs = value.at("repairs").get<std::vector<std::string>>();
    for (const json& stone : value.at("stones")) mesh.stones.push_back(stone_from(stone));
    return mesh;
}

}  // namespace

std::string to_json(const HelperRequest& request)
{
    json meshes = json::array();
    for (const MeshRequest& mesh : request.meshes)
        meshes.push_back({{"file", mesh.file.string()},
                          {"metres_per_unit", mesh.metres_per_unit},
                          {"up", std::string(1, mesh.up)}});
    try {
        return json{{"meshes", meshes}, {"seconds", request.limits.seconds}, {"bytes", request.limits.bytes}}
            .dump();
    } catch (const json::exception&) {
        throw InputError("mesh", "a file name is not UTF-8", "rename the file");
    }
}

HelperRequest request_from_json(const std::string& text)
{
    const json value = json::parse(text);
    HelperRequest request;
    request.limits = {value.at("seconds").get<double>(), value.at("bytes").get<std::size_t>()};
    for (const json& mesh : value.at("meshes"))
        request.meshes.push_back({mesh.at("file").get<std::string>(), mesh.at("metres_per_unit").get<double>(),
                                  mesh.at("up").get<std::string>().at(0)});
    return request;
}

std::string to_json(const Geometry& geometry)
{
    json meshes = json::array(), overlaps = json::array();
    for (const ImportedMesh& mesh : geometry.meshes) meshes.push_back(to_json_value(mesh));
    for (const Overlap& overlap : geometry.overlaps)
        overlaps.push_back({{"a", overlap.stone_a}, {"b", overlap.stone_b}, {"volume", overlap.volume}});
    return dump({{"origin", to_json_value(geometry.origin)},
                 {"meshes", std::move(meshes)},
                 {"overlaps", std::move(overlaps)}});
}

Geometry geometry_from_json(const std::string& text)
{
    const json value = json::parse(text);
    Geometry geometry;
    geometry.origin = vector_from(value.at("origin"));
    for (const json& mesh : value.at("meshes")) geometry.meshes.push_back(mesh_from(mesh));
    for (const json& overlap : value.at("overlaps"))
        geometry.overlaps.push_back({overlap.at("a"), overlap.at("b"), overlap.at("volume")});
    return geometry;
}

}  // namespace voussoir
