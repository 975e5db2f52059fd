#include <nlohmann/json.hpp>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

using Json = nlohmann::ordered_json;  // blocks in the order of the file

constexpr int deepest = 64;

/// The dialects of COMPAS differ in where they put the blocks: nodes of a graph, a dictionary of blocks beside a
/// network, elements of a model with a transformation, a list of meshes, or one mesh alone. They agree in how a
/// mesh looks. So the whole document is searched for meshes, and each is named by what surrounds it.
class CompasReader
{
 public:
    explicit CompasReader(const MeshSource& source) : source_(source), result_(source) {}

    MeshFile read()
    {
        Json document;
        try {
            document = Json::parse(source_.bytes);
        } catch (const Json::parse_error& error) {
            throw InputError(line_place(source_.place, source_.bytes, static_cast<std::ptrdiff_t>(error.byte)),
                             "this is not JSON", "the file was cut off or damaged here");
        } catch (const Json::out_of_range&) {
            throw InputError(source_.place, "a number in this JSON is too large", "write coordinates in metres");
        }
        search(document, "", Eigen::Affine3d::Identity(), 0);
        if (meshes_ == 0)
            throw InputError(source_.place,
                             "this JSON file holds no mesh: nothing in it has the entries \"vertex\" and \"face\"",
                             "give a COMPAS assembly, model or mesh, or glTF");
        return result_.finish();
    }

 private:
    void search(const Json& json, const std::string& name, Eigen::Affine3d placement, int depth)
    {
        if (depth > deepest)
            throw InputError(source_.place, "its entries are nested too deeply", "this is no COMPAS file");
        if (json.is_array()) return search_list(json, name, placement, depth);
        if (!json.is_object()) return;
        if (json.contains("transformation")) placement = placement * transformation(json["transformation"], name);
        if (json.contains("vertex") && json.contains("face")) return add_half_edge_mesh(json, name, placement);
        if (json.contains("vertices") && json.contains("faces")) return add_list_mesh(json, name, placement);
        for (const auto& [key, value] : json.items()) {
            // Interfaces between blocks hold meshes that are no blocks.
            if (key == "edge" || key == "adjacency" || key == "interfaces" || key == "interactions") continue;
            const bool names_children = key == "node" || key == "blocks" || key == "elements";
            if (names_children && value.is_object())
                for (const auto& [child, content] : value.items()) search(content, child, placement, depth + 2);
            else
                search(value, name.empty() ? own_name(json, "") : name, placement, depth + 1);
        }
    }

    void search_list(const Json& json, const std::string& name, const Eigen::Affine3d& placement, int depth)
    {
        if (json.empty() || json[0].is_number()) return;
        std::size_t i = 0;
        for (const Json& entry : json)
            search(entry, own_name(entry, (name.empty() ? "block" : name) + " " + std::to_string(i++)), placement,
                   depth + 1);
    }

    /// What it calls itself; COMPAS calls what has no name by its class.
    static std::string own_name(const Json& json, const std::string& otherwise)
    {
        if (!json.is_object() || !json.contains("dtype") || !json["dtype"].is_string()) return otherwise;
        const std::string type = json["dtype"].get<std::string>();
        for (const Json* holder : {&json, json.contains("data") ? &json["data"] : &json}) {
            if (!holder->is_object() || !holder->contains("name") || !(*holder)["name"].is_string()) continue;
            const std::string name = (*holder)["name"].get<std::string>();
            if (!name.empty() && !type.ends_with("/" + name)) return name;
        }
        return otherwise;
    }

