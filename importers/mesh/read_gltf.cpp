#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>

#include "importers/mesh/gltf_container.h"
#include "importers/mesh/text.h"
#include "libdda/geometry/unit_vector.h"

namespace voussoir::importers::mesh
{

namespace
{

using Json = nlohmann::json;

/// Where the numbers of an accessor lie.
struct GltfNumbers {
    const char* first = nullptr;
    std::size_t count = 0, stride = 0, size = 0;  // elements; bytes from one to the next; bytes of a number
    int component = 0;                            // glTF's word for the type of a number
    bool normalized = false;
};

std::size_t size_of_component(int component)
{
    switch (component) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
    }
}

double load_component(const GltfNumbers& numbers, const char* at)
{
    switch (numbers.component) {
        case 5120:
            return numbers.normalized ? std::max(load<std::int8_t>(at) / 127.0, -1.0) : load<std::int8_t>(at);
        case 5121:
            return load<std::uint8_t>(at) / (numbers.normalized ? 255.0 : 1.0);
        case 5122:
            return numbers.normalized ? std::max(load<std::int16_t>(at) / 32767.0, -1.0) : load<std::int16_t>(at);
        case 5123:
            return load<std::uint16_t>(at) / (numbers.normalized ? 65535.0 : 1.0);
        case 5125:
            return load<std::uint32_t>(at);
        default:
            return load<float>(at);
    }
}

/// Every index and range is judged before it is followed.
class GltfReader
{
 public:
    explicit GltfReader(const MeshSource& source) : source_(source), result_(source) {}

    MeshFile read()
    {
        GltfContainer container = open_gltf(source_);
        document_ = Json::parse(container.json, nullptr, false);
        if (document_.is_discarded()) refuse("its JSON is damaged or cut off", "export it again");
        const std::string version = document_.value(Json::json_pointer("/asset/version"), "");
        if (!version.starts_with("2")) refuse("this is glTF " + version, "export it as glTF 2.0");
        for (const Json& extension : list("extensionsRequired"))
            if (extension != "KHR_mesh_quantization" && !extension.dump().starts_with("\"KHR_materials") &&
                !extension.dump().starts_with("\"KHR_texture") && extension != "KHR_lights_punctual")
                refuse("it asks for the extension " + extension.dump(), "export it without compression");
        open_buffers(std::move(container.binary));
        for (const std::size_t root : roots()) place(root, Eigen::Affine3d::Identity(), 0);
        if (left_out_ > 0) result_.note(std::to_string(left_out_) + " sets of points or lines were left out");
        MeshFile file = result_.finish();
        file.metres_per_unit = 1;
        file.up = 'y';
        return file;
    }

 private:
    [[noreturn]] void refuse(const std::string& found, const std::string& expected) const
    {
        throw InputError(source_.place, found, expected);
    }

    const Json& list(const char* name) const
    {
        static const Json none = Json::array();
        return document_.contains(name) && document_[name].is_array() ? document_[name] : none;
    }

    /// Entry `index` of a list of the document.
    const Json& entry(const char* name, std::size_t index) const
    {
        if (index >= list(name).size() || !list(name)[index].is_object())
            refuse("it names entry " + std::to_string(index) + " of \"" + name + "\"", "there is no such entry");
        return list(name)[index];
    }

    /// A whole number from 0 on.
    std::size_t number(const Json& object, const char* key, std::optional<std::size_t> otherwise = {}) const
    {
        if (!object.contains(key) && otherwise) return *otherwise;
        if (!object.contains(key) || !object[key].is_number_unsigned())
            refuse(std::string("an entry has no \"") + key + "\"", "it must be a whole number from 0 on");
        return object[key].get<std::size_t>();
    }

    void open_buffers(std::string binary)
    {
        for (const Json& buffer : list("buffers")) {
            const bool in_glb = !buffer.contains("uri");
            if (!in_glb && !buffer["uri"].is_string()) refuse("a buffer's \"uri\" is no text", "export it again");
            buffers_.push_back(in_glb ? std::move(binary) : content_of_uri(buffer["uri"], source_));
        }
    }

