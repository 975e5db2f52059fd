#include <algorithm>
#include <cmath>
#include <numbers>

#include "importers/mesh/dxf_pairs.h"
#include "importers/mesh/text.h"
#include "libdda/geometry/unit_vector.h"

namespace voussoir::importers::mesh
{

namespace
{

constexpr int deepest = 32;
constexpr std::size_t max_instances = 100'000;

/// One entity: its pairs after (0, NAME).
struct Entity {
    std::string_view name, layer;
    DxfRange range;
};

class DxfReader
{
 public:
    DxfReader(const MeshSource& source, const ReadOptions& options)
        : source_(source),
          file_(read_dxf_pairs(source)),
          by_layer_(options.stones == StonesBy::group),
          result_(source, by_layer_)
    {
    }

    MeshFile read()
    {
        read_entities(file_.entities, Eigen::Affine3d::Identity(), "", 0);
        std::string others;
        for (const auto& [name, count] : left_out_)
            others += (others.empty() ? "" : ", ") + std::to_string(count) + " " + name;
        if (!others.empty()) result_.note("entities that are no faces were left out: " + others);
        if (!found_faces_ && !others.empty())
            throw InputError(source_.place, "the file holds no faces, only " + others,
                             "export the solids as meshes (3DFACE, POLYLINE polyface or MESH)");
        MeshFile mesh = result_.finish();
        mesh.metres_per_unit = file_.metres_per_unit;
        mesh.up = 'z';
        return mesh;
    }

 private:
    [[noreturn]] void refuse(std::size_t pair, const std::string& found, const std::string& expected) const
    {
        const int line = pair < file_.pairs.size() ? file_.pairs[pair].line : 0;
        throw InputError(source_.place + ":" + std::to_string(line), found, expected);
    }

    Entity entity_at(std::size_t first, std::size_t end) const
    {
        Entity entity{file_.pairs[first].value, "0", {first + 1, first + 1}};
        while (entity.range.end < end && file_.pairs[entity.range.end].code != 0) ++entity.range.end;
        for (std::size_t i = entity.range.first; i < entity.range.end; ++i)
            if (file_.pairs[i].code == 8) entity.layer = file_.pairs[i].value;
        return entity;
    }

    double number(const Entity& entity, int code, double otherwise) const
    {
        for (std::size_t i = entity.range.first; i < entity.range.end; ++i)
            if (file_.pairs[i].code == code) return number(i);
        return otherwise;
    }

    double number(std::size_t pair) const
    {
        const std::optional<double> value = text::parse_finite(file_.pairs[pair].value);
        if (!value)
            refuse(pair, "\"" + std::string(file_.pairs[pair].value.substr(0, 40)) + "\" is not a finite number",
                   "write a number");
        return *value;
    }

    int whole(const Entity& entity, int code) const
    {
        return static_cast<int>(std::clamp(number(entity, code, 0), -2e9, 2e9));
    }

    Eigen::Vector3d point(const Entity& entity, int code) const
    {
        return {number(entity, code, 0), number(entity, code + 10, 0), number(entity, code + 20, 0)};
    }

    bool has(const Entity& entity, int code) const
    {
        return std::any_of(file_.pairs.begin() + static_cast<long>(entity.range.first),
                           file_.pairs.begin() + static_cast<long>(entity.range.end),
                           [&](const DxfPair& pair) { return pair.code == code; });
    }