    Eigen::Affine3d transformation(const Json& json, const std::string& name) const
    {
        const Json* matrix = &json;
        if (matrix->is_object() && matrix->contains("data")) matrix = &(*matrix)["data"];
        if (matrix->is_object() && matrix->contains("matrix")) matrix = &(*matrix)["matrix"];
        Eigen::Affine3d placement = Eigen::Affine3d::Identity();
        if (matrix->is_null()) return placement;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column) {
                const auto number = [](const Json& list, int i) -> const Json* {
                    return list.is_array() && list.size() > static_cast<std::size_t>(i) ? &list[i] : nullptr;
                };
                const Json* line = number(*matrix, row);
                const Json* value = line != nullptr ? number(*line, column) : nullptr;
                if (value == nullptr || !value->is_number())
                    fault(name, "its transformation is no matrix", "write four rows of four numbers");
                placement(row, column) = value->get<double>();
            }
        return placement;
    }

    [[noreturn]] void fault(const std::string& name, const std::string& found, const std::string& expected) const
    {
        throw InputError(source_.place + (name.empty() ? "" : ": block " + name), found, expected);
    }

    /// {"vertex": {"7": {"x": .., "y": .., "z": ..}}, "face": {"0": [7, ..]}}; a missing coordinate is the
    /// default.
    void add_half_edge_mesh(const Json& mesh, const std::string& name, const Eigen::Affine3d& placement)
    {
        ++meshes_;
        PolygonSurface surface{name, {}, {}};
        std::map<std::string, int> number_of;
        if (!mesh["vertex"].is_object() || !mesh["face"].is_object())
            fault(name, "\"vertex\" and \"face\" are not dictionaries",
                  "write {\"vertex\": {..}, \"face\": {..}}");
        const Json none = Json::object();
        const Json& defaults =
            mesh.contains("default_vertex_attributes") ? mesh["default_vertex_attributes"] : none;
        for (const auto& [key, vertex] : mesh["vertex"].items()) {
            Eigen::Vector3d x;
            for (int i = 0; i < 3; ++i) {
                const char* axis = i == 0 ? "x" : i == 1 ? "y" : "z";
                const Json& holder = vertex.is_object() && vertex.contains(axis) ? vertex : defaults;
                x[i] = coordinate(holder.is_object() && holder.contains(axis) ? holder[axis] : none, name, key);
            }
            number_of[key] = static_cast<int>(surface.vertices.size());
            surface.vertices.push_back(x);
        }
        for (const auto& [key, face] : mesh["face"].items()) {
            std::vector<int>& loop = surface.faces.emplace_back();
            for (const Json& corner : corners(face, name, key)) {
                const auto known = number_of.find(corner.is_string() ? corner.get<std::string>() : corner.dump());
                if (known == number_of.end())
                    fault(name, "face " + key + " names vertex " + corner.dump(), "no such vertex is there");
                loop.push_back(known->second);
            }
            if (loop.size() > 3 && loop.front() == loop.back()) loop.pop_back();
        }
        result_.add(std::move(surface), placement);
    }

    /// {"vertices": [[x, y, z], ..], "faces": [[0, 1, 2], ..]}
    void add_list_mesh(const Json& mesh, const std::string& name, const Eigen::Affine3d& placement)
    {
        ++meshes_;
        PolygonSurface surface{name, {}, {}};
        for (const Json& vertex : mesh["vertices"]) {
            const std::string key = std::to_string(surface.vertices.size());
            if (!vertex.is_array() || vertex.size() != 3)
                fault(name, "vertex " + key + " is no point", "write [x, y, z]");
            surface.vertices.emplace_back(coordinate(vertex[0], name, key), coordinate(vertex[1], name, key),
                                          coordinate(vertex[2], name, key));
        }
        for (const Json& face : mesh["faces"]) {
            const std::string key = std::to_string(surface.faces.size());
            std::vector<int>& loop = surface.faces.emplace_back();
            for (const Json& corner : corners(face, name, key))
                loop.push_back(checked_index(corner.is_number_integer() ? corner.get<long long>() : -1,
                                             surface.vertices.size(), source_.place + ": " + name));
        }
        result_.add(std::move(surface), placement);
    }

    double coordinate(const Json& value, const std::string& name, const std::string& vertex) const
    {
        if (!value.is_number())
            fault(name, "vertex " + vertex + " has no coordinates", "write numbers x, y and z");
        return value.get<double>();
    }

    const Json& corners(const Json& face, const std::string& name, const std::string& key) const
    {
        if (!face.is_array()) fault(name, "face " + key + " is no list", "write the vertices around it");
        return face;
    }

    const MeshSource& source_;
    SurfaceList result_;
    std::size_t meshes_ = 0;
};

}  // namespace

MeshFile read_compas(const MeshSource& source)
{
    return CompasReader(source).read();
}

}  // namespace voussoir::importers::mesh
