// ODE in double precision, as Debian builds it: its own error reduction (0.2) and softness of constraints (1e-10);
// friction as a share of the normal force along two directions (dContactApprox1), the first of them along the
// sliding; up to eight points a contact.
#include <ode/ode.h>

#include <array>
#include <memory>

#include "tests/peers/engines.h"

namespace voussoir::peers
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// What dCreateConvex keeps pointers to.
struct ConvexData {
    std::vector<dReal> planes, points;
    std::vector<unsigned int> polygons;
};

struct World {
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dJointGroupID contacts = dJointGroupCreate(0);
    std::vector<dBodyID> bodies;  // of held blocks: none
    std::vector<dGeomID> shapes;
    std::vector<std::unique_ptr<ConvexData>> convex;
    double friction = 0;
    bool slides = false;
    ~World()
    {
        dJointGroupDestroy(contacts);
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }
    World() = default;
    World(const World&) = delete;
    World& operator=(const World&) = delete;
};

dGeomID convex_of(const ConvexPolyhedron& shape, World& world)
{
    auto data = std::make_unique<ConvexData>();
    for (const Vector3d& vertex : shape.vertices)
        data->points.insert(data->points.end(), vertex.begin(), vertex.end());
    for (std::size_t face = 0; face < shape.faces.size(); ++face) {
        const Vector3d normal = face_normal(shape, static_cast<int>(face));
        data->planes.insert(data->planes.end(), normal.begin(), normal.end());
        data->planes.push_back(normal.dot(shape.vertices[shape.faces[face].front()]));
        data->polygons.push_back(static_cast<unsigned int>(shape.faces[face].size()));
        for (const int vertex : shape.faces[face]) data->polygons.push_back(static_cast<unsigned int>(vertex));
    }
    world.convex.push_back(std::move(data));
    ConvexData& kept = *world.convex.back();
    return dCreateConvex(world.space, kept.planes.data(), static_cast<unsigned int>(shape.faces.size()),
                         kept.points.data(), static_cast<unsigned int>(shape.vertices.size()),
                         kept.polygons.data());
}

void add_body(const Scene& scene, int block, World& world)
{
    const Body& body = scene.bodies[block];
    const Vector3d& centroid = scene.model.blocks[block].moments.centroid;
    world.shapes.push_back(body.is_box
                               ? dCreateBox(world.space, 2 * body.half.x(), 2 * body.half.y(), 2 * body.half.z())
                               : convex_of(scene.model.blocks[block].parts.front(), world));
    world.bodies.push_back(body.held ? nullptr : dBodyCreate(world.world));
    if (body.held) {
        dGeomSetPosition(world.shapes.back(), centroid.x(), centroid.y(), centroid.z());
        return;
    }
    const Matrix3d inertia = inertia_of(scene.model, block);
    dMass mass;
    dMassSetParameters(&mass, scene.model.mass(block), 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2),
                       inertia(0, 1), inertia(0, 2), inertia(1, 2));
    dBodySetMass(world.bodies.back(), &mass);
    dBodySetPosition(world.bodies.back(), centroid.x(), centroid.y(), centroid.z());
    dGeomSetBody(world.shapes.back(), world.bodies.back());
}

Vector3d velocity_at(dBodyID body, const dReal* point)
{
    dVector3 velocity = {0, 0, 0};
    if (body) dBodyGetPointVel(body, point[0], point[1], point[2], velocity);
    return {velocity[0], velocity[1], velocity[2]};
}

constexpr double sliding_speed = 0.05;  // m/s: what is slower may stick; of scenes that slide at all

/// Friction that acts against a sliding has nothing across it; else it has two directions, the first in the plane
/// of the push.
void set_friction(bool slides, dBodyID a, dBodyID b, dContact& contact)
{
    const dContactGeom& found = contact.geom;
    const Vector3d normal(found.normal[0], found.normal[1], found.normal[2]);
    const auto in_plane = [&](const Vector3d& v) -> Vector3d { return v - normal.dot(v) * normal; };
    Vector3d first = in_plane(velocity_at(a, found.pos) - velocity_at(b, found.pos));
    contact.surface.mode = dContactApprox1 | dContactFDir1 | dContactMu2;
    contact.surface.mu2 = contact.surface.mu;
    if (slides && first.norm() > sliding_speed)
        contact.surface.mu2 = 0;
    else
        first = in_plane(std::abs(normal.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitZ());
    first.normalize();
    for (int axis = 0; axis < 3; ++axis) contact.fdir1[axis] = first[axis];
}

void touch(void* data, dGeomID a, dGeomID b)
{
    World& world = *static_cast<World*>(data);
    const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
    if (!body_a && !body_b) return;
    std::array<dContactGeom, 8> found;
    const int count = dCollide(a, b, static_cast<int>(found.size()), found.data(), sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
        dContact contact{};
        contact.surface.mu = world.friction;
        contact.geom = found[i];
        set_friction(world.slides, body_a, body_b, contact);
        dJointAttach(dJointCreateContact(world.world, world.contacts, &contact), body_a, body_b);
    }
}

void make_step(const Setting& setting, const Vector3d& push, World& world)
{
    for (const dBodyID body : world.bodies) {
        if (!body) continue;
        dMass mass;
        dBodyGetMass(body, &mass);
        dBodyAddForce(body, mass.mass * push.x(), mass.mass * push.y(), mass.mass * push.z());
    }
    dSpaceCollide(world.space, &world, touch);
    if (setting.engine == "ode-direct")
        dWorldStep(world.world, setting.time_step);
    else
        dWorldQuickStep(world.world, setting.time_step);
    dJointGroupEmpty(world.contacts);
}

Place place_of_shape(dGeomID shape)
{
    const dReal *x = dGeomGetPosition(shape), *r = dGeomGetRotation(shape);
    Matrix3d turn;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) turn(row, column) = r[4 * row + column];
    return {{x[0], x[1], x[2]}, turn};
}

}  // namespace

std::string run_ode(const Scene& scene, const Setting& setting, const Watch& watch)
{
    dInitODE2(0);
    std::string failure;
    {
        World world;
        world.friction = scene.friction;
        world.slides = scene.slides;
        dWorldSetGravity(world.world, 0, 0, -scene.gravity);
        if (setting.iterations > 0) dWorldSetQuickStepNumIterations(world.world, setting.iterations);
        for (std::size_t block = 0; block < scene.bodies.size(); ++block)
            add_body(scene, static_cast<int>(block), world);
        failure = march(
            scene, setting.time_step, [&](const Vector3d& push) { make_step(setting, push, world); },
            [&](int block) { return place_of_shape(world.shapes[block]); }, watch);
    }
    dCloseODE();
    return failure;
}

}  // namespace voussoir::peers
