#include "importers/exact/decompose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "importers/exact/cut_choice.h"
#include "importers/exact/part_of_hull.h"
#include "libdda/geometry/moments.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

constexpr double in_plane = 1e-6;    // share of the diagonal: nearer points lie in a plane; as wide as the welding
constexpr double nothing = 1e-9;     // share of the volume: smaller pieces are crumbs of rounding
constexpr std::size_t tries = 12;    // planes, of which the best is taken; fewer of large pieces
constexpr std::size_t large = 1000;  // triangles

/// A piece of the stone, with the cuts that bound it.
struct Piece {
    TriangleSurface surface, hull;
    std::vector<CutPlane> cuts;  // normals out of the piece
    std::vector<ReentrantEdge> edges;
    int at_joints = 0;   // of its edges: the first ones
    double excess = 0;   // m3, of the hull over the piece
    bool stuck = false;  // no plane cuts it
};

class Cutter
{
 public:
    Cutter(const TriangleSurface& surface, const DecomposeOptions& options)
        : options_(options), diagonal_(diagonal_of(surface.vertices)), volume_(volume_of(surface))
    {
        const std::vector<ReentrantEdge> all = reentrant_edges(surface, options.planarity * diagonal_);
        reentrant_count = static_cast<int>(all.size());
        approximate_ = reentrant_count > options.max_exact_edges || !options.joints.empty();
        pieces.push_back(make_piece(surface, {}));
    }

    void cut_all()
    {
        while (static_cast<int>(pieces.size()) < options_.max_parts) {
            const bool parted = std::all_of(pieces.begin(), pieces.end(), [](const Piece& piece) {
                return piece.at_joints == 0 || piece.stuck;
            });
            if (approximate_ && parted && excess() <= options_.volume_error * volume_) return;
            const auto worst = std::max_element(pieces.begin(), pieces.end(),
                                                [&](const Piece& a, const Piece& b) { return need(a) < need(b); });
            if (need(*worst) <= 0) return;
            cut(worst - pieces.begin());
        }
    }

    /// By how much the parts exceed the stone, as a share of its volume: what the hulls add, and what the cuts
    /// lost.
    double volume_error() const
    {
        double sum = 0;
        for (const Piece& piece : pieces) sum += volume_of(piece.hull);
        return sum / volume_ - 1;
    }
    double diagonal() const { return diagonal_; }

    std::vector<Piece> pieces;
    int reentrant_count = 0;

 private:
    double excess() const
    {
        double sum = 0;
        for (const Piece& piece : pieces) sum += piece.excess;
        return sum;
    }

    /// What there is to gain from cutting a piece; 0: nothing, or it cannot be cut.
    double need(const Piece& piece) const
    {
        return piece.edges.empty() || piece.stuck ? 0 : std::max(piece.excess, 1e-300) + piece.at_joints * volume_;
    }

    /// Puts the edges that lie in the plane of a joint first.
    void find_joints(Piece& piece) const
    {
        const double near = options_.planarity * diagonal_;
        const auto lies_in_joint = [&](const ReentrantEdge& edge) {
            return std::any_of(options_.joints.begin(), options_.joints.end(), [&](const CutPlane& joint) {
                return std::abs(joint.distance(edge.from)) <= near && std::abs(joint.distance(edge.to)) <= near;
            });
        };
        const auto free = std::stable_partition(piece.edges.begin(), piece.edges.end(), lies_in_joint);
        piece.at_joints = static_cast<int>(free - piece.edges.begin());
    }

    Piece make_piece(const TriangleSurface& surface, std::vector<CutPlane> cuts) const
    {
        Piece piece{surface, convex_hull(surface.vertices), std::move(cuts), {}, 0, 0, false};
        piece.excess = volume_of(piece.hull) - volume_of(surface);
        piece.edges = reentrant_edges(surface, options_.planarity * diagonal_);
        if (approximate_) weight_by_depth(piece.edges, piece.hull);
        find_joints(piece);
        return piece;
    }

