#include <numbers>
#include <pugixml.hpp>

#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"
#include "libdda/geometry/unit_vector.h"

namespace voussoir::importers::mesh
{

namespace
{

constexpr int deepest = 256;
constexpr std::size_t max_instances = 100'000;

/// Where the corners of a primitive stand in its list of numbers: every `stride`-th, from `offset` on.
struct Corners {
    std::vector<int> vertices;
    std::size_t offset = 0, stride = 1;
};

class ColladaReader
{
 public:
    explicit ColladaReader(const MeshSource& source) : source_(source), result_(source)
    {
        const pugi::xml_parse_result parsed =
            xml_.load_buffer(source.bytes.data(), source.bytes.size(), pugi::parse_default, pugi::encoding_utf8);
        if (!parsed)
            throw InputError(line_place(source.place, source.bytes, parsed.offset),
                             std::string("this is not XML: ") + parsed.description(),
                             "the file was cut off or damaged");
        find_ids();
    }

    MeshFile read()
    {
        const pugi::xml_node root = xml_.child("COLLADA"), asset = root.child("asset");
        std::optional<pugi::xml_node> scene = named(root.child("scene").child("instance_visual_scene"));
        if (!scene) scene = root.child("library_visual_scenes").child("visual_scene");
        for (const pugi::xml_node& node : scene->children("node")) place(node, Eigen::Affine3d::Identity(), 0);
        if (left_out_ > 0)
            result_.note(std::to_string(left_out_) + " sets of lines, splines or skins were left out");
        MeshFile file = result_.finish();
        if (const pugi::xml_node unit = asset.child("unit"); unit.attribute("meter")) {
            file.metres_per_unit = text::parse_finite(text::trim(unit.attribute("meter").value()));
            if (!file.metres_per_unit || !(*file.metres_per_unit > 0))
                refuse(unit, "its unit is no positive number of metres", "write <unit meter=\"...\"/>");
        }
        const std::string_view up =
            text::trim(asset.child("up_axis").text().as_string("Y_UP"));  // as the standard says
        if (!up.empty() && up[0] >= 'X' && up[0] <= 'Z') file.up = static_cast<char>(up[0] - 'X' + 'x');
        return file;
    }

 private:
    [[noreturn]] void refuse(const pugi::xml_node& at, const std::string& found, const std::string& expected) const
    {
        throw InputError(line_place(source_.place, source_.bytes, at.offset_debug()), found, expected);
    }

    /// Every element with an id, without recursion: files may be deep.
    void find_ids()
    {
        for (pugi::xml_node node = xml_.first_child(); node;) {
            if (node.attribute("id")) by_id_.emplace(node.attribute("id").value(), node);
            if (node.first_child()) {
                node = node.first_child();
                continue;
            }
            while (node && !node.next_sibling()) node = node.parent();
            if (node) node = node.next_sibling();
        }
    }

    /// What `url="#id"` or `source="#id"` names.
    std::optional<pugi::xml_node> named(const pugi::xml_node& reference) const
    {
        const char* attribute = reference.attribute("url") ? "url" : "source";
        const std::string_view url = reference.attribute(attribute).value();
        if (!reference || url.empty()) return std::nullopt;
        const auto found = by_id_.find(std::string(url.substr(url.starts_with('#') ? 1 : 0)));
        if (found == by_id_.end())
            refuse(reference, "it names \"" + std::string(url.substr(0, 100)) + "\"",
                   "there is nothing with this id in the file");
        return found->second;
    }

    void place(const pugi::xml_node& node, const Eigen::Affine3d& parent, int depth)
    {
        if (depth > deepest || ++instances_ > max_instances)
            refuse(node, "this node is a part of itself, or of too many", "nodes must form a tree");
        Eigen::Affine3d placement = parent;
        for (const pugi::xml_node& child : node.children()) placement = placement * transform(child);
        for (const pugi::xml_node& instance : node.children("instance_geometry"))
            if (const auto geometry = named(instance)) add(node, *geometry, placement);
        for (const pugi::xml_node& instance : node.children("instance_controller"))
            if (const auto controller = named(instance)) {
                ++left_out_;
                if (const auto geometry = named(controller->child("skin"))) add(node, *geometry, placement);
            }
        for (const pugi::xml_node& instance : node.children("instance_node"))
            if (const auto other = named(instance)) place(*other, placement, depth + 1);
        for (const pugi::xml_node& child : node.children("node")) place(child, placement, depth + 1);
    }

