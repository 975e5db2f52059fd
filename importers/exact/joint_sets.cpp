#include "importers/exact/joint_sets.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <map>

#include "importers/exact/merge_small.h"
#include "libdda/errors.h"

namespace voussoir::importers::exact
{
namespace
{

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = ExactKernel::Point_3;
using Plane = ExactKernel::Plane_3;
using Number = ExactKernel::FT;

constexpr int outer_face = -1;

/// A face of a piece, counter-clockwise from outside.
struct Face {
    std::vector<int> loop;
    int inner = outer_face;  // which face between two parts of the domain it is part of
};

/// A convex piece of one part of the domain.
struct Piece {
    std::vector<Point> points;
    std::vector<Face> faces;
    std::vector<bool> sides;       // of all joints that were to cut it: which side it lies on
    std::vector<bool> considered;  // whether they did
    std::uint64_t mark = 0;        // a number of both, equal for pieces of one block
};

std::uint64_t mixed(std::uint64_t bits)
{
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31);
}

/// >= 0 and < 1, of a number. Source: [SteeleLeaFlood2014] (splitmix64).
double share_of(std::uint64_t bits)
{
    return static_cast<double>(mixed(bits) >> 11) * 0x1p-53;
}

Point exact(const Eigen::Vector3d& x)
{
    return {x.x(), x.y(), x.z()};
}

/// One side of a piece. @param signs of its points against the joint @param keep the sign that stays
Piece side_of(const Piece& whole, const Plane& plane, const std::vector<int>& signs, int keep)
{
    Piece half;
    half.mark = mixed(whole.mark * 3 + (keep > 0 ? 1 : 2));
    std::map<int, int> kept;
    std::map<std::pair<int, int>, int> cut;
    const auto keep_point = [&](int i) {
        const auto [place, is_new] = kept.try_emplace(i, static_cast<int>(half.points.size()));
        if (is_new) half.points.push_back(whole.points[i]);
        return place->second;
    };
    const auto cut_edge = [&](int i, int j) {
        const auto [place, is_new] = cut.try_emplace(std::minmax(i, j), static_cast<int>(half.points.size()));
        if (is_new) {
            // Both halves, and both pieces at an edge, get the same exact point.
            const auto [a, b] = std::minmax(i, j);
            const auto at = CGAL::intersection(plane, ExactKernel::Line_3(whole.points[a], whole.points[b]));
            half.points.push_back(*boost::get<Point>(&*at));
        }
        return place->second;
    };
    std::map<int, int> next;  // of the cap, against the sense of the faces that it closes
    for (const Face& face : whole.faces) {
        Face own{{}, face.inner};
        std::vector<int> on_plane;
        const std::size_t n = face.loop.size();
        for (std::size_t k = 0; k < n; ++k) {
            const int i = face.loop[k], j = face.loop[(k + 1) % n];
            if (signs[i] == keep || signs[i] == 0) own.loop.push_back(keep_point(i));
            if (signs[i] * signs[j] < 0) own.loop.push_back(cut_edge(i, j));
        }
        if (own.loop.size() < 3) continue;
        const auto lies_in_plane = [&](int point) { return plane.has_on(half.points[point]); };
        if (std::all_of(own.loop.begin(), own.loop.end(), lies_in_plane)) continue;
        for (std::size_t k = 0; k < own.loop.size(); ++k) {
            const int i = own.loop[k], j = own.loop[(k + 1) % own.loop.size()];
            if (lies_in_plane(i) && lies_in_plane(j)) next[j] = i;
        }
        half.faces.push_back(std::move(own));
    }
    Face cap;
    const int first = next.begin()->first;
    for (int point = first; cap.loop.empty() || point != first; point = next.at(point)) cap.loop.push_back(point);
    half.faces.push_back(std::move(cap));
    return half;
}

/// Cuts pieces by one joint, or leaves them whole.
void cut_by(const Plane& plane, double persistence, std::uint64_t number, std::vector<Piece>& pieces)
{
    std::vector<Piece> all;
    for (Piece& piece : pieces) {
        std::vector<int> signs;
        for (const Point& x : piece.points) signs.push_back(static_cast<int>(plane.oriented_side(x)));
        const bool before = std::any_of(signs.begin(), signs.end(), [](int s) { return s > 0; });
        const bool behind = std::any_of(signs.begin(), signs.end(), [](int s) { return s < 0; });
        // Pieces of one block at both sides of a face inside the domain have the same mark, and the same fate.
        const bool ends_here = persistence < 1 && share_of(piece.mark ^ mixed(number)) >= persistence;
        if (ends_here) {
            piece.mark = mixed(piece.mark * 3);
            all.push_back(std::move(piece));
        } else if (before && behind) {
            all.push_back(side_of(piece, plane, signs, 1));
            all.push_back(side_of(piece, plane, signs, -1));
        } else {
            piece.mark = mixed(piece.mark * 3 + (before ? 1 : 2));
            all.push_back(std::move(piece));
        }
    }
    pieces = std::move(all);
}

/// Which joints of a set can meet the body, and where they lie [m from the origin along the normal].
std::vector<double> places_of(const JointSet& set, const RockRequest& request, std::uint64_t number)
{
    double low = 1e300, high = -1e300;
    for (const ConvexPolyhedron& part : request.domain)
        for (const Eigen::Vector3d& x : part.vertices) {
            const double at = set.normal.dot(x - set.origin);
            low = std::min(low, at);
            high = std::max(high, at);
        }
    if ((high - low) / set.spacing > 1e5)
        throw InputError("spacing", "more than 100000 joints in a set", "give a larger spacing");
    std::vector<double> places;
    for (auto k = static_cast<long>(std::floor(low / set.spacing)) - 1; k * set.spacing <= high + set.spacing;
         ++k) {
        const double off = 2 * share_of(mixed(request.seed) ^ mixed(number) ^ static_cast<std::uint64_t>(k)) - 1;
        places.push_back((static_cast<double>(k) + set.scatter * off) * set.spacing);
    }
    return places;
}

/// The parts of the domain as pieces; faces that two of them share are numbered.
std::vector<Piece> pieces_of(const std::vector<ConvexPolyhedron>& domain, std::uint64_t seed)
{
    std::map<std::vector<Point>, int> inner;
    std::vector<Piece> pieces;
    for (const ConvexPolyhedron& part : domain) {
        Piece piece;
        piece.mark = mixed(seed);
        for (const Eigen::Vector3d& x : part.vertices) piece.points.push_back(exact(x));
        for (std::size_t f = 0; f < part.faces.size(); ++f) {
            Face face{part.faces[f], outer_face};
            if (part.is_glued(static_cast<int>(f))) {
                std::vector<Point> key;
                for (const int v : face.loop) key.push_back(piece.points[v]);
                std::sort(key.begin(), key.end());
                face.inner = inner.try_emplace(key, static_cast<int>(inner.size())).first->second;
            }
            piece.faces.push_back(std::move(face));
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// The nearest double of an exact number.
double rounded(const Number& number)
{
    return CGAL::to_double(CGAL::exact(number));
}

Number piece_volume(const Piece& piece)
{
    Number six(0);
    const Point& apex = piece.points.front();
    for (const Face& face : piece.faces)
        for (std::size_t i = 1; i + 1 < face.loop.size(); ++i)
            six += CGAL::determinant(piece.points[face.loop[0]] - apex, piece.points[face.loop[i]] - apex,
                                     piece.points[face.loop[i + 1]] - apex);
    return six / 6;
}

ConvexPolyhedron rounded(const Piece& piece)
{
    std::vector<Eigen::Vector3d> vertices;
    for (const Point& x : piece.points)
        vertices.emplace_back(CGAL::to_double(x.x()), CGAL::to_double(x.y()), CGAL::to_double(x.z()));
    std::vector<std::vector<int>> faces;
    std::vector<bool> glued;
    for (const Face& face : piece.faces) {
        faces.push_back(face.loop);
        glued.push_back(face.inner != outer_face);
    }
    ConvexPolyhedron shape = make_convex_polyhedron(std::move(vertices), std::move(faces), "a rock block", 1e-5);
    if (std::find(glued.begin(), glued.end(), true) != glued.end()) shape.glued = std::move(glued);
    return shape;
}

/// Pieces that belong together: the same mark, and a common face inside the domain. Indices by block.
std::vector<std::vector<std::size_t>> blocks_of(const std::vector<Piece>& pieces)
{
    std::vector<std::size_t> root(pieces.size());
    for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
    const auto find = [&](std::size_t i) {
        while (root[i] != i) i = root[i];
        return i;
    };
    std::map<std::pair<std::uint64_t, int>, std::size_t> owner;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (const Face& face : pieces[i].faces) {
            if (face.inner == outer_face) continue;
            const auto [place, is_new] = owner.try_emplace({pieces[i].mark, face.inner}, i);
            if (!is_new) root[std::max(find(i), find(place->second))] = std::min(find(i), find(place->second));
        }
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < pieces.size(); ++i) members[find(i)].push_back(i);
    std::vector<std::vector<std::size_t>> blocks;
    blocks.reserve(members.size());
    for (auto& [first, own] : members) blocks.push_back(std::move(own));
    return blocks;
}

/// @param all its exact volume is added [m3]
RockBlock block_of(const std::vector<std::size_t>& members, const std::vector<Piece>& pieces, Number& all)
{
    Number volume(0);
    for (const std::size_t piece : members) volume += piece_volume(pieces[piece]);
    all += volume;
    return {{}, rounded(volume)};
}

/// Gives a block its parts. @returns false for one too small, and too thin for doubles
bool shape(const std::vector<std::size_t>& members, const std::vector<Piece>& pieces, const RockRequest& request,
           RockBlock& block)
{
    try {
        for (const std::size_t piece : members) block.parts.push_back(rounded(pieces[piece]));
        return true;
    } catch (const InputError&) {
        if (block.volume >= request.smallest) throw;
        return false;
    }
}

}  // namespace

CutRock cut_rock(const RockRequest& request)
{
    std::vector<Piece> pieces = pieces_of(request.domain, request.seed);
    CutRock rock;
    Number domain(0), all(0);
    for (const Piece& piece : pieces) domain += piece_volume(piece);
    for (std::size_t s = 0; s < request.sets.size(); ++s) {
        const JointSet& set = request.sets[s];
        const ExactKernel::Vector_3 normal(set.normal.x(), set.normal.y(), set.normal.z());
        std::uint64_t number = s << 32U;
        for (const double place : places_of(set, request, s)) {
            cut_by(Plane(exact(set.origin + place * set.normal), normal), set.persistence, ++number, pieces);
            if (pieces.size() > request.most)
                throw InputError("sets", "more than " + std::to_string(request.most) + " blocks",
                                 "give larger spacings or a smaller domain");
        }
    }
    const std::vector<std::vector<std::size_t>> blocks = blocks_of(pieces);
    for (const std::vector<std::size_t>& members : blocks) {
        RockBlock block = block_of(members, pieces, all);
        // A piece too thin for doubles merges with none.
        if (!request.merge && block.volume < request.smallest)
            leave_out(block, rock);
        else if (shape(members, pieces, request, block))
            rock.blocks.push_back(std::move(block));
        else
            leave_out(block, rock);
    }
    if (request.merge) merge_small(request.smallest, rock);
    rock.domain_volume = rounded(domain);
    rock.volume = rounded(all);
    return rock;
}

}  // namespace voussoir::importers::exact
