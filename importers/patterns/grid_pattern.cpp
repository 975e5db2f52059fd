#include "importers/patterns/grid_pattern.h"

#include <map>

#include "importers/patterns/lantern.h"
#include "importers/patterns/vault_ribs.h"

namespace voussoir::importers::patterns
{
namespace
{

/// One convex stone of all faces, those in a plane merged, with the vertices that are left.
ConvexPolyhedron plug(const StoneGrid& grid, const StoneGrid::Stone& stone)
{
    std::vector<std::vector<int>> faces = merge_coplanar_faces(grid.corners(), stone.faces, 1e-7);
    std::map<int, int> own;
    std::vector<Eigen::Vector3d> vertices;
    for (std::vector<int>& face : faces)
        for (int& corner : face) {
            const auto [place, is_new] = own.try_emplace(corner, static_cast<int>(vertices.size()));
            if (is_new) vertices.push_back(grid.corners()[corner]);
            corner = place->second;
        }
    return make_convex_polyhedron(std::move(vertices), std::move(faces), stone.name);
}

}  // namespace

Pattern pattern_of(const StoneGrid& grid, const std::string& prefix, const std::string& group)
{
    Pattern pattern;
    for (const StoneGrid::Stone& stone : grid.stones()) {
        const bool held = stone.name.starts_with("support");
        std::vector<ConvexPolyhedron> parts = parts_of(grid, stone);
        if (parts.empty()) parts.push_back(plug(grid, stone));
        pattern.stones.push_back({prefix + stone.name, held ? foundation_group : group, std::move(parts)});
    }
    return pattern;
}

Pattern dome_pattern(const Dome& dome, const std::string& prefix)
{
    Pattern pattern = pattern_of(patterns::dome(dome), prefix, "dome");
    for (PatternStone& stone : pattern.stones)
        if (stone.name.starts_with(prefix + "front_")) stone.group = "front";
    if (dome.lantern.height > 0) add_lantern(dome, prefix, pattern);
    return pattern;
}

Pattern cross_vault_pattern(const CrossVault& vault, const std::string& prefix)
{
    Pattern pattern = pattern_of(cross_vault(vault), prefix, "vault");
    if (vault.rib_width > 0) add_ribs(vault, prefix, pattern);
    return pattern;
}

}  // namespace voussoir::importers::patterns
