#include <pugixml.hpp>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

constexpr int deepest = 64;
constexpr std::size_t max_instances = 100'000;

/// One .model part of the package.
struct ModelPart {
    std::string text;
    pugi::xml_document xml;
    std::map<std::string, pugi::xml_node> objects;  // by id
};

/// A name without its namespace: producers write "p:path" as well as "production:path".
std::string_view local_name(const char* name)
{
    const std::string_view text(name);
    return text.substr(text.find(':') == std::string_view::npos ? 0 : text.find(':') + 1);
}

pugi::xml_attribute attribute(const pugi::xml_node& node, std::string_view name)
{
    for (const pugi::xml_attribute& found : node.attributes())
        if (local_name(found.name()) == name) return found;
    return {};
}

class PackageReader
{
 public:
    explicit PackageReader(const MeshSource& source) : source_(source), result_(source)
    {
        for (auto& [name, text] : unzipped(source, ".model")) {
            ModelPart& part = parts_["/" + name];
            part.text = std::move(text);
            const pugi::xml_parse_result parsed = part.xml.load_buffer(part.text.data(), part.text.size());
            if (!parsed)
                throw InputError(line_place(source.place + " (" + name + ")", part.text, parsed.offset),
                                 std::string("this is not XML: ") + parsed.description(), "the file is damaged");
            for (const pugi::xml_node& object : part.xml.child("model").child("resources").children("object"))
                part.objects[object.attribute("id").value()] = object;
        }
    }

    MeshFile read()
    {
        const std::string root = root_part();
        const pugi::xml_node model = parts_[root].xml.child("model");
        const double unit = metres(model);
        for (const pugi::xml_node& item : model.child("build").children("item")) {
            const auto path = attribute(item, "path");
            add(path ? path.value() : root, item, Eigen::Affine3d::Identity(), "", 0);
        }
        if (!model.child("build").child("item"))
            throw InputError(source_.place, "its <build> has no items: nothing is placed", "place the objects");
        if (left_out_ > 0)
            result_.note(std::to_string(left_out_) +
                         " objects that are not of the model, such as supports, were left out");
        MeshFile file = result_.finish();
        file.metres_per_unit = unit;
        file.up = 'z';
        return file;
    }

 private:
    std::string root_part() const
    {
        for (const auto& [name, part] : parts_)
            if (text::lower_case(name) == "/3d/3dmodel.model") return name;
        for (const auto& [name, part] : parts_)
            if (part.xml.child("model").child("build").child("item")) return name;
        throw InputError(source_.place, "this archive has no 3D model", "a 3MF file holds 3D/3dmodel.model");
    }

    double metres(const pugi::xml_node& model) const
    {
        const std::string unit = model.attribute("unit").as_string("millimeter");  // the default of the standard
        const std::map<std::string, double> known{{"micron", 1e-6}, {"millimeter", 1e-3}, {"centimeter", 1e-2},
                                                  {"inch", 0.0254}, {"foot", 0.3048},     {"meter", 1}};
        const auto found = known.find(unit);
        if (found == known.end())
            throw InputError(source_.place, "its unit is \"" + unit + "\"", "3MF knows no such unit");
        return found->second;
    }

    [[noreturn]] void refuse(const ModelPart& part, const pugi::xml_node& at, const std::string& found,
                             const std::string& expected) const
    {
        throw InputError(line_place(source_.place + " (3D model)", part.text, at.offset_debug()), found, expected);
    }

    /// What an <item> or a <component> places: a mesh, or further components.
    void add(const std::string& path, const pugi::xml_node& reference, const Eigen::Affine3d& parent,
             const std::string& outer_name, int depth)
    {
        const auto part = parts_.find(path);
        if (part == parts_.end())
            throw InputError(source_.place, "it names the part " + path, "there is no such part");
        const std::string id = reference.attribute("objectid").value();
        const auto found = part->second.objects.find(id);
        if (found == part->second.objects.end())
            refuse(part->second, reference, "object \"" + id + "\" is placed", "there is no such object");
        if (depth > deepest || ++instances_ > max_instances)
            refuse(part->second, found->second, "object \"" + id + "\" is a part of itself, or of too many",
                   "components must form a tree");
        const pugi::xml_node object = found->second;
        const std::string type = object.attribute("type").as_string("model");
        if (type != "model" && type != "surface" && type != "other") return void(++left_out_);
        const std::string own = object.attribute("name").value();
        const std::string name = own.empty() ? outer_name : own;
        const Eigen::Affine3d placement = parent * transform(part->second, reference);
        if (object.child("mesh")) add_mesh(part->second, object, placement, name.empty() ? "object " + id : name);
        for (const pugi::xml_node& component : object.child("components").children("component")) {
            const auto other = attribute(component, "path");
            add(other ? other.value() : path, component, placement, name, depth + 1);
        }
    }

    /// Twelve numbers, row by row, of a matrix that multiplies rows from the right.
    Eigen::Affine3d transform(const ModelPart& part, const pugi::xml_node& node) const
    {
        Eigen::Affine3d transform = Eigen::Affine3d::Identity();
        if (!node.attribute("transform")) return transform;
        const std::vector<std::string_view> word = text::words(node.attribute("transform").value());
        for (int i = 0; i < 12; ++i) {
            const auto value =
                word.size() == 12 ? text::parse_finite(word[static_cast<std::size_t>(i)]) : std::nullopt;
            if (!value) refuse(part, node, "its transform is not twelve finite numbers", "export it again");
            transform(i % 3, i / 3) = *value;
        }
        return transform;
    }

    void add_mesh(const ModelPart& part, const pugi::xml_node& object, const Eigen::Affine3d& placement,
                  const std::string& name)
    {
        PolygonSurface surface{name, {}, {}};
        for (const pugi::xml_node& vertex : object.child("mesh").child("vertices").children("vertex")) {
            Eigen::Vector3d x;
            if (!parse_point(
                    {vertex.attribute("x").value(), vertex.attribute("y").value(), vertex.attribute("z").value()},
                    0, x))
                refuse(part, vertex, "this vertex is not three finite numbers", "export it again");
            surface.vertices.push_back(x);
        }
        for (const pugi::xml_node& triangle : object.child("mesh").child("triangles").children("triangle")) {
            std::vector<int>& face = surface.faces.emplace_back();
            for (const char* corner : {"v1", "v2", "v3"}) {
                const long long v = text::parse_integer(triangle.attribute(corner).value()).value_or(-1);
                if (v < 0 || v >= static_cast<long long>(surface.vertices.size()))
                    refuse(part, triangle,
                           std::string("a triangle names vertex \"") + triangle.attribute(corner).value() + "\"",
                           "the object has " + std::to_string(surface.vertices.size()) + " vertices");
                face.push_back(static_cast<int>(v));
            }
        }
        result_.add(std::move(surface), placement);
    }

    const MeshSource& source_;
    SurfaceList result_;
    std::map<std::string, ModelPart> parts_;
    std::size_t left_out_ = 0, instances_ = 0;
};

}  // namespace

MeshFile read_3mf(const MeshSource& source)
{
    return PackageReader(source).read();
}

}  // namespace voussoir::importers::mesh
