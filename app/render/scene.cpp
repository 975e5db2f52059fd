#include "app/render/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/render/joint_faces.h"
#include "app/render/stone_values.h"

namespace voussoir::app::render
{

using Eigen::Vector3d;

namespace
{

/// Places of all vertices as they are drawn, and the value of each in the coloured quantity.
struct Vertices {
    std::vector<Vector3d> drawn;  // m
    std::vector<double> values;   // SI
};

bool is_hidden(const LookOfRun& look, int block)
{
    return !look.hidden.empty() && look.hidden[static_cast<std::size_t>(block)];
}

/// Corners of stones as displacements count from there, seen from the foot [m].
std::vector<double> places_at_rest(const results::RecordedModel& model, const results::RecordedFrame& frame)
{
    const results::SurfaceMesh& mesh = model.mesh;
    std::vector<double> places = mesh.levers;
    const bool counts_from_rest = model.counts_from_rest(frame);
    if (counts_from_rest) places = results::positions_of(mesh, model.kinematics, model.rest.state);
    for (std::size_t v = 0; v < mesh.vertex_block.size(); ++v)
        Eigen::Map<Vector3d>(places.data() + 3 * v) +=
            counts_from_rest ? Vector3d(-model.rest.foot) : model.centroids[mesh.vertex_block[v]];
    return places;
}

Vertices place_vertices(const results::RecordedModel& model, const results::RecordedFrame& frame,
                        const SceneOptions& options)
{
    Vertices vertices;
    const results::SurfaceMesh& mesh = model.mesh;
    const std::vector<double> positions = results::positions_of(mesh, model.kinematics, frame.state);
    const std::vector<double> at_rest = places_at_rest(model, frame);
    std::vector<double> values;
    if (options.color != SnapshotColor::displacement || !options.look.group_names.empty())
        values = stone_values(model, frame, options.color, options.look);
    for (std::size_t v = 0; v < mesh.vertex_block.size(); ++v) {
        const int block = mesh.vertex_block[v];
        const Vector3d actual(positions.data() + 3 * v);
        const Vector3d reference(at_rest.data() + 3 * v);
        const Vector3d moved = actual - reference - frame.ground;
        vertices.drawn.push_back(reference + options.deformation_scale * moved);
        vertices.values.push_back(values.empty() ? moved.norm() : values[block]);
    }
    return vertices;
}

void add_face(const results::SurfaceMesh& mesh, int face, const Vertices& vertices, bool foundation, Scene& scene)
{
    const std::int32_t* loop = mesh.face_vertices.data() + mesh.face_first[face];
    const int corners = mesh.face_first[face + 1] - mesh.face_first[face];
    Vector3d normal = Vector3d::Zero();
    for (int i = 0; i < corners; ++i) {
        const int here = loop[i], next = loop[(i + 1) % corners];
        normal += vertices.drawn[here].cross(vertices.drawn[next]);
        // Both faces of an edge have it, in opposite directions: one of them draws it.
        if (here < next) scene.edges.push_back({vertices.drawn[here], vertices.drawn[next]});
    }
    normal.normalize();
    for (int i = 1; i + 1 < corners; ++i) {
        Triangle triangle{{}, normal, {}, foundation};
        const std::array<int, 3> indices = {loop[0], loop[i], loop[i + 1]};
        for (int k = 0; k < 3; ++k) {
            triangle.corners[k] = vertices.drawn[indices[k]];
            triangle.values[k] = vertices.values[indices[k]];
        }
        scene.triangles.push_back(triangle);
    }
}

void add_outline(const results::SurfaceMesh& mesh, int face, const std::vector<Vector3d>& places,
                 std::vector<Segment>& lines)
{
    const int first = mesh.face_first[face], end = mesh.face_first[face + 1];
    for (int i = first; i < end; ++i) {
        const int next = i + 1 < end ? i + 1 : first;
        lines.push_back({places[mesh.face_vertices[i]], places[mesh.face_vertices[next]]});
    }
}

/// Where all vertices were at the start of the run.
std::vector<Vector3d> start_places(const results::RecordedModel& model)
{
    std::vector<Vector3d> places;
    for (std::size_t v = 0; v < model.mesh.vertex_block.size(); ++v)
        places.push_back(model.centroids[model.mesh.vertex_block[v]] + Vector3d(model.mesh.levers.data() + 3 * v));
    return places;
}

/// The pairs of blocks that touch, ascending.
std::vector<std::pair<int, int>> touching(const results::RecordedFrame& frame)
{
    std::vector<std::pair<int, int>> pairs;
    pairs.reserve(frame.contacts.size());
    for (const JointResultant& contact : frame.contacts) pairs.emplace_back(contact.block_a, contact.block_b);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

void mark_joints(const results::RecordedModel& model, const results::RecordedFrame& frame,
                 const Vertices& vertices, const SceneOptions& options, Scene& scene)
{
    const std::vector<Vector3d> before =
        options.joint_faces.empty() ? start_places(model) : std::vector<Vector3d>();
    const std::vector<std::pair<int, int>> pairs = touching(frame);
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
        const WatchedJoint& joint = model.joints[i];
        const JointMotion& motion = frame.joints[i].motion;
        const bool slid = motion.largest_slip > options.joint_threshold;
        // Blocks that have slid off each other do not lie on each other any more.
        const bool open =
            motion.opening > options.joint_threshold ||
            (slid && !std::binary_search(pairs.begin(), pairs.end(), std::pair(joint.block_a, joint.block_b)));
        if (!open && !slid) continue;
        if (is_hidden(options.look, joint.block_a) && is_hidden(options.look, joint.block_b)) continue;
        for (const int face :
             options.joint_faces.empty() ? faces_of_joint(model.mesh, before, joint) : options.joint_faces[i])
            if (!is_hidden(options.look, model.mesh.face_block[static_cast<std::size_t>(face)]))
                add_outline(model.mesh, face, vertices.drawn, open ? scene.opened : scene.slid);
        ++(open ? scene.opened_joints : scene.slid_joints);
    }
}

/// Names beside the middles of stones, as they are drawn.
void add_labels(const results::RecordedModel& model, const Vertices& vertices, const LookOfRun& look, Scene& scene)
{
    for (std::size_t b = 0; b < look.labelled.size(); ++b) {
        if (!look.labelled[b] || is_hidden(look, static_cast<int>(b))) continue;
        const int first = model.mesh.block_first_vertex[b], end = model.mesh.block_first_vertex[b + 1];
        Vector3d middle = Vector3d::Zero();
        for (int v = first; v < end; ++v) middle += vertices.drawn[static_cast<std::size_t>(v)] / (end - first);
        scene.labels.push_back({model.block_names[b], middle});
    }
}

/// The forces of the contacts at the places where they act, and in stones that two forces hold the line between
/// these: in an arch, the line of thrust.
void add_forces(const results::RecordedModel& model, const results::RecordedFrame& frame, const LookOfRun& look,
                Scene& scene)
{
    Eigen::AlignedBox3d box;
    for (const Vector3d& centroid : model.centroids) box.extend(centroid);
    const double longest = box.diagonal().norm() / 6;
    std::vector<std::vector<Vector3d>> places(model.block_names.size());
    for (const JointResultant& contact : frame.contacts) {
        if (!(contact.normal_force > 0) || is_hidden(look, contact.block_a) || is_hidden(look, contact.block_b))
            continue;
        const Vector3d place = contact.pressure_centre - frame.ground;
        const Vector3d half = 0.5 * longest / look.largest_force * contact.force;
        scene.forces.push_back({place - half, place + half});
        for (const int block : {contact.block_a, contact.block_b})
            places[static_cast<std::size_t>(block)].push_back(place);
    }
    for (const std::vector<Vector3d>& two : places)
        if (two.size() == 2) scene.thrust.push_back({two[0], two[1]});
}

/// From end to end, as the stones are drawn.
void add_rods(const results::RecordedModel& model, const results::RecordedFrame& frame,
              const SceneOptions& options, Scene& scene)
{
    for (const results::RecordedRod& rod : model.rods) {
        std::array<Vector3d, 2> ends;
        bool hidden = false;
        for (int k = 0; k < 2; ++k) {
            const int block = rod.blocks[k];
            const Pose pose = pose_of(model.kinematics, frame.state, block);
            Vector3d reference = model.centroids[block] + rod.anchors[k];
            if (model.counts_from_rest(frame)) {
                const Pose rest = pose_of(model.kinematics, model.rest.state, block);
                reference = rest.centroid + rest.map * rod.anchors[k] - model.rest.foot;
            }
            const Vector3d moved = pose.centroid + pose.map * rod.anchors[k] - reference - frame.ground;
            ends[k] = reference + options.deformation_scale * moved;
            hidden = hidden || is_hidden(options.look, block);
        }
        if (!hidden) scene.rods.push_back({ends[0], ends[1]});
    }
}

/// A line with four barbs at its end.
void add_arrow(const Vector3d& from, const Vector3d& along, std::vector<Segment>& lines)
{
    const Vector3d to = from + along;
    lines.push_back({from, to});
    if (!(along.norm() > 0)) return;
    const Vector3d across = along.unitOrthogonal();
    for (const Vector3d& side : {across, Vector3d(along.normalized().cross(across))})
        for (const double sign : {-1.0, 1.0})
            lines.push_back({to, to - 0.2 * along + 0.1 * sign * along.norm() * side});
}

/// At each support what the ground does, the largest of the run as long as a sixth of the structure.
void add_ground_arrows(const results::RecordedModel& model, double time, const LookOfRun& look, Scene& scene)
{
    Eigen::AlignedBox3d box;
    for (const Vector3d& centroid : model.centroids) box.extend(centroid);
    for (const GroundShaking& shaking : look.shaking) {
        if (!(shaking.largest > 0)) continue;
        const Vector3d acceleration = shaking.acceleration(time);
        scene.ground_acceleration = std::max(scene.ground_acceleration, acceleration.norm());
        add_arrow(shaking.place, box.diagonal().norm() / 6 / shaking.largest * acceleration, scene.ground_arrows);
    }
}

/// The middle of the stones that the camera goes with, as they are drawn: by their weights, of each the mean of
/// its corners.
std::optional<Vector3d> followed_place(const results::SurfaceMesh& mesh, const Vertices& vertices,
                                       const std::vector<double>& weights)
{
    if (weights.empty()) return std::nullopt;
    Vector3d place = Vector3d::Zero();
    for (std::size_t b = 0; b < weights.size(); ++b) {
        const std::int32_t first = mesh.block_first_vertex[b], end = mesh.block_first_vertex[b + 1];
        for (std::int32_t v = first; v < end; ++v)
            place += weights[b] / (end - first) * vertices.drawn[static_cast<std::size_t>(v)];
    }
    return place;
}

/// Stones without a value are grey, the foundations apart.
bool any_blank(const Scene& scene)
{
    return std::any_of(scene.triangles.begin(), scene.triangles.end(), [](const Triangle& triangle) {
        return !triangle.foundation && std::isnan(triangle.values[0]);
    });
}

}  // namespace

std::vector<std::vector<int>> joint_faces_of(const results::RecordedModel& model)
{
    const std::vector<Vector3d> before = start_places(model);
    std::vector<std::vector<int>> faces;
    faces.reserve(model.joints.size());
    for (const WatchedJoint& joint : model.joints) faces.push_back(faces_of_joint(model.mesh, before, joint));
    return faces;
}

Scene make_scene(const results::RecordedModel& model, const results::RecordedFrame& frame,
                 const SceneOptions& options)
{
    Scene scene;
    scene.time = frame.time;
    if (frame.stage < static_cast<int>(model.stage_names.size())) scene.stage = model.stage_names[frame.stage];
    scene.ground = frame.ground;
    scene.counted_from = results::counted_from(model, frame.in_motion);
    const Vertices vertices = place_vertices(model, frame, options);
    std::vector<bool> foundation(model.block_names.size(), false);
    for (const int block : model.foundations) foundation[block] = true;
    for (std::size_t face = 0; face < model.mesh.face_block.size(); ++face) {
        if (is_hidden(options.look, model.mesh.face_block[face])) continue;
        add_face(model.mesh, static_cast<int>(face), vertices, foundation[model.mesh.face_block[face]], scene);
    }
    add_rods(model, frame, options, scene);
    add_labels(model, vertices, options.look, scene);
    if (options.look.largest_force > 0) add_forces(model, frame, options.look, scene);
    add_ground_arrows(model, frame.time, options.look, scene);
    mark_joints(model, frame, vertices, options, scene);
    scene.followed = followed_place(model.mesh, vertices, options.look.followed);
    scene.has_blank = any_blank(scene);
    return scene;
}

}  // namespace voussoir::app::render
