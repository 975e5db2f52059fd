#include <cmath>
#include <pugixml.hpp>
#include <set>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir
{

namespace
{

constexpr int deepest = 64;
constexpr std::size_t most_instances = 100'000;

class AmfReader
{
 public:
    explicit AmfReader(const MeshSource& source) : source_(source), result_(source)
    {
        const pugi::xml_parse_result parsed = xml_.load_buffer(source.bytes.data(), source.bytes.size());
        if (!parsed)
            throw InputError(line_place(source.place, source.bytes, parsed.offset),
                             std::string("this is not XML: ") + parsed.description(),
                             "the file was cut off or damaged");
    }

    MeshFile read()
    {
        const pugi::xml_node root = xml_.child("amf");
        const double unit = metres(root);
        std::set<std::string> placed;
        for (const char* kind : {"object", "constellation"})
            for (const pugi::xml_node& node : root.children(kind)) by_id_[node.attribute("id").value()] = node;
        for (const pugi::xml_node& constellation : root.children("constellation"))
            for (const pugi::xml_node& instance : constellation.children("instance"))
                placed.insert(instance.attribute("objectid").value());
        for (const char* kind : {"constellation", "object"})
            for (const pugi::xml_node& node : root.children(kind))
                if (!placed.contains(node.attribute("id").value())) add(node, Eigen::Affine3d::Identity(), 0);
        MeshFile file = result_.finish();
        file.metres_per_unit = unit;
        return file;
    }

 private:
    double metres(const pugi::xml_node& root) const
    {
        const std::string unit =
            lower_case(root.attribute("unit").as_string("millimeter"));  // as the standard says
        const std::map<std::string, double> known{{"micrometer", 1e-6}, {"micron", 1e-6}, {"millimeter", 1e-3},
                                                  {"inch", 0.0254},     {"feet", 0.3048}, {"foot", 0.3048},
                                                  {"meter", 1}};
        const auto found = known.find(unit);
        if (found == known.end())
            throw InputError(source_.place, "its unit is \"" + unit + "\"", "AMF knows no such unit");
        return found->second;
    }

    [[noreturn]] void refuse(const pugi::xml_node& at, const std::string& found, const std::string& expected) const
    {
        throw InputError(line_place(source_.place, source_.bytes, at.offset_debug()), found, expected);
    }

    void add(const pugi::xml_node& node, const Eigen::Affine3d& placement, int depth)
    {
        if (depth > deepest || ++instances_ > most_instances)
            refuse(node, "this constellation is a part of itself, or too large",
                   "constellations must form a tree");
        if (std::string_view(node.name()) == "object") return add_object(node, placement);
        for (const pugi::xml_node& instance : node.children("instance")) {
            const auto found = by_id_.find(instance.attribute("objectid").value());
            if (found == by_id_.end())
                refuse(instance, "it places an object that is not there", "check `objectid`");
            add(found->second, placement * transform(instance), depth + 1);
        }
    }

    double number(const pugi::xml_node& parent, const char* name) const
    {
        const pugi::xml_node child = parent.child(name);
        const std::optional<double> value = parse_finite(trim(child.text().as_string("0")));
        if (!value) refuse(child, std::string("<") + name + "> is not a finite number", "write a number");
        return *value;
    }

    /// Turned about x, then y, then z, in degrees, then moved.
    Eigen::Affine3d transform(const pugi::xml_node& instance) const
    {
        constexpr double degree = 3.14159265358979323846 / 180;
        return Eigen::Translation3d(number(instance, "deltax"), number(instance, "deltay"),
                                    number(instance, "deltaz")) *
               Eigen::AngleAxisd(number(instance, "rz") * degree, Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(number(instance, "ry") * degree, Eigen::Vector3d::UnitY()) *
               Eigen::AngleAxisd(number(instance, "rx") * degree, Eigen::Vector3d::UnitX());
    }

    static std::string name_of(const pugi::xml_node& object)
    {
        for (const pugi::xml_node& metadata : object.children("metadata"))
            if (std::string_view(metadata.attribute("type").value()) == "name")
                return std::string(trim(metadata.text().get()));
        return std::string("object ") + object.attribute("id").value();
    }

    /// All volumes of an object, which differ in their material, share its vertices and are one stone.
    void add_object(const pugi::xml_node& object, const Eigen::Affine3d& placement)
    {
        PolygonSurface surface{name_of(object), {}, {}};
        const pugi::xml_node mesh = object.child("mesh");
        for (const pugi::xml_node& vertex : mesh.child("vertices").children("vertex")) {
            const pugi::xml_node x = vertex.child("coordinates");
            if (!x.child("x") || !x.child("y") || !x.child("z"))
                refuse(vertex, "this vertex has no coordinates x, y and z", "write <coordinates>");
            surface.vertices.emplace_back(number(x, "x"), number(x, "y"), number(x, "z"));
        }
        for (const pugi::xml_node& volume : mesh.children("volume"))
            for (const pugi::xml_node& triangle : volume.children("triangle")) {
                std::vector<int>& face = surface.faces.emplace_back();
                for (const char* corner : {"v1", "v2", "v3"}) {
                    const std::string word(trim(triangle.child(corner).text().get()));
                    const long long v = parse_integer(word).value_or(-1);
                    if (v < 0 || v >= static_cast<long long>(surface.vertices.size()))
                        refuse(triangle, "a triangle names vertex \"" + word + "\"",
                               "the object has " + std::to_string(surface.vertices.size()) + " vertices");
                    face.push_back(static_cast<int>(v));
                }
            }
        result_.add(std::move(surface), placement);
    }

    const MeshSource& source_;
    SurfaceList result_;
    pugi::xml_document xml_;
    std::map<std::string, pugi::xml_node> by_id_;
    std::size_t instances_ = 0;
};

}  // namespace

MeshFile read_amf(const MeshSource& source)
{
    if (!source.bytes.starts_with("PK")) return AmfReader(source).read();
    MeshSource unpacked = source;
    for (auto& [name, text] : unzipped(source, ".amf")) unpacked.bytes = std::move(text);
    return AmfReader(unpacked).read();
}

}  // namespace voussoir