    std::vector<std::size_t> roots() const
    {
        std::set<std::size_t> children;
        std::vector<std::size_t> roots;
        const std::size_t scene = number(document_, "scene", 0);
        if (!list("scenes").empty() && entry("scenes", scene).contains("nodes"))
            return whole_numbers(entry("scenes", scene)["nodes"]);
        for (const Json& node : list("nodes"))
            if (node.contains("children"))
                for (const std::size_t child : whole_numbers(node["children"])) children.insert(child);
        for (std::size_t node = 0; node < list("nodes").size(); ++node)
            if (!children.contains(node)) roots.push_back(node);
        return roots;
    }

    std::vector<std::size_t> whole_numbers(const Json& json) const
    {
        std::vector<std::size_t> numbers;
        for (const Json& value : json) {
            if (!value.is_number_unsigned())
                refuse("a list of nodes holds " + value.dump().substr(0, 40), "write numbers");
            numbers.push_back(value.get<std::size_t>());
        }
        return numbers;
    }

    /// A node has one parent; one that is met again belongs to a circle.
    void place(std::size_t index, const Eigen::Affine3d& parent, int depth)
    {
        const Json& node = entry("nodes", index);
        if (!placed_.insert(index).second || depth > 1000)
            refuse("node " + std::to_string(index) + " is its own ancestor, or has two parents",
                   "the nodes must form a tree");
        const Eigen::Affine3d placement = parent * transform(node);
        if (node.contains("mesh")) add_mesh(node, placement);
        if (!node.contains("children")) return;
        for (const std::size_t child : whole_numbers(node["children"])) place(child, placement, depth + 1);
    }

    template <std::size_t count>
    std::array<double, count> numbers_of(const Json& node, const char* key, std::array<double, count> values) const
    {
        if (!node.contains(key)) return values;
        for (std::size_t i = 0; i < count; ++i) {
            if (!node[key].is_array() || node[key].size() != count || !node[key][i].is_number())
                refuse(std::string("the ") + key + " of a node is not " + std::to_string(count) + " numbers",
                       "export it again");
            values[i] = node[key][i].template get<double>();
        }
        return values;
    }

    Eigen::Affine3d transform(const Json& node) const
    {
        Eigen::Affine3d transform = Eigen::Affine3d::Identity();
        if (node.contains("matrix")) {
            const auto m = numbers_of<16>(node, "matrix", {});
            transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());  // both are column by column
            return transform;
        }
        const auto shift = numbers_of<3>(node, "translation", {0, 0, 0});
        const auto scale = numbers_of<3>(node, "scale", {1, 1, 1});
        const auto turn = numbers_of<4>(node, "rotation", {0, 0, 0, 1});
        const Eigen::Quaterniond rotation(turn[3], turn[0], turn[1], turn[2]);
        transform.translate(Eigen::Vector3d(shift[0], shift[1], shift[2]));
        if (node.contains("rotation")) transform.rotate(Eigen::Quaterniond(unit_vector(rotation.coeffs())));
        transform.scale(Eigen::Vector3d(scale[0], scale[1], scale[2]));
        return transform;
    }

    /// All primitives of a mesh, which differ in their material, are one stone.
    void add_mesh(const Json& node, const Eigen::Affine3d& placement)
    {
        const Json& mesh = entry("meshes", number(node, "mesh"));
        PolygonSurface surface{text(node, "name").empty() ? text(mesh, "name") : text(node, "name"), {}, {}};
        if (mesh.contains("primitives"))
            for (const Json& primitive : mesh["primitives"]) add_primitive(primitive, surface);
        result_.add(std::move(surface), placement);
    }

    static std::string text(const Json& object, const char* key)
    {
        return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
    }