    /// @param owner the block these entities belong to: its 3DFACEs are one stone; empty: one for each layer
    void read_entities(DxfRange range, const Eigen::Affine3d& placement, const std::string& owner, int depth)
    {
        std::vector<PolygonSurface> loose;  // of 3DFACEs, in the order in which their layers come up
        std::map<std::string, std::size_t> loose_of;
        for (std::size_t at = range.first; at < range.end;) {
            const Entity entity = entity_at(at, range.end);
            at = entity.range.end;
            if (entity.name == "3DFACE") {
                const std::string name = owner.empty() || by_layer_ ? dxf_name(entity.layer) : owner;
                const auto [known, is_new] = loose_of.emplace(name, loose.size());
                if (is_new) loose.push_back({name, {}, {}});
                add_3dface(entity, loose[known->second]);
            } else if (entity.name == "POLYLINE") {
                at = add_polyline(entity, range.end, placement);
            } else if (entity.name == "MESH") {
                add_mesh(entity, placement);
            } else if (entity.name == "INSERT") {
                insert(entity, placement, depth);
            } else {
                ++left_out_[std::string(entity.name.substr(0, 40))];
            }
        }
        for (PolygonSurface& surface : loose) add(std::move(surface), placement);
    }

    void add(PolygonSurface surface, const Eigen::Affine3d& placement)
    {
        found_faces_ = true;
        result_.add(std::move(surface), placement);
    }

    /// Three corners have the last one twice, or leave it out.
    void add_3dface(const Entity& entity, PolygonSurface& surface) const
    {
        const int first = static_cast<int>(surface.vertices.size());
        const int corners = !has(entity, 13) || point(entity, 12) == point(entity, 13) ? 3 : 4;
        std::vector<int>& face = surface.faces.emplace_back();
        for (int i = 0; i < corners; ++i) {
            surface.vertices.push_back(point(entity, 10 + i));
            face.push_back(first + i);
        }
    }

    /// A polyface mesh (flag 64) lists vertices and faces, a polygon mesh (flag 16) is a grid of vertices.
    /// @returns the pair after its last VERTEX
    std::size_t add_polyline(const Entity& polyline, std::size_t end, const Eigen::Affine3d& placement)
    {
        const int flags = whole(polyline, 70);
        PolygonSurface surface{dxf_name(polyline.layer), {}, {}};
        std::size_t at = polyline.range.end;
        for (; at < end;) {
            const Entity vertex = entity_at(at, end);
            if (vertex.name != "VERTEX" && vertex.name != "SEQEND") break;
            at = vertex.range.end;
            if (vertex.name == "SEQEND") break;
            const int kind = whole(vertex, 70);
            if ((flags & 64) != 0 && (kind & 192) == 128)
                add_polyface(vertex, surface);
            else if ((kind & 16) == 0)
                surface.vertices.push_back(point(vertex, 10));  // 16: of a spline's frame
        }
        if ((flags & 16) != 0) add_grid(polyline, flags, surface);
        if ((flags & (16 | 64)) != 0)
            add(std::move(surface), placement);
        else
            ++left_out_["POLYLINE"];
        return at;
    }

    /// Corners are counted from 1; a negative one begins an edge that is not drawn.
    void add_polyface(const Entity& record, PolygonSurface& surface) const
    {
        std::vector<int>& face = surface.faces.emplace_back();
        for (int code = 71; code <= 74; ++code) {
            const int corner = std::abs(whole(record, code));
            if (corner != 0) face.push_back(corner - 1);
        }
    }

    void add_grid(const Entity& polyline, int flags, PolygonSurface& surface) const
    {
        const int m = whole(polyline, 71), n = whole(polyline, 72);
        if (m < 2 || n < 2 || static_cast<double>(m) * n != static_cast<double>(surface.vertices.size()))
            refuse(polyline.range.first,
                   "a polygon mesh of " + std::to_string(m) + " by " + std::to_string(n) + " vertices has " +
                       std::to_string(surface.vertices.size()),
                   "the file is damaged");
        const int rows = (flags & 1) != 0 ? m : m - 1, columns = (flags & 32) != 0 ? n : n - 1;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) {
                const int below = (i + 1) % m * n, next = (j + 1) % n;
                surface.faces.push_back({i * n + j, below + j, below + next, i * n + next});
            }
    }