    std::vector<double> numbers(const pugi::xml_node& node) const
    {
        std::vector<double> values;
        for (const std::string_view word : text::words(node.text().get())) {
            const std::optional<double> value = text::parse_number(word);
            if (!value)
                refuse(node, "\"" + std::string(word.substr(0, 40)) + "\" is not a number", "write numbers");
            values.push_back(*value);
        }
        return values;
    }

    /// One step of the transform of a node; elements that are none are no step.
    Eigen::Affine3d transform(const pugi::xml_node& step) const
    {
        const std::string_view kind = step.name();
        Eigen::Affine3d transform = Eigen::Affine3d::Identity();
        const std::size_t wanted = kind == "matrix" ? 16 : kind == "rotate" ? 4 : kind == "lookat" ? 9 : 3;
        if (kind == "skew") refuse(step, "a node is skewed", "apply the transform before exporting");
        if (kind != "matrix" && kind != "rotate" && kind != "lookat" && kind != "translate" && kind != "scale")
            return transform;
        const std::vector<double> v = numbers(step);
        if (v.size() != wanted)
            refuse(step, "<" + std::string(kind) + "> has " + std::to_string(v.size()) + " numbers",
                   "it needs " + std::to_string(wanted));
        if (kind == "matrix") transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(v.data()).transpose();
        if (kind == "translate") transform.translate(Eigen::Vector3d(v[0], v[1], v[2]));
        if (kind == "scale") transform.scale(Eigen::Vector3d(v[0], v[1], v[2]));
        if (const Eigen::Vector3d axis(v[0], v[1], v[2]); kind == "rotate" && !axis.isZero(0))
            transform.rotate(Eigen::AngleAxisd(v[3] * std::numbers::pi / 180, unit_vector(axis)));
        if (kind == "lookat") {
            const Eigen::Vector3d eye(v[0], v[1], v[2]),
                z = unit_vector(Eigen::Vector3d(eye - Eigen::Vector3d(v[3], v[4], v[5])));
            const Eigen::Vector3d up = of_measurable_length(Eigen::Vector3d(v[6], v[7], v[8])),
                                  x = up.cross(z).normalized();
            transform.matrix().topRows<3>() << x, z.cross(x), z, eye;
        }
        return transform;
    }

    /// A geometry as a node places it; all its primitives, which differ in their material, are one stone.
    void add(const pugi::xml_node& node, const pugi::xml_node& geometry, const Eigen::Affine3d& placement)
    {
        const auto [known, is_new] = geometries_.try_emplace(geometry.attribute("id").value());
        if (is_new) known->second = surface_of(geometry);
        PolygonSurface surface = known->second;
        for (const char* name : {geometry.attribute("id").value(), geometry.attribute("name").value(),
                                 node.attribute("id").value(), node.attribute("name").value()})
            if (*name != '\0') surface.name = name;
        result_.add(std::move(surface), placement);
    }

    PolygonSurface surface_of(const pugi::xml_node& geometry)
    {
        PolygonSurface surface;
        const pugi::xml_node mesh = geometry.child("mesh");
        for (const pugi::xml_node& input : mesh.child("vertices").children("input"))
            if (std::string_view(input.attribute("semantic").value()) == "POSITION")
                if (const auto positions = named(input)) surface.vertices = points(*positions);
        for (const pugi::xml_node& primitive : mesh.children()) {
            const std::string_view kind = primitive.name();
            if (kind == "lines" || kind == "linestrips") ++left_out_;
            if (kind == "triangles" || kind == "polylist" || kind == "polygons" || kind == "tristrips" ||
                kind == "trifans")
                add_primitive(primitive, surface);
        }
        if (!mesh) ++left_out_;
        return surface;
    }

