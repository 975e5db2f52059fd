// What the program asks of its helper.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "importers/helper/copies_on_wire.h"
#include "importers/helper/wire.h"
#include "importers/helper/wire_index.h"
#include "libdda/errors.h"

namespace voussoir::importers::helper
{

using nlohmann::json;

namespace
{

/// @throws InputError when it names no reader
mesh::MeshReader reader_from(const json& value)
{
    const auto name = std::find(mesh_reader_names.begin(), mesh_reader_names.end(), value.get<std::string>());
    if (name == mesh_reader_names.end())
        throw InputError("mesh", value.dump() + " is no reader", "the request was damaged on the way");
    return static_cast<mesh::MeshReader>(name - mesh_reader_names.begin());
}

/// @throws InputError when it names no way to fit joints
FitJoints fit_joints_from(const json& value)
{
    const auto name = std::find(fit_joints_names.begin(), fit_joints_names.end(), value.get<std::string>());
    if (name == fit_joints_names.end())
        throw InputError("mesh", value.dump() + " is no way to fit joints", "the request was damaged on the way");
    return static_cast<FitJoints>(name - fit_joints_names.begin());
}

json to_json_value(const StoneChoice& choice)
{
    return {{"skip", choice.skip},
            {"only", choice.only},
            {"hull", choice.hull},
            {"skip_types", choice.skip_types},
            {"repair", static_cast<int>(choice.repair)}};
}

StoneChoice choice_from(const json& value)
{
    using Patterns = std::vector<std::string>;
    const int repair = index_from(value.at("repair"));
    if (repair >= static_cast<int>(repair_rule_names.size()))
        throw InputError("mesh", "no rule of repair", "the request was damaged on the way");
    return {value.at("skip").get<Patterns>(), value.at("only").get<Patterns>(), value.at("hull").get<Patterns>(),
            value.at("skip_types").get<Patterns>(), static_cast<RepairRule>(repair)};
}

json to_json_value(const StoneSimplification& simplify)
{
    return {{"stones", simplify.stones},
            {"hull", simplify.hull},
            {"parts", simplify.parts},
            {"volume_error", simplify.volume_error},
            {"triangles", simplify.triangles}};
}

StoneSimplification simplification_from(const json& value)
{
    return {value.at("stones").get<std::vector<std::string>>(), value.at("hull").get<bool>(),
            index_from(value.at("parts")), value.at("volume_error").get<double>(),
            index_from(value.at("triangles"))};
}

}  // namespace

const std::vector<std::string> stone_level_names{"detect", "file", "object", "group", "node", "component"};
const std::vector<std::string> mesh_reader_names{"auto", "own", "assimp"};
const std::vector<std::string> fit_joints_names{"as_drawn", "shared", "planar"};

std::string to_json(const HelperRequest& request)
{
    json meshes = json::array();
    for (const MeshRequest& mesh : request.meshes)
        meshes.push_back({{"file", mesh.file.string()},
                          {"metres_per_unit", mesh.metres_per_unit},
                          {"up", static_cast<int>(mesh.up)},
                          {"stones", static_cast<int>(mesh.stones)},
                          {"planarity", mesh.planarity},
                          {"volume_error", mesh.volume_error},
                          {"fit_joints", fit_joints_names.at(static_cast<std::size_t>(mesh.fit_joints))},
                          {"close_joints", mesh.close_joints},
                          {"copies", copies_to_json(mesh.copies)},
                          {"reader", mesh_reader_names.at(static_cast<std::size_t>(mesh.reader))},
                          {"choice", to_json_value(mesh.choice)},
                          {"simplify", to_json_value(mesh.simplify)}});
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
                                  static_cast<char>(mesh.at("up").get<int>()),
                                  static_cast<StoneLevel>(mesh.at("stones").get<int>()),
                                  mesh.at("planarity").get<double>(), mesh.at("volume_error").get<double>(),
                                  fit_joints_from(mesh.at("fit_joints")), mesh.at("close_joints").get<double>(),
                                  reader_from(mesh.at("reader")), copies_from_json(mesh.at("copies")),
                                  choice_from(mesh.at("choice")), simplification_from(mesh.at("simplify"))});
    return request;
}

}  // namespace voussoir::importers::helper
