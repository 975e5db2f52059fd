#include "importers/helper/close_joints.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "libdda/contact/broad_phase.h"
#include "libdda/contact/narrow_phase.h"
#include "libdda/errors.h"

namespace voussoir::importers::helper
{

using Eigen::Vector3d;

namespace
{

constexpr double slack_share = 1e-6;  // of the size: nearer faces touch; gaps are measured so finely
constexpr double facing = 0.9998;     // cosine between the normals of faces that look at each other: 1 degree
constexpr double least_share = 0.01;  // of the smaller stone's size squared: less area does not face
constexpr double one_plane = 1e-6;    // share of the size
constexpr int max_rounds = 4;  // a face that looked at two neighbours closes the second joint in another one

struct Face {
    int stone = 0, part = 0, face = 0;
    auto operator<=>(const Face&) const = default;
};

std::vector<contact::PlacedPart> place(const ImportedMesh& mesh)
{
    std::vector<contact::PlacedPart> placed;
    for (int s = 0; s < static_cast<int>(mesh.stones.size()); ++s)
        for (int p = 0; p < static_cast<int>(mesh.stones[s].parts.size()); ++p) {
            const ConvexPolyhedron& shape = mesh.stones[s].parts[p];
            contact::PlacedPart part;
            part.block = s;
            part.part = p;
            part.shape = &shape;
            part.vertices = shape.vertices;
            part.size = std::cbrt(mesh.stones[s].moments.volume);
            part.lower = part.upper = shape.vertices.front();
            for (const Vector3d& x : shape.vertices) {
                part.lower = part.lower.cwiseMin(x);
                part.upper = part.upper.cwiseMax(x);
            }
            for (int f = 0; f < static_cast<int>(shape.faces.size()); ++f)
                part.normals.push_back(face_normal(shape, f));
            placed.push_back(std::move(part));
        }
    return placed;
}

/// Two faces that look at each other over a gap [m]; 0: they touch.
struct Joint {
    Face a, b;
    double gap = 0;
};

std::vector<Joint> joints_of(const std::vector<contact::PlacedPart>& parts, std::size_t stones, double width)
{
    std::vector<Joint> joints;
    const std::vector<double> reach(stones, width);
    contact::Candidates close;
    contact::find_candidates(parts, reach, std::vector<bool>(stones, false), 1, close);
    for (const auto& [i, j] : close.pairs) {
        const contact::PlacedPart &first = parts[i], &second = parts[j];
        const double size = std::min(first.size, second.size), slack = slack_share * size;
        const std::optional<contact::ContactPolygon> found =
            contact::contact_polygon(first, second, width + slack, std::nullopt);
        if (!found || found->edge_edge) continue;
        const contact::PlacedPart& reference = found->second_is_reference ? second : first;
        const contact::PlacedPart& incident = found->second_is_reference ? first : second;
        double area = 0, gap = 0;
        for (const contact::PolygonPoint& point : found->points) {
            area += point.area;
            gap += point.area * point.gap;
        }
        const bool faces = -incident.normals[found->incident_feature].dot(found->normal) > facing;
        if (!faces || area < least_share * size * size) continue;
        gap /= area;
        if (gap > width + slack) continue;
        joints.push_back({{reference.block, reference.part, static_cast<int>(found->reference_feature)},
                          {incident.block, incident.part, static_cast<int>(found->incident_feature)},
                          gap <= slack ? 0 : gap});
    }
    return joints;
}

/// How far each face has to go: half the width of its narrowest joint, or all of it where the other face touches
/// a third one already and stays.
std::map<Face, double> moves_of(const std::vector<Joint>& joints)
{
    std::map<Face, double> moves;
    std::set<Face> stays;
    for (const Joint& joint : joints)
        if (joint.gap == 0) stays.insert({joint.a, joint.b});
    for (const Joint& joint : joints) {
        if (joint.gap == 0) continue;
        for (const auto& [face, other] : {std::pair(joint.a, joint.b), std::pair(joint.b, joint.a)}) {
            if (stays.contains(face)) continue;
            const double step = stays.contains(other) ? joint.gap : joint.gap / 2;
            double& move = moves.try_emplace(face, step).first->second;
            move = std::min(move, step);
        }
    }
    return moves;
}

/// Adds the faces that lie in one plane with a moving one: a wall of a stone that consists of several parts.
void move_whole_planes(const Stone& stone, int number, std::map<Face, double>& moves)
{
    const double tolerance = one_plane * std::cbrt(stone.moments.volume);
    std::map<Face, double> own;
    for (const auto& [face, move] : moves)
        if (face.stone == number) own.emplace(face, move);
    for (const auto& [face, move] : own) {
        const ConvexPolyhedron& shape = stone.parts[face.part];
        const Vector3d normal = face_normal(shape, face.face), anchor = shape.vertices[shape.faces[face.face][0]];
        for (int p = 0; p < static_cast<int>(stone.parts.size()); ++p)
            for (int f = 0; f < static_cast<int>(stone.parts[p].faces.size()); ++f) {
                const ConvexPolyhedron& other = stone.parts[p];
                const Vector3d arm = other.vertices[other.faces[f][0]] - anchor;
                if (other.is_glued(f) || face_normal(other, f).dot(normal) < 1 - 1e-9) continue;
                if (std::abs(normal.dot(arm)) > tolerance) continue;
                double& least = moves.try_emplace({number, p, f}, move).first->second;
                least = std::min(least, move);
            }
    }
}

/// The part with its faces moved outward; every vertex goes to the common point of its faces.
ConvexPolyhedron grown(const ConvexPolyhedron& part, const std::vector<double>& move, const std::string& name)
{
    std::vector<Vector3d> vertices;
    for (int v = 0; v < static_cast<int>(part.vertices.size()); ++v) {
        std::vector<int> at;
        for (int f = 0; f < static_cast<int>(part.faces.size()); ++f)
            if (std::find(part.faces[f].begin(), part.faces[f].end(), v) != part.faces[f].end()) at.push_back(f);
        Eigen::MatrixXd normals(at.size(), 3);
        Eigen::VectorXd steps(at.size());
        for (std::size_t k = 0; k < at.size(); ++k) {
            normals.row(static_cast<Eigen::Index>(k)) = face_normal(part, at[k]).transpose();
            steps[static_cast<Eigen::Index>(k)] = move[at[k]];
        }
        const Vector3d shift = normals.completeOrthogonalDecomposition().solve(steps);
        vertices.push_back(part.vertices[v] + shift);
    }
    ConvexPolyhedron result = make_convex_polyhedron(vertices, part.faces, name, 1e-5);
    result.glued = part.glued;
    return result;
}

/// @returns whether anything moved
bool close_once(double width, ImportedMesh& mesh, std::map<int, double>& grew, std::map<int, std::string>& stuck)
{
    const std::vector<contact::PlacedPart> parts = place(mesh);
    std::map<Face, double> moves = moves_of(joints_of(parts, mesh.stones.size(), width));
    if (moves.empty()) return false;
    for (int s = 0; s < static_cast<int>(mesh.stones.size()); ++s) {
        Stone& stone = mesh.stones[s];
        move_whole_planes(stone, s, moves);
        std::vector<ConvexPolyhedron> shapes;
        bool moved = false;
        try {
            for (int p = 0; p < static_cast<int>(stone.parts.size()); ++p) {
                std::vector<double> move(stone.parts[p].faces.size(), 0);
                for (int f = 0; f < static_cast<int>(move.size()); ++f)
                    if (const auto found = moves.find({s, p, f}); found != moves.end()) move[f] = found->second;
                moved = moved || std::any_of(move.begin(), move.end(), [](double m) { return m > 0; });
                shapes.push_back(grown(stone.parts[p], move, stone.name));
            }
        } catch (const InputError& error) {
            stuck[s] = error.faults.front().found;
            continue;
        }
        if (!moved) continue;
        const Moments before = moments_of(stone.parts), after = moments_of(shapes);
        stone.parts = std::move(shapes);
        grew[s] += after.volume - before.volume;
        stone.moments.second += after.second - before.second;
        stone.moments.centroid += after.centroid - before.centroid;
        stone.moments.volume += after.volume - before.volume;
    }
    return true;
}

}  // namespace

void close_joints(double width, ImportedMesh& mesh)
{
    if (width <= 0 || !mesh.accepted) return;
    std::map<int, double> grew;
    std::map<int, std::string> stuck;
    for (int round = 0; round < max_rounds && close_once(width, mesh, grew, stuck); ++round) {
    }
    for (const auto& [stone, volume] : grew) {
        std::ostringstream words;
        words.precision(3);
        words << "faces at joints of at most " << width << " m were moved to the middle: the stone grew by "
              << volume << " m3";
        mesh.stones[stone].repairs.push_back({"joints closed", words.str(), 1, "", volume, "m3"});
    }
    for (const auto& [stone, why] : stuck)
        mesh.stones[stone].repairs.push_back(
            {"joints left open", "its joints were left open, because its faces cannot move that far: " + why});
}

}  // namespace voussoir::importers::helper
