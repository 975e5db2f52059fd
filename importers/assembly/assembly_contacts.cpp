#include "importers/assembly/assembly_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "libdda/contact/find_contacts.h"
#include "libdda/model/state.h"

namespace voussoir::importers::assembly
{
namespace
{

using Eigen::Vector3d;
using Polygon = std::vector<Vector3d>;
using Pair = std::pair<int, int>;

constexpr double max_gap_tilt = 0.35;        // rad: faces at a larger angle do not face each other
constexpr double least_gap_depth = 2;        // a gap is at most as wide as the root of its area over this
constexpr double least_facing_share = 0.02;  // of the squared size of the smaller stone

/// The stones as a model of rigid blocks, for the engine's contact search. Materials do not matter to it.
Model model_of(const std::vector<AssemblyStone>& stones)
{
    JointMaterial joint;
    joint.stiffness = {ContactStiffness::Kind::per_area, 1, 1};
    joint.face = FaceLaw::corners;  // outlines are asked for
    Model model = make_model(Kinematics::spatial_rigid, {"stone", 1, 1, 0}, joint);
    for (const AssemblyStone& stone : stones) model.blocks.push_back(make_block(stone.name, 0, 0, stone.parts));
    return model;
}

/// All contact patches with a reach of `share` of each block's size.
ContactSet search(const Model& model, const State& state, double share)
{
    std::vector<double> reach(model.blocks.size());
    for (std::size_t b = 0; b < reach.size(); ++b) reach[b] = share * size_of(model, static_cast<int>(b));
    contact::SearchMemory<3> memory;
    ContactSet found;
    contact::find_contacts<3>(model, state, reach, 1, memory, found);
    return found;
}

std::span<const ContactPoint> points_of(const ContactSet& contacts, const ContactPatch& patch)
{
    return std::span(contacts.points).subspan(patch.first_point, patch.point_count);
}

/// Twice the vector area of a loop.
Vector3d twice_area(const Polygon& polygon)
{
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    return sum;
}

/// Area, seen along the normal, of that share of a contact polygon whose gap is below a limit: the polygon is
/// plane, so that the gap is linear on it and the limit is a straight cut.
double area_closer_than(std::span<const ContactPoint> points, const Vector3d& normal, double limit)
{
    Polygon kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ContactPoint& here = points[i];
        const ContactPoint& next = points[(i + 1) % points.size()];
        if (here.gap <= limit) kept.push_back(here.position);
        if ((here.gap <= limit) != (next.gap <= limit))
            kept.push_back(here.position +
                           (limit - here.gap) / (next.gap - here.gap) * (next.position - here.position));
    }
    return kept.size() < 3 ? 0 : 0.5 * std::abs(normal.dot(twice_area(kept)));
}

double face_area(const AssemblyStone& stone, int part, std::uint32_t face)
{
    const ConvexPolyhedron& shape = stone.parts[part];
    Polygon loop;
    for (const int v : shape.faces[face]) loop.push_back(shape.vertices[v]);
    return 0.5 * twice_area(loop).norm();
}

/// Half way between the two faces.
Polygon middle_polygon(std::span<const ContactPoint> points, const Vector3d& normal)
{
    Polygon polygon;
    for (const ContactPoint& point : points) polygon.push_back(point.position - 0.5 * point.gap * normal);
    return polygon;
}

void add_patch(const std::vector<AssemblyStone>& stones, const ContactSet& found, const ContactPatch& patch,
               double tolerance, StoneContact& contact)
{
    const std::span<const ContactPoint> points = points_of(found, patch);
    if (contact.patches++ == 0) contact.smallest_gap = points.front().gap;
    double facing = 0;
    for (const ContactPoint& point : points) {
        contact.smallest_gap = std::min(contact.smallest_gap, point.gap);
        contact.largest_gap = std::max(contact.largest_gap, point.gap);
        facing += point.area;
    }
    const Vector3d from_a_to_b = patch.block_b == contact.b ? Vector3d(-patch.normal) : patch.normal;
    if (patch.edge_edge) {  // its area is a convention of the engine
        if (contact.area == 0) contact.normal += 1e-9 * from_a_to_b;
        contact.polygons.push_back({points.front().position});
        return;
    }
    const double smaller = std::min(face_area(stones[patch.block_a], patch.part_a, patch.feature_a),
                                    face_area(stones[patch.block_b], patch.part_b, patch.feature_b));
    contact.smaller_face = std::max(contact.smaller_face, smaller);
    contact.facing_area += facing;
    contact.area += area_closer_than(points, patch.normal, tolerance);
    contact.normal += facing * from_a_to_b;
    contact.polygons.push_back(middle_polygon(points, patch.normal));
}

Touch kind_of(const StoneContact& contact)
{
    if (contact.facing_area == 0) return Touch::edge;
    if (contact.facing_area < assembly_tolerance::sliver_share * contact.smaller_face) return Touch::corner;
    if (contact.area < assembly_tolerance::touching_share * contact.facing_area) return Touch::tilted;
    return Touch::face;
}

std::vector<StoneContact> contacts_of(const Assembly& assembly, const Model& model, const State& state)
{
    const ContactSet found = search(model, state, assembly_tolerance::contact);
    std::map<Pair, StoneContact> pairs;
    for (const ContactPatch& patch : found.patches) {
        const auto [a, b] = std::minmax(patch.block_a, patch.block_b);
        StoneContact& contact = pairs[{a, b}];
        contact.a = a;
        contact.b = b;
        const double tolerance = assembly_tolerance::contact * (size_of(model, a) + size_of(model, b));
        add_patch(assembly.stones, found, patch, tolerance, contact);
    }
    std::vector<StoneContact> contacts;
    for (auto& [pair, contact] : pairs) {
        if (contact.normal.norm() > 0) contact.normal.normalize();
        contact.touch = kind_of(contact);
        contacts.push_back(std::move(contact));
    }
    return contacts;
}

bool is_inside(const AssemblyStone& stone, const Vector3d& point)
{
    return std::any_of(stone.parts.begin(), stone.parts.end(), [&](const ConvexPolyhedron& part) {
        for (int face = 0; face < static_cast<int>(part.faces.size()); ++face)
            if (face_normal(part, face).dot(point - part.vertices[part.faces[face].front()]) > 0) return false;
        return true;
    });
}

/// Is the room between two stones taken by others (a course of tiles, mortar drawn as stones)?
bool is_filled(const Polygon& middle, const std::set<int>& others, const std::vector<AssemblyStone>& stones)
{
    Vector3d centre = Vector3d::Zero();
    for (const Vector3d& x : middle) centre += x / static_cast<double>(middle.size());
    std::size_t filled = 0;
    for (const Vector3d& corner : middle) {
        const Vector3d sample = 0.5 * (centre + corner);
        filled +=
            std::any_of(others.begin(), others.end(), [&](int stone) { return is_inside(stones[stone], sample); });
    }
    return 2 * filled >= middle.size();
}

/// Do the faces of a patch face each other, so near and over so much area that they were meant to touch?
bool is_meant_to_touch(const ContactSet& found, const ContactPatch& patch, double size)
{
    if (patch.edge_edge) return false;
    const std::span<const ContactPoint> points = points_of(found, patch);
    Polygon polygon;
    double area = 0, mean = 0;
    for (const ContactPoint& point : points) {
        polygon.push_back(point.position);
        area += point.area;
        mean += point.area * point.gap;
    }
    mean /= area;
    const Vector3d own = twice_area(polygon);
    const bool faces = std::abs(own.normalized().dot(patch.normal)) > std::cos(max_gap_tilt);
    return faces && area > least_facing_share * size * size && mean <= assembly_tolerance::gap * size &&
           mean * least_gap_depth <= std::sqrt(area);
}

void add_patch(const ContactSet& found, const ContactPatch& patch, StoneGap& gap)
{
    const std::span<const ContactPoint> points = points_of(found, patch);
    double area = 0, volume = 0;
    for (const ContactPoint& point : points) {
        area += point.area;
        volume += point.area * point.gap;
        gap.widest = std::max(gap.widest, point.gap);
    }
    gap.width = (gap.width * gap.area + volume) / (gap.area + area);
    gap.area += area;
    gap.polygons.push_back(middle_polygon(points, patch.normal));
}

std::vector<StoneGap> gaps_of(const Assembly& assembly, const Model& model, const State& state)
{
    const ContactSet near = search(model, state, assembly_tolerance::gap);
    std::set<Pair> touching;
    for (const StoneContact& contact : assembly.contacts) touching.insert({contact.a, contact.b});
    std::vector<std::set<int>> neighbours(assembly.stones.size());
    for (const ContactPatch& patch : near.patches) {
        neighbours[patch.block_a].insert(patch.block_b);
        neighbours[patch.block_b].insert(patch.block_a);
    }
    std::map<Pair, StoneGap> pairs;
    for (const ContactPatch& patch : near.patches) {
        const auto [a, b] = std::minmax(patch.block_a, patch.block_b);
        if (touching.contains({a, b})) continue;
        if (!is_meant_to_touch(near, patch, std::min(size_of(model, a), size_of(model, b)))) continue;
        std::set<int> others = neighbours[a];
        others.erase(b);
        if (is_filled(middle_polygon(points_of(near, patch), patch.normal), others, assembly.stones)) continue;
        StoneGap& gap = pairs[{a, b}];
        gap.a = a;
        gap.b = b;
        add_patch(near, patch, gap);
    }
    std::vector<StoneGap> gaps;
    for (auto& [pair, gap] : pairs) gaps.push_back(std::move(gap));
    return gaps;
}

}  // namespace

void find_contacts_and_gaps(Assembly& assembly)
{
    const Model model = model_of(assembly.stones);
    const State state = initial_state(model);
    assembly.contacts = contacts_of(assembly, model, state);
    assembly.gaps = gaps_of(assembly, model, state);
}

}  // namespace voussoir::importers::assembly