    void add_primitive(const Json& primitive, PolygonSurface& surface)
    {
        const std::size_t mode = number(primitive, "mode", 4);
        if (mode < 4 || mode > 6) return void(++left_out_);
        if (!primitive.contains("attributes")) refuse("a mesh has no attributes", "it needs \"POSITION\"");
        const GltfNumbers points = numbers(number(primitive["attributes"], "POSITION"), "VEC3", 3);
        const int first = static_cast<int>(surface.vertices.size());
        for (std::size_t i = 0; i < points.count; ++i) {
            const char* at = points.first + i * points.stride;
            surface.vertices.emplace_back(load_component(points, at), load_component(points, at + points.size),
                                          load_component(points, at + 2 * points.size));
        }
        std::vector<int> corners;
        if (primitive.contains("indices")) {
            const GltfNumbers indices = numbers(number(primitive, "indices"), "SCALAR", 1);
            const std::string place = source_.place + ": " + surface.name;
            for (std::size_t i = 0; i < indices.count; ++i) {
                const double index = load_component(indices, indices.first + i * indices.stride);
                corners.push_back(first + checked_index(static_cast<long long>(index), points.count, place));
            }
        } else {
            for (std::size_t i = 0; i < points.count; ++i) corners.push_back(first + static_cast<int>(i));
        }
        add_triangles(corners, mode, surface);
    }

    void add_triangles(const std::vector<int>& c, std::size_t mode, PolygonSurface& surface)
    {
        if (mode == 4 && c.size() % 3 != 0) result_.note("an incomplete last triangle was left out");
        for (std::size_t i = 2; i < c.size(); i += mode == 4 ? 3 : 1) {
            if (mode == 6)
                surface.faces.push_back({c[i - 1], c[i], c[0]});
            else if (mode == 5 && i % 2 == 1)
                surface.faces.push_back({c[i - 1], c[i - 2], c[i]});
            else
                surface.faces.push_back({c[i - 2], c[i - 1], c[i]});
        }
    }

    GltfNumbers numbers(std::size_t index, const std::string& type, std::size_t per_element) const
    {
        const Json& accessor = entry("accessors", index);
        if (accessor.contains("sparse")) refuse("an accessor is sparse", "export it without sparse accessors");
        if (text(accessor, "type") != type) refuse("an accessor is not of type " + type, "export it again");
        GltfNumbers found;
        found.component = static_cast<int>(number(accessor, "componentType"));
        found.size = size_of_component(found.component);
        found.count = number(accessor, "count");
        found.normalized = accessor.contains("normalized") && accessor["normalized"] == true;
        if (found.size == 0 || (per_element == 1 && found.component == 5126))
            refuse("an accessor has numbers of type " + std::to_string(found.component), "export it again");
        const Json& view = entry("bufferViews", number(accessor, "bufferView"));
        const std::size_t buffer = number(view, "buffer"), offset = number(view, "byteOffset", 0);
        const std::size_t length = number(view, "byteLength"), start = number(accessor, "byteOffset", 0);
        found.stride = number(view, "byteStride", per_element * found.size);
        const bool inside = buffer < buffers_.size() && offset <= buffers_[buffer].size() &&
                            length <= buffers_[buffer].size() - offset && start <= length;
        const std::size_t room = inside ? length - start : 0, one = per_element * found.size;
        if (!inside || found.stride < one || found.stride > 255 * 4 ||
            (found.count > 0 && (room < one || found.count - 1 > (room - one) / found.stride)))
            refuse("accessor " + std::to_string(index) + " of " + std::to_string(found.count) +
                       " elements reaches beyond its buffer",
                   "the file was cut off or damaged");
        found.first = buffers_[buffer].data() + offset + start;
        return found;
    }

    const MeshSource& source_;
    SurfaceList result_;
    Json document_;
    std::vector<std::string> buffers_;
    std::set<std::size_t> placed_;
    std::size_t left_out_ = 0;
};

}  // namespace

MeshFile read_gltf(const MeshSource& source)
{
    try {
        return GltfReader(source).read();
    } catch (const nlohmann::json::exception& error) {
        throw InputError(source.place,
                         std::string("an entry is of another kind than glTF has there (") + error.what() + ")",
                         "export it again");
    }
}

}  // namespace voussoir::importers::mesh
