#include <map>

#include "app/commands/certificate.h"
#include "libdda/geometry/plane.h"

namespace voussoir::app::commands
{
namespace
{

using Eigen::Vector3d;

/// The prism over an outline (x, z) about `centre`, from -thickness/2 to thickness/2 along y.
ConvexPolyhedron prism(const ConvexPolygon& outline, const Vector3d& centre, double thickness)
{
    const int n = static_cast<int>(outline.vertices.size());
    std::vector<Vector3d> vertices;
    for (const double y : {-thickness / 2, thickness / 2})
        for (const Eigen::Vector2d& x : outline.vertices)
            vertices.push_back(centre + to_space(x) + Vector3d(0, y, 0));
    std::vector<std::vector<int>> faces(2);
    for (int i = 0; i < n; ++i) {
        faces[0].push_back(i);  // counter-clockwise in (x, z) is outward at -y
        faces[1].push_back(2 * n - 1 - i);
        const int next = (i + 1) % n;
        faces.push_back({i, i + n, next + n, next});
    }
    return make_convex_polyhedron(std::move(vertices), std::move(faces), "outline");
}

importers::assembly::AssemblyStone stone_of(const Model& model, int index)
{
    const Block& block = model.blocks[index];
    importers::assembly::AssemblyStone stone{block.name, {}, block.moments.volume, 0, false, false};
    for (const ConvexPolyhedron& part : block.parts)
        stone.parts.push_back(translated(part, block.moments.centroid));
    for (const ConvexPolygon& outline : block.outlines)
        stone.parts.push_back(prism(outline, block.moments.centroid, model.thickness));
    return stone;
}

/// Adds the blocks of a model that are not among the stones, and marks foundations.
void add_others(const Model& model, std::map<std::string, int>& index,
                std::vector<importers::assembly::AssemblyStone>& stones)
{
    for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i)
        if (index.emplace(model.blocks[i].name, static_cast<int>(stones.size())).second)
            stones.push_back(stone_of(model, i));
    for (const Foundation& foundation : model.foundations)
        stones[index.at(model.blocks[foundation.block].name)].foundation = true;
    for (const int block : model.tied_sides) stones[index.at(model.blocks[block].name)].endless = true;
}

}  // namespace

importers::assembly::Assembly assembly_of(const std::vector<importers::helper::ImportedMesh>& meshes,
                                          const std::vector<importers::helper::Overlap>& overlaps,
                                          const importers::assembly::AssemblyOrigin& origin, const Model* also)
{
    std::vector<importers::assembly::AssemblyStone> stones;
    std::map<std::string, int> index;
    importers::assembly::AssemblyOrigin all = origin;
    for (const importers::helper::ImportedMesh& mesh : meshes)
        for (const importers::helper::Stone& stone : mesh.stones) {
            if (stone.parts.empty()) {
                ++all.refused_stones;
                continue;
            }
            index.emplace(stone.name, static_cast<int>(stones.size()));
            stones.push_back({stone.name, stone.parts, stone.moments.volume, stone.volume_error, false, false});
        }
    if (also) add_others(*also, index, stones);
    std::vector<importers::assembly::StoneOverlap> known;
    for (const importers::helper::Overlap& overlap : overlaps) {
        const auto a = index.find(overlap.stone_a), b = index.find(overlap.stone_b);
        if (a != index.end() && b != index.end() && a != b)
            known.push_back({a->second, b->second, overlap.volume, 0});
    }
    return importers::assembly::examine_assembly(std::move(stones), known, all);
}

importers::assembly::Assembly assembly_of(const Model& model, const std::map<std::string, double>& volume_errors,
                                          const importers::assembly::AssemblyOrigin& origin)
{
    std::vector<importers::assembly::AssemblyStone> stones;
    for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i) {
        stones.push_back(stone_of(model, i));
        const auto error = volume_errors.find(stones.back().name);
        if (error != volume_errors.end()) stones.back().volume_error = error->second;
    }
    for (const Foundation& foundation : model.foundations) stones[foundation.block].foundation = true;
    for (const int block : model.tied_sides) stones[block].endless = true;
    return importers::assembly::examine_assembly(std::move(stones), {}, origin);
}

}  // namespace voussoir::app::commands
