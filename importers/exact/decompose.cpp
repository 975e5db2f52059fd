#include "importers/exact/decompose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "importers/exact/cut_choice.h"
#include "importers/exact/weld.h"
#include "libdda/errors.h"
#include "libdda/geometry/moments.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

constexpr double same_point = 1e-9;  // share of the diagonal
constexpr double nothing = 1e-9;     // share of the volume: smaller pieces are crumbs of rounding
constexpr std::size_t tries = 12;    // planes, before a piece is left as it is

struct CutFace {
    Vector3d anchor, normal;
};

/// A piece of the stone, with the cuts that bound it.
struct Piece {
    ExactSolid solid;
    std::vector<CutFace> cuts;
    TriangleSurface surface, hull;
    std::vector<ReentrantEdge> edges;
    double excess = 0;   // m3, of the hull over the piece
    bool stuck = false;  // no plane cuts it
};

double volume_of(const TriangleSurface& surface)
{
    return surface.triangles.empty() ? 0 : moments_of_surface(surface.vertices, surface.triangles).volume;
}

double diagonal_of(const TriangleSurface& surface)
{
    Vector3d lower = surface.vertices.front(), upper = lower;
    for (const Vector3d& x : surface.vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    return (upper - lower).norm();
}

class Cutter
{
 public:
    Cutter(const TriangleSurface& surface, const DecomposeOptions& options)
        : options_(options),
          diagonal_(diagonal_of(surface)),
          volume_(volume_of(surface)),
          lines_(reentrant_edges(surface, options.planarity * diagonal_)),
          exact_(static_cast<int>(lines_.size()) <= options.most_exact_edges)
    {
        add(ExactSolid(surface), {});
    }

    void cut_all()
    {
        while (static_cast<int>(pieces_.size()) < options_.most_parts) {
            if (!exact_ && excess() <= options_.volume_error * volume_) return;
            const auto worst = std::max_element(pieces_.begin(), pieces_.end(),
                                                [&](const Piece& a, const Piece& b) { return need(a) < need(b); });
            if (need(*worst) <= 0) return;
            cut(worst - pieces_.begin());
        }
    }

    const std::vector<Piece>& pieces() const { return pieces_; }
    double excess() const
    {
        double sum = 0;
        for (const Piece& piece : pieces_) sum += piece.excess;
        return sum;
    }
    double volume() const { return volume_; }
    double diagonal() const { return diagonal_; }
    int reentrant_count() const { return static_cast<int>(lines_.size()); }

 private:
    /// What there is to gain from cutting a piece; 0: nothing, or it cannot be cut.
    static double need(const Piece& piece)
    {
        return piece.edges.empty() || piece.stuck ? 0 : std::max(piece.excess, 1e-300);
    }

    void add(ExactSolid solid, std::vector<CutFace> cuts)
    {
        Piece piece{std::move(solid), std::move(cuts), {}, {}, {}, 0, false};
        piece.surface = piece.solid.rounded();
        const double own = volume_of(piece.surface);
        if (own <= nothing * volume_) return;
        piece.hull = convex_hull(piece.surface.vertices);
        piece.excess = volume_of(piece.hull) - own;
        piece.edges = reentrant_edges(piece.surface, options_.planarity * diagonal_);
        put_on_lines(piece.edges, lines_, same_point * diagonal_);
        if (!exact_) weight_by_depth(piece.edges, piece.hull);
        pieces_.push_back(std::move(piece));
    }

    void cut(std::size_t index)
    {
        Piece& piece = pieces_[index];
        for (const ExactPlane& plane : cutting_planes(piece.surface, piece.edges, same_point * diagonal_, tries)) {
            std::optional<ExactSolid::Halves> halves = piece.solid.cut(plane);
            if (!halves) continue;
            const Vector3d front = (plane[1] - plane[0]).cross(plane[2] - plane[0]).normalized();
            std::vector<CutFace> cuts = std::move(piece.cuts);
            pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(index));
            cuts.push_back({plane[0], front});
            for (ExactSolid& part : halves->behind) add(std::move(part), cuts);
            cuts.back().normal = -front;
            for (ExactSolid& part : halves->before) add(std::move(part), cuts);
            return;
        }
        piece.stuck = true;
    }

    DecomposeOptions options_;
    double diagonal_, volume_;
    std::vector<ReentrantEdge> lines_;
    bool exact_;
    std::vector<Piece> pieces_;
};

/// The hull of a piece; the faces in its cuts are glued.
ConvexPolyhedron part_of(const Piece& piece, double planarity, double diagonal, const std::string& name)
{
    PolygonSurface merged{name, piece.hull.vertices, {}};
    for (const Eigen::Vector3i& t : piece.hull.triangles) merged.faces.push_back({t[0], t[1], t[2]});
    merged.faces = merge_coplanar_faces(merged.vertices, std::move(merged.faces), planarity / 4);
    drop_unused_vertices(merged);
    ConvexPolyhedron part = make_convex_polyhedron(merged.vertices, merged.faces, name, planarity);
    for (const std::vector<int>& face : part.faces)
        part.glued.push_back(std::any_of(piece.cuts.begin(), piece.cuts.end(), [&](const CutFace& cut) {
            return std::all_of(face.begin(), face.end(), [&](int v) {
                return std::abs(cut.normal.dot(part.vertices[v] - cut.anchor)) <= planarity * diagonal;
            });
        }));
    return part;
}

}  // namespace

Decomposition decompose(const TriangleSurface& surface, const DecomposeOptions& options, const std::string& name)
{
    Cutter cutter(surface, options);
    cutter.cut_all();
    Decomposition result;
    result.reentrant_edges = cutter.reentrant_count();
    result.volume_error = cutter.excess() / cutter.volume();
    if (result.volume_error > options.volume_error) {
        result.reason = "needs more than " + std::to_string(options.most_parts) + " convex parts";
        return result;
    }
    for (const Piece& piece : cutter.pieces())
        result.parts.push_back(part_of(piece, options.planarity, cutter.diagonal(), name));
    return result;
}

}  // namespace voussoir
