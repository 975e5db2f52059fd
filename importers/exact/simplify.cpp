#include "importers/exact/simplify.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "importers/exact/best_cut.h"
#include "importers/exact/clipped_volume.h"
#include "importers/exact/glued_faces.h"
#include "importers/exact/part_of_hull.h"
#include "importers/exact/smoothed_hull.h"

namespace voussoir::importers::exact
{

namespace
{

constexpr std::size_t coarse_vertices = 1000;
constexpr double in_plane = 1e-5;       // share of the diagonal
constexpr double least_piece = 2e-3;    // share of the volume: smaller pieces are crumbs
constexpr double least_gain = 1e-4;     // share of the volume: less is not worth a part
constexpr double max_smoothing = 1e-2;  // share of the diagonal
constexpr int smoothing_steps = 8;      // of a bisection

struct Leaf {
    Cell coarse, full;
    TriangleSurface hull;  // of `full`
    std::optional<BestCut> cut;
    double gain = 0;  // m3, of the cut
};

class Divider
{
 public:
    Divider(const TriangleSurface& surface, const SimplifyOptions& options)
        : surface_(surface),
          coarse_(coarsened(surface, coarse_vertices)),
          options_(options),
          diagonal_(diagonal_of(surface.vertices)),
          volume_(volume_of(surface))
    {
        leaves.push_back(made({{}, coarse_, {}}, {{}, surface_, {}}));
    }

    void divide()
    {
        while (static_cast<int>(leaves.size()) < options_.max_parts && volume_error() > options_.volume_error) {
            const auto best = std::max_element(leaves.begin(), leaves.end(),
                                               [](const Leaf& a, const Leaf& b) { return a.gain < b.gain; });

            if (best->gain <= least_gain * volume_) return;
            const CutPlane plane = best->cut->plane;
            auto [coarse_behind, coarse_before] = divided(best->coarse, plane, coarse_);
            auto [behind, before] = divided(best->full, plane, surface_);
            *best = made(std::move(coarse_behind), std::move(behind));
            leaves.push_back(made(std::move(coarse_before), std::move(before)));
        }
    }

    double volume_error() const
    {
        double sum = 0;
        for (const Leaf& leaf : leaves) sum += volume_of(leaf.hull);
        return sum / volume_ - 1;
    }
    double diagonal() const { return diagonal_; }

    /// Drops corners until the parts exceed the stone by no more than is allowed, if that can be.
    /// @returns by how much the highest of them may have stood out [m]
    double smooth()
    {
        if (options_.volume_error == 0 || volume_error() <= options_.volume_error) return 0;
        const std::vector<Eigen::Vector3d> kept = underside_of(convex_hull(surface_.vertices));
        double too_little = 0, enough = max_smoothing * diagonal_;
        std::vector<TriangleSurface> smooth = smoothed(kept, enough);
        if (excess_of(smooth) > options_.volume_error) return 0;
        for (int step = 0; step < smoothing_steps; ++step) {
            const double height = 0.5 * (too_little + enough);
            std::vector<TriangleSurface> tried = smoothed(kept, height);
            if (excess_of(tried) > options_.volume_error) {
                too_little = height;
                continue;
            }
            enough = height;
            smooth = std::move(tried);
        }
        for (std::size_t i = 0; i < leaves.size(); ++i) leaves[i].hull = std::move(smooth[i]);
        return enough;
    }

    /// Share of the stone's volume that its hulls leave out.
    double lack() const
    {
        double inside = 0;
        for (const Leaf& leaf : leaves) {
            std::vector<CutPlane> planes = leaf.full.walls;
            for (const Eigen::Vector3i& t : leaf.hull.triangles)
                planes.push_back({leaf.hull.vertices[t[0]], normal_of(leaf.hull, t).normalized()});
            inside += clipped_volume(surface_, planes);
        }
        return std::max(0.0, 1 - inside / volume_);
    }

    std::vector<Leaf> leaves;

 private:
    Leaf made(Cell coarse, Cell full) const
    {
        Leaf leaf{std::move(coarse), std::move(full), {}, {}, 0};
        leaf.hull = hull_of(leaf.full);
        leaf.cut = best_cut(leaf.coarse, coarse_, in_plane * diagonal_, least_piece * volume_);
        if (leaf.cut) leaf.gain = volume_of(hull_of(leaf.coarse)) - leaf.cut->volume;
        return leaf;
    }

    std::vector<TriangleSurface> smoothed(const std::vector<Eigen::Vector3d>& kept, double height) const
    {
        std::vector<TriangleSurface> hulls;
        for (const Leaf& leaf : leaves) hulls.push_back(smoothed_hull(leaf.hull, kept, height));
        return hulls;
    }

    double excess_of(const std::vector<TriangleSurface>& hulls) const
    {
        double sum = 0;
        for (const TriangleSurface& hull : hulls) sum += volume_of(hull);
        return sum / volume_ - 1;
    }

    const TriangleSurface& surface_;
    TriangleSurface coarse_;
    SimplifyOptions options_;
    double diagonal_, volume_;
};

std::string percent(double share)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2g %%", 100 * share);  // NOLINT: the pattern is a literal
    return text;
}

/// How deep the vertices of the stone lie below the outer faces of their parts [m].
double depth_below(const Leaf& leaf, const ConvexPolyhedron& part)
{
    std::vector<CutPlane> outer;
    for (int f = 0; f < static_cast<int>(part.faces.size()); ++f)
        if (!part.is_glued(f)) outer.push_back({part.vertices[part.faces[f].front()], face_normal(part, f)});
    double deepest = 0;
    for (const Eigen::Vector3d& x : leaf.full.surface.vertices) {
        double depth = outer.empty() ? 0 : 1e300;
        for (const CutPlane& face : outer) depth = std::min(depth, std::abs(face.distance(x)));
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

}  // namespace

SimplifiedStone simplify(const TriangleSurface& surface, const SimplifyOptions& options, const std::string& name)
{
    Divider divider(surface, options);
    divider.divide();
    SimplifiedStone result;
    result.smoothed = divider.smooth();
    result.volume_error = divider.volume_error();
    const std::size_t count = divider.leaves.size();
    if (options.volume_error > 0 && result.volume_error > options.volume_error) {
        const bool full = static_cast<int>(count) >= options.max_parts;
        result.reason = std::to_string(count) + " convex parts exceed it by " + percent(result.volume_error) +
                        " of its volume, " + percent(options.volume_error) + " is allowed" +
                        (full ? "" : ", and no further cut brings them nearer");
        return result;
    }
    if (result.smoothed > 0) result.lack = divider.lack();
    for (const Leaf& leaf : divider.leaves)
        result.parts.push_back(
            part_of_hull(leaf.hull, leaf.full.walls, options.planarity, divider.diagonal(), name));
    free_uncovered_faces(result.parts, options.planarity * divider.diagonal());
    for (std::size_t i = 0; i < count; ++i)
        result.depth = std::max(result.depth, depth_below(divider.leaves[i], result.parts[i]));
    return result;
}

}  // namespace voussoir::importers::exact
