// Bullet in double precision. What its manual and header files advise for stacks: no sleeping, no damping, two
// directions of friction, many iterations; anchors of friction, which pull back what has crept; Dantzig's solver
// instead of iterations. Stones that are no boxes collide by separating axes and clipped faces, without a margin.
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <btBulletDynamicsCommon.h>

#include <Eigen/Eigenvalues>
#include <memory>

#include "tests/peers/engines.h"

namespace voussoir::peers
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

btVector3 to_bullet(const Vector3d& v)
{
    return {v.x(), v.y(), v.z()};
}

/// Bullet wants a body along its principal axes.
struct Frame {
    Matrix3d axes = Matrix3d::Identity();  // columns
    Vector3d inertia;                      // kg m2, about them
};

Frame frame_of(const Scene& scene, int block)
{
    const Matrix3d inertia = inertia_of(scene.model, block);
    if (scene.bodies[block].is_box) return {Matrix3d::Identity(), inertia.diagonal()};
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
    Frame frame{solver.eigenvectors(), solver.eigenvalues()};
    if (frame.axes.determinant() < 0) frame.axes.col(0) *= -1;
    return frame;
}

std::unique_ptr<btCollisionShape> shape_of(const Scene& scene, int block, const Frame& frame)
{
    const Body& body = scene.bodies[block];
    if (body.is_box) return std::make_unique<btBoxShape>(to_bullet(body.half));
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vector3d& vertex : scene.model.blocks[block].parts.front().vertices)
        hull->addPoint(to_bullet(frame.axes.transpose() * vertex), false);
    hull->recalcLocalAabb();
    hull->setMargin(0);
    hull->initializePolyhedralFeatures();
    return hull;
}

/// Members are destroyed from the last to the first: bodies before the world they were in know nothing of it.
struct World {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btDantzigSolver dantzig;
    std::unique_ptr<btConstraintSolver> solver;
    std::vector<Frame> frames;
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    std::unique_ptr<btDiscreteDynamicsWorld> world;
};

void add_body(const Scene& scene, const Setting& setting, int block, World& world)
{
    const Body& body = scene.bodies[block];
    world.frames.push_back(frame_of(scene, block));
    const Frame& frame = world.frames.back();
    world.shapes.push_back(shape_of(scene, block, frame));
    const double mass = body.held ? 0 : scene.model.mass(block);
    const btVector3 inertia = body.held ? btVector3(0, 0, 0) : to_bullet(frame.inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, world.shapes.back().get(), inertia);
    btMatrix3x3 axes;
    for (int row = 0; row < 3; ++row) axes[row] = to_bullet(frame.axes.row(row).transpose());
    info.m_startWorldTransform = btTransform(axes, to_bullet(scene.model.blocks[block].moments.centroid));
    info.m_friction = std::sqrt(scene.friction);  // a contact has the product of its two bodies
    world.bodies.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *world.bodies.back();
    made.setActivationState(DISABLE_DEACTIVATION);
    if (setting.engine == "bullet-anchored")
        made.setCollisionFlags(made.getCollisionFlags() | btCollisionObject::CF_HAS_FRICTION_ANCHOR);
    world.world->addRigidBody(&made);
}

void build(const Scene& scene, const Setting& setting, World& world)
{
    if (setting.engine == "bullet-direct")
        world.solver = std::make_unique<btMLCPSolver>(&world.dantzig);
    else
        world.solver = std::make_unique<btSequentialImpulseConstraintSolver>();
    world.world = std::make_unique<btDiscreteDynamicsWorld>(&world.dispatcher, &world.broadphase,
                                                            world.solver.get(), &world.configuration);
    world.world->setGravity({0, 0, -scene.gravity});
    world.world->getDispatchInfo().m_enableSatConvex = true;
    btContactSolverInfo& info = world.world->getSolverInfo();
    if (setting.iterations > 0) info.m_numIterations = setting.iterations;
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    if (setting.engine == "bullet-direct")
        info.m_minimumSolverBatchSize = 1;  // as its examples do for this solver
    for (std::size_t block = 0; block < scene.bodies.size(); ++block)
        add_body(scene, setting, static_cast<int>(block), world);
}

}  // namespace

std::string run_bullet(const Scene& scene, const Setting& setting, const Watch& watch)
{
    World world;
    build(scene, setting, world);
    const auto step = [&](const Vector3d& push) {
        for (const std::unique_ptr<btRigidBody>& body : world.bodies)
            if (body->getMass() > 0) body->applyCentralForce(body->getMass() * to_bullet(push));
        world.world->stepSimulation(setting.time_step, 0);
    };
    const PlaceOf place_of = [&](int block) -> Place {
        const btTransform& now = world.bodies[block]->getWorldTransform();
        Matrix3d axes;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) axes(row, column) = now.getBasis()[row][column];
        const btVector3& x = now.getOrigin();
        return {{x.x(), x.y(), x.z()}, axes * world.frames[block].axes.transpose()};
    };
    const std::string failure = march(scene, setting.time_step, step, place_of, watch);
    for (const std::unique_ptr<btRigidBody>& body : world.bodies) world.world->removeRigidBody(body.get());
    return failure;
}

}  // namespace voussoir::peers
