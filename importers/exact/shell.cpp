#include "importers/exact/shell.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace voussoir
{

namespace
{

struct Use {
    int forward = 0, backward = 0;
};

}  // namespace

EdgeUse edge_use(const PolygonSurface& surface)
{
    std::map<std::pair<int, int>, Use> uses;
    for (const std::vector<int>& face : surface.faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int from = face[i], to = face[(i + 1) % face.size()];
            Use& use = uses[std::minmax(from, to)];
            ++(from < to ? use.forward : use.backward);
        }
    EdgeUse result;
    for (const auto& [edge, use] : uses) {
        if (use.forward + use.backward == 1) result.open.push_back(edge);
        if (use.forward + use.backward > 2) result.branching.push_back(edge);
        if (use.forward + use.backward == 2 && use.forward != 1) result.clashing.push_back(edge);
    }
    return result;
}

int shells(const PolygonSurface& surface)
{
    std::vector<int> leader(surface.faces.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](int f) {
        while (leader[f] != f) f = leader[f] = leader[leader[f]];
        return f;
    };
    std::map<std::pair<int, int>, int> first_face;
    for (int f = 0; f < static_cast<int>(surface.faces.size()); ++f)
        for (std::size_t i = 0; i < surface.faces[f].size(); ++i) {
            const std::vector<int>& face = surface.faces[f];
            const auto [entry, is_new] =
                first_face.try_emplace(std::minmax(face[i], face[(i + 1) % face.size()]), f);
            leader[find(f)] = find(entry->second);
        }
    int count = 0;
    for (int f = 0; f < static_cast<int>(leader.size()); ++f) count += leader[f] == f;
    return count;
}

}  // namespace voussoir