    std::vector<Piece> pieces_of(const Halves& halves, const CutPlane& plane, const Piece& whole) const
    {
        std::vector<Piece> made;
        std::vector<CutPlane> cuts = whole.cuts;
        cuts.push_back(plane);
        for (const bool behind : {true, false}) {
            if (!behind) cuts.back().normal = -plane.normal;
            for (const TriangleSurface& surface : behind ? halves.behind : halves.before)
                if (volume_of(surface) > nothing * volume_) made.push_back(make_piece(surface, cuts));
        }
        return made;
    }

    /// A cut that makes needles may hide a reentrant edge between them: a piece that shows none must be its own
    /// hull, but for faces that bulge within the planarity.
    bool is_sound(const Piece& piece) const
    {
        return !piece.edges.empty() || piece.excess <= options_.planarity * diagonal_ * area_of(piece.hull);
    }

    /// How much is left to do; the smaller the better.
    double remainder(const std::vector<Piece>& made) const
    {
        double sum = 0;
        for (const Piece& piece : made) {
            sum += approximate_ ? piece.excess + piece.at_joints * volume_
                                : 2.0 * static_cast<double>(piece.edges.size()) + 1;
            if (!is_sound(piece)) sum += approximate_ ? piece.excess : 1000;
        }
        return sum;
    }

    bool keeps_volume(const std::vector<Piece>& made, const Piece& whole) const
    {
        double sum = 0;
        for (const Piece& piece : made) sum += volume_of(piece.surface);
        return std::abs(sum - volume_of(whole.surface)) <= 1e-6 * volume_;
    }

    /// What is left of a piece by the best of `count` planes through some of its edges; nothing if none cuts it.
    std::vector<Piece> best_cut(const Piece& piece, const std::vector<ReentrantEdge>& edges,
                                std::size_t count) const
    {
        std::vector<Piece> best;
        for (const CutPlane& plane : cutting_planes(piece.surface, edges, in_plane * diagonal_, count)) {
            const std::optional<Halves> halves = cut_solid(piece.surface, plane, in_plane * diagonal_);
            if (!halves) continue;
            std::vector<Piece> made = pieces_of(*halves, plane, piece);
            if (made.size() < 2 || !keeps_volume(made, piece)) continue;
            if (best.empty() || remainder(made) < remainder(best)) best = std::move(made);
        }
        return best;
    }

    void cut(std::size_t index)
    {
        Piece& piece = pieces[index];
        const std::size_t count =
            std::clamp<std::size_t>(tries * large / piece.surface.triangles.size(), 1, tries);
        std::vector<ReentrantEdge> edges = piece.edges;
        if (piece.at_joints > 0) edges.resize(piece.at_joints);
        std::vector<Piece> best = best_cut(piece, edges, count);
        if (best.empty() && edges.size() < piece.edges.size()) best = best_cut(piece, piece.edges, count);
        if (best.empty()) {
            piece.stuck = true;
            return;
        }
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(index));
        std::move(best.begin(), best.end(), std::back_inserter(pieces));
    }

    DecomposeOptions options_;
    double diagonal_, volume_;
    bool approximate_ = false;
};

}  // namespace

Decomposition decompose(const TriangleSurface& surface, const DecomposeOptions& options, const std::string& name)
{
    Cutter cutter(surface, options);
    cutter.cut_all();
    Decomposition result;
    result.reentrant_edges = cutter.reentrant_count;
    result.volume_error = cutter.volume_error();
    if (std::abs(result.volume_error) > options.volume_error) {
        const bool full = static_cast<int>(cutter.pieces.size()) >= options.max_parts;
        result.reason = full ? "needs more than " + std::to_string(options.max_parts) + " convex parts"
                             : "some of its parts could not be cut any further";
        return result;
    }
    for (const Piece& piece : cutter.pieces)
        result.parts.push_back(part_of_hull(piece.hull, piece.cuts, options.planarity, cutter.diagonal(), name));
    return result;
}

}  // namespace voussoir::importers::exact