    /// Vertices follow their count (92); faces follow the length of their list (93) as 90: corners, then the
    /// corners.
    void add_mesh(const Entity& entity, const Eigen::Affine3d& placement)
    {
        PolygonSurface surface{dxf_name(entity.layer), {}, {}};
        int list = 0, corners_left = 0;
        for (std::size_t i = entity.range.first; i < entity.range.end; ++i) {
            const int code = file_.pairs[i].code;
            if (code == 91 && list == 0 && number(i) > 0) result_.note("the smoothing of a MESH was left out");
            if (code >= 92 && code <= 95) list = code;
            if (list == 92 && code == 10) surface.vertices.emplace_back(number(i), 0, 0);
            if (list == 92 && (code == 20 || code == 30) && !surface.vertices.empty())
                surface.vertices.back()[code / 10 - 1] = number(i);
            if (list != 93 || code != 90) continue;
            const int value = static_cast<int>(std::clamp(number(i), -1.0, 2e9));
            if (corners_left == 0) {
                corners_left = value;
                surface.faces.emplace_back();
            } else {
                surface.faces.back().push_back(value);
                --corners_left;
            }
        }
        add(std::move(surface), placement);
    }

    /// The axes of an entity drawn in a plane, from its normal: the "arbitrary axis" of the DXF reference.
    static Eigen::Matrix3d axes_of(const Eigen::Vector3d& extrusion)
    {
        const Eigen::Vector3d z = !extrusion.isZero(0) ? unit_vector(extrusion) : Eigen::Vector3d::UnitZ();
        const bool near_z = std::abs(z.x()) < 1. / 64 && std::abs(z.y()) < 1. / 64;
        const Eigen::Vector3d x =
            (near_z ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ()).cross(z).normalized();
        Eigen::Matrix3d axes;
        axes << x, z.cross(x), z;
        return axes;
    }

    void insert(const Entity& entity, const Eigen::Affine3d& placement, int depth)
    {
        std::string name;
        for (std::size_t i = entity.range.first; i < entity.range.end; ++i)
            if (file_.pairs[i].code == 2) name = file_.pairs[i].value;
        const auto block = file_.blocks.find(name);
        if (block == file_.blocks.end())
            refuse(entity.range.first, "it inserts the block \"" + name + "\"", "there is no such block");
        if (depth > deepest)
            refuse(entity.range.first, "the block \"" + name + "\" is a part of itself",
                   "blocks must form a tree");
        const Entity head = entity_at(block->second.first, block->second.end);
        const Eigen::Matrix3d axes =
            axes_of({number(entity, 210, 0), number(entity, 220, 0), number(entity, 230, 1)});
        const int columns = std::max(1, whole(entity, 70)), rows = std::max(1, whole(entity, 71));
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                if (++instances_ > max_instances)
                    refuse(entity.range.first, "blocks are inserted too often", "give fewer");
                Eigen::Affine3d local = Eigen::Affine3d::Identity();
                local.rotate(axes).translate(point(entity, 10));
                local.rotate(
                    Eigen::AngleAxisd(number(entity, 50, 0) * std::numbers::pi / 180, Eigen::Vector3d::UnitZ()));
                local.translate(Eigen::Vector3d(column * number(entity, 44, 0), row * number(entity, 45, 0), 0));
                local.scale(Eigen::Vector3d(number(entity, 41, 1), number(entity, 42, 1), number(entity, 43, 1)));
                local.translate(-point(head, 10));
                read_entities({head.range.end, block->second.end}, placement * local, dxf_name(name), depth + 1);
            }
    }

    const MeshSource& source_;
    DxfFile file_;
    bool by_layer_;
    SurfaceList result_;
    std::map<std::string, std::size_t> left_out_;
    std::size_t instances_ = 0;
    bool found_faces_ = false;
};

}  // namespace

MeshFile read_dxf(const MeshSource& source, const ReadOptions& options)
{
    if (source.bytes.starts_with("AutoCAD Binary DXF"))
        throw InputError(source.place, "this is a binary DXF file", "save it as text (ASCII) DXF");
    return DxfReader(source, options).read();
}

}  // namespace voussoir::importers::mesh