    std::vector<Eigen::Vector3d> points(const pugi::xml_node& source) const
    {
        const pugi::xml_node accessor = source.child("technique_common").child("accessor");
        const std::vector<double> values = numbers(source.child("float_array"));
        const std::size_t stride = accessor.attribute("stride").as_uint(3);
        const std::size_t offset = accessor.attribute("offset").as_uint(0);
        if (stride < 3 || offset > values.size())
            refuse(source, "its points have fewer than three coordinates", "export it again");
        if (const std::size_t count = accessor.attribute("count").as_ullong((values.size() - offset) / stride);
            count > (values.size() - offset) / stride)
            refuse(source,
                   "it announces " + std::to_string(count) + " points but holds " + std::to_string(values.size()) +
                       " numbers",
                   "the file is damaged");
        std::vector<Eigen::Vector3d> points;
        for (std::size_t i = offset; i + 3 <= values.size(); i += stride)
            points.emplace_back(values[i], values[i + 1], values[i + 2]);
        return points;
    }

    void add_primitive(const pugi::xml_node& primitive, PolygonSurface& surface)
    {
        const std::string_view kind = primitive.name();
        Corners corners;
        for (const pugi::xml_node& input : primitive.children("input")) {
            const std::size_t offset = input.attribute("offset").as_uint(0);
            corners.stride = std::max(corners.stride, offset + 1);
            if (std::string_view(input.attribute("semantic").value()) == "VERTEX") corners.offset = offset;
        }
        std::vector<double> counts = numbers(primitive.child("vcount"));
        for (const pugi::xml_node& list : primitive.children("p")) {
            read_corners(list, surface, corners);
            const std::size_t n = corners.vertices.size();
            if (kind == "triangles") counts.assign(n / 3, 3);
            if (kind == "polygons") counts.assign(1, static_cast<double>(n));
            if (kind == "triangles" || kind == "polygons" || kind == "polylist")
                add_polygons(list, counts, corners, surface);
            else
                add_strip(corners.vertices, kind == "trifans", surface);
        }
        if (primitive.child("ph"))
            refuse(primitive, "a polygon has a hole (<ph>)", "triangulate it before exporting");
    }

    void read_corners(const pugi::xml_node& list, const PolygonSurface& surface, Corners& corners) const
    {
        const std::vector<double> values = numbers(list);
        corners.vertices.clear();
        for (std::size_t i = corners.offset; i < values.size(); i += corners.stride) {
            const long long index = values[i] >= 0 && values[i] < 9e15 ? static_cast<long long>(values[i]) : -1;
            if (index < 0 || index >= static_cast<long long>(surface.vertices.size()))
                refuse(list, "a face names vertex " + std::to_string(index) + ", counted from 0",
                       "the mesh has " + std::to_string(surface.vertices.size()) + " vertices");
            corners.vertices.push_back(static_cast<int>(index));
        }
    }

    void add_polygons(const pugi::xml_node& list, const std::vector<double>& counts, const Corners& corners,
                      PolygonSurface& surface) const
    {
        auto at = corners.vertices.begin();
        for (const double count : counts) {
            if (!(count >= 0) || count > static_cast<double>(corners.vertices.end() - at))
                refuse(list, "<vcount> counts more corners than <p> has", "the file is damaged");
            surface.faces.emplace_back(at, at + static_cast<long>(count));
            at += static_cast<long>(count);
        }
        if (at != corners.vertices.end())
            refuse(list, "<p> has more corners than are counted", "the file is damaged");
    }

    static void add_strip(const std::vector<int>& c, bool fan, PolygonSurface& surface)
    {
        for (std::size_t i = 2; i < c.size(); ++i) {
            if (fan)
                surface.faces.push_back({c[0], c[i - 1], c[i]});
            else if (i % 2 == 1)
                surface.faces.push_back({c[i - 1], c[i - 2], c[i]});
            else
                surface.faces.push_back({c[i - 2], c[i - 1], c[i]});
        }
    }

    const MeshSource& source_;
    SurfaceList result_;
    pugi::xml_document xml_;
    std::map<std::string, pugi::xml_node> by_id_;
    std::map<std::string, PolygonSurface> geometries_;
    std::size_t instances_ = 0, left_out_ = 0;
};

}  // namespace

MeshFile read_collada(const MeshSource& source)
{
    return ColladaReader(source).read();
}

}  // namespace voussoir::importers::mesh
