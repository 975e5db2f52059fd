#include "tests/libdda/motion_book.h"

#include <cmath>

namespace voussoir::testing
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{

/// Points of a face, levers as drawn, and weights that integrate cubics on an edge and quadratics on a polygon
/// [m2].
struct FacePoints {
    std::vector<std::pair<Vector3d, double>> points;
    Vector3d normal = Vector3d::Zero();
};

/// An edge by Simpson's rule.
FacePoints edge_points(const Model& model, const BlockFace& face)
{
    const auto& corners = model.blocks[face.block].outlines[face.part].vertices;
    const Vector3d a = to_space(corners[face.face]), b = to_space(corners[(face.face + 1) % corners.size()]);
    const double area = (b - a).norm() * model.thickness;
    const Vector3d along = (b - a).normalized();
    return {{{a, area / 6}, {0.5 * (a + b), area * 4 / 6}, {b, area / 6}}, Vector3d(along.z(), 0, -along.x())};
}

/// A polygon in triangles about its middle, each by its corners' thirds.
FacePoints polygon_points(const Model& model, const BlockFace& face)
{
    const ConvexPolyhedron& shape = model.blocks[face.block].parts[face.part];
    const auto& loop = shape.faces[face.face];
    Vector3d middle = Vector3d::Zero();
    for (const int corner : loop) middle += shape.vertices[corner] / static_cast<double>(loop.size());
    FacePoints result;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vector3d& a = shape.vertices[loop[i]];
        const Vector3d& b = shape.vertices[loop[(i + 1) % loop.size()]];
        const Vector3d twice = (a - middle).cross(b - middle);
        result.normal += twice;
        for (const Vector3d& nearest : {a, b, middle})
            result.points.emplace_back((a + b + middle + 3 * nearest) / 6, twice.norm() / 6);
    }
    result.normal.normalize();
    return result;
}

FacePoints points_of(const Model& model, const BlockFace& face)
{
    return is_planar(model.kinematics) ? edge_points(model, face) : polygon_points(model, face);
}

Vector3d middle_of_face(const Model& model, const BlockFace& face)
{
    Vector3d sum = Vector3d::Zero();
    double area = 0;
    for (const auto& [lever, weight] : points_of(model, face).points) {
        sum += weight * lever;
        area += weight;
    }
    return model.blocks[face.block].moments.centroid + sum / area;
}

/// P wave modulus and shear modulus [Pa].
double pressure_modulus(const BlockMaterial& m)
{
    return m.young * (1 - m.poisson) / ((1 + m.poisson) * (1 - 2 * m.poisson));
}
double shear_modulus(const BlockMaterial& m)
{
    return m.young / (2 * (1 + m.poisson));
}

/// Hooke's law.
Matrix3d hooke(const BlockMaterial& m, const Matrix3d& strain)
{
    const double mu = shear_modulus(m), lambda = pressure_modulus(m) - 2 * mu;
    return lambda * strain.trace() * Matrix3d::Identity() + 2 * mu * strain;
}

double inner(const Matrix3d& a, const Matrix3d& b)
{
    return a.cwiseProduct(b).sum();
}

double ground_way(const Stage& stage, int component, double from, double to)
{
    for (const FoundationMotion& motion : stage.motions)
        if (motion.component == component)
            return motion.motion->displacement(to) - motion.motion->displacement(from);
    return 0;
}
double ground_velocity_at(const Stage& stage, int component, double time)
{
    for (const FoundationMotion& motion : stage.motions)
        if (motion.component == component) return motion.motion->velocity(time);
    return 0;
}

bool is_held(const Model& model, int block)
{
    for (const Foundation& foundation : model.foundations)
        if (foundation.block == block) return true;
    return false;
}

/// Undoes the kinetic damping of a step of length h.
void undamp(const Model& model, const Stage& stage, double h, State& state)
{
    const double left = std::exp(-stage.damping.rate * h);
    const int n = unknowns_per_block(model.kinematics), dimension = dimension_of(model.kinematics);
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        if (is_held(model, b)) continue;
        for (int k = 0; k < n; ++k) {
            const int axis = dimension == 3 ? k : axis_in_space<2>(k);
            const double base = k < dimension ? ground_velocity_at(stage, axis, state.stage_time) : 0;
            double& v = state.velocities[static_cast<std::size_t>(n * b + k)];
            v = base + (v - base) / left;
        }
    }
}

}  // namespace

MotionBook::MotionBook(const Model& model, const Stage& stage, const State& start)
    : model_(model),
      stage_(stage),
      before_(start),
      now_(start),
      felt_(model.blocks.size()),
      felt_stress_(model.blocks.size(), Matrix3d::Zero())
{
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const BlockMaterial& material = model.materials[model.blocks[b].material];
        felt_[b].assign(material.branches.size(), Matrix3d::Zero());  // a stage begins at rest
    }
    kinetic = kinetic_energy(model, start);
    strain = stored_in_blocks() + stored_in_ties();
}

void MotionBook::add_step(const State& now)
{
    before_ = now_;
    now_ = now;
    h_ = now.stage_time - before_.stage_time;
    undamp(model_, stage_, h_, now_);
    find_memory();
    add_faces();
    for (int b = 0; b < static_cast<int>(model_.blocks.size()); ++b)
        if (!is_held(model_, b)) add_block_damping(b);
    add_joint_dashpots();
    kinetic = kinetic_energy(model_, now);
    damping_kinetic += kinetic_energy(model_, now_) - kinetic;
    strain = stored_in_blocks() + stored_in_ties();
}

EnergyLedger MotionBook::ledger_with(EnergyLedger engine) const
{
    engine.kinetic = kinetic;
    engine.strain = strain;
    engine.gravity_work = gravity_work;
    engine.boundary_work = boundary_work;
    engine.damping_kinetic = damping_kinetic;
    engine.damping_material = material();
    engine.damping_contact = damping_contact;
    return engine;
}

MotionBook::Place MotionBook::place_of(const State& state, int block) const
{
    const Pose pose = pose_of(model_.kinematics, state, block);
    return {pose.centroid, pose.map};
}

MotionBook::Place MotionBook::way_of(int block) const
{
    const Place from = place_of(before_, block), to = place_of(now_, block);
    return {to.centroid - from.centroid, to.map - from.map};
}

/// The mean velocity, and by the integrator's share that of the end.
MotionBook::Place MotionBook::blended_velocity(int block) const
{
    const double end = stage_.control.dissipation_used();
    const Place way = way_of(block);
    return {(1 - end) / h_ * way.centroid + end * velocity_of(model_.kinematics, now_, block),
            (1 - end) / h_ * way.map + end * map_rate_of(model_.kinematics, now_, block)};
}

Matrix3d MotionBook::strain_at(const State& state, int block) const
{
    const Matrix3d map = pose_of(model_.kinematics, state, block).map;
    return 0.5 * (map.transpose() * map - Matrix3d::Identity());
}

double MotionBook::elastic_energy(int block, const Matrix3d& strain) const
{
    const Block& b = model_.blocks[block];
    return 0.5 * b.moments.volume * inner(strain, hooke(model_.materials[b.material], strain));
}

/// de/dt = dE/dt - e / time, the strain E growing evenly: what dashpots take is the integral of share C e:e /
/// time.
void MotionBook::find_memory()
{
    for (int b = 0; b < static_cast<int>(model_.blocks.size()); ++b) {
        if (is_held(model_, b)) continue;
        const BlockMaterial& material = model_.materials[model_.blocks[b].material];
        const Matrix3d rate = (strain_at(now_, b) - strain_at(before_, b)) / h_;
        Matrix3d mean = Matrix3d::Zero();
        for (std::size_t k = 0; k < material.branches.size(); ++k) {
            const auto& [share, time] = material.branches[k];
            Matrix3d& e = felt_[b][k];
            const Matrix3d steady = time * rate, fading = e - steady;
            const double left = std::exp(-h_ / time);
            damping_memory +=
                2 * share / time *
                (0.5 * time * (1 - left * left) * elastic_energy(b, fading) + h_ * elastic_energy(b, steady));
            const double cross =
                elastic_energy(b, fading + steady) - elastic_energy(b, fading) - elastic_energy(b, steady);
            damping_memory += 2 * share / time * time * (1 - left) * cross;
            mean += share * (steady + time * (1 - left) / h_ * fading);
            e = steady + left * fading;
        }
        felt_stress_[b] = hooke(material, mean);
    }
}

/// First Piola stress of a column in the mean over the step [Pa].
Matrix3d MotionBook::stress_in_step(int block) const
{
    const BlockMaterial& material = model_.materials[model_.blocks[block].material];
    const double end = stage_.control.dissipation_used();
    const Matrix3d from = strain_at(before_, block), to = strain_at(now_, block), change = to - from;
    const Matrix3d felt = 0.5 * (from + to) + (0.5 * end + material.rayleigh.of_stiffness / h_) * change;
    const Matrix3d middle = 0.5 * (place_of(before_, block).map + place_of(now_, block).map);
    return middle * (hooke(material, felt) + felt_stress_[block]);
}

void MotionBook::add_faces()
{
    const std::size_t reaction_size = dimension_of(model_.kinematics) * (1 + dimension_of(model_.kinematics));
    const double* reaction = now_.boundary_reactions.data();
    for (const ViscousBoundary& boundary : model_.boundaries)
        for (std::size_t i = 0; i < boundary.faces.size(); ++i, reaction += reaction_size)
            boundary_work += work_on(boundary.faces[i], boundary.free_field.empty() ? -1 : boundary.free_field[i],
                                     reaction, boundary);
}

/// Of the traction C (2 v_in - v), or C (v_f - v) + S n beside a free field, and of what was there at rest.
double MotionBook::work_on(const BlockFace& face, int column, const double* reaction,
                           const ViscousBoundary& boundary) const
{
    const BlockMaterial& material = model_.materials[model_.blocks[face.block].material];
    const FacePoints shape = points_of(model_, face);
    const double along = std::sqrt(material.density * pressure_modulus(material)),
                 across = std::sqrt(material.density * shear_modulus(material));
    const Matrix3d normal = shape.normal * shape.normal.transpose();
    const Matrix3d impedance = along * normal + across * (Matrix3d::Identity() - normal);
    const double end = stage_.control.dissipation_used(), time = now_.stage_time;
    Vector3d coming = Vector3d::Zero();
    for (const IncomingWave& wave : stage_.incoming_waves) {
        if (&model_.boundaries[wave.boundary] != &boundary) continue;
        const double late = wave.slowness.dot(middle_of_face(model_, face) - wave.origin);
        const double mean =
            (wave.motion->displacement(time - late) - wave.motion->displacement(time - h_ - late)) / h_;
        coming[wave.component] += wave.share * ((1 - end) * mean + end * wave.motion->velocity(time - late));
    }
    const Place velocity = blended_velocity(face.block), way = way_of(face.block);
    double work = 0;
    for (const auto& [lever, weight] : shape.points) {
        Vector3d traction = impedance * (2 * coming - velocity.at(lever));
        if (column >= 0) {
            const double height = model_.blocks[face.block].moments.centroid.z() + lever.z() -
                                  model_.blocks[column].moments.centroid.z();
            traction +=
                impedance * blended_velocity(column).at({0, 0, height}) + stress_in_step(column) * shape.normal;
        }
        work += weight * traction.dot(way.at(lever));
    }
    const int dimension = dimension_of(model_.kinematics);
    const auto axis = [&](int k) { return dimension == 3 ? k : axis_in_space<2>(k); };
    for (int k = 0; k < dimension; ++k) work += reaction[k] * way.centroid[axis(k)];
    for (int j = 0; j < dimension; ++j)
        for (int k = 0; k < dimension; ++k) work += reaction[dimension * (1 + j) + k] * way.map(axis(k), axis(j));
    return work;
}

void MotionBook::add_block_damping(int block)
{
    const Block& b = model_.blocks[block];
    const RayleighDamping& rayleigh = model_.materials[b.material].rayleigh;
    const double end = stage_.control.dissipation_used(), time = now_.stage_time;
    const Place way = way_of(block);
    gravity_work += model_.mass(block) * stage_.gravity.dot(way.centroid);
    Place velocity = blended_velocity(block), moved = way;
    for (int k = 0; k < 3; ++k) {
        const double ground = ground_way(stage_, k, time - h_, time);
        velocity.centroid[k] -= (1 - end) * ground / h_ + end * ground_velocity_at(stage_, k, time);
        moved.centroid[k] -= ground;
    }
    damping_mass += rayleigh.of_mass * (model_.mass(block) * velocity.centroid.dot(moved.centroid) +
                                        inner(velocity.map * model_.mass_second(block), moved.map));
    const Matrix3d change = strain_at(now_, block) - strain_at(before_, block);
    damping_stiffness += 2 * rayleigh.of_stiffness / h_ * elastic_energy(block, change);
}

/// N = <-k (g + eta dg/dt)>: what it is more than the spring's part, on the way that the joint closed.
void MotionBook::add_joint_dashpots()
{
    const double end = stage_.control.dissipation_used();
    const auto add = [&](const auto& contacts) {
        for (const auto& patch : contacts.patches) {
            const double eta = model_.joint_between(patch.block_a, patch.block_b).relaxation_time;
            if (eta == 0) continue;
            const Vector3d normal = to_space(patch.normal);
            const auto way_at = [&](int block, const Vector3d& position) {
                const Place to = place_of(now_, block);
                return way_of(block).at(to.map.inverse() * (position - to.centroid));
            };
            for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
                const auto& point = contacts.points[i];
                const Vector3d position = to_space(point.position);
                const double opened =
                    normal.dot(way_at(patch.block_a, position) - way_at(patch.block_b, position));
                const double k = patch.stiffness * point.area, start = point.gap - opened;
                const double spring = -k * (0.5 * (start + point.gap) + 0.5 * (start < 0 ? end : 1) * opened);
                const double whole = std::max(0.0, spring - k * eta * opened / h_);
                damping_contact -= (whole - std::max(0.0, spring)) * opened;
            }
        }
    };
    if (is_planar(model_.kinematics))
        add(now_.planar_contacts);
    else
        add(now_.contacts);
}

double MotionBook::stored_in_blocks() const
{
    double sum = 0;
    for (int b = 0; b < static_cast<int>(model_.blocks.size()); ++b) {
        if (is_held(model_, b)) continue;
        sum += elastic_energy(b, strain_at(now_, b));
        const BlockMaterial& material = model_.materials[model_.blocks[b].material];
        for (std::size_t k = 0; k < material.branches.size(); ++k)
            sum += material.branches[k].share * elastic_energy(b, felt_[b][k]);
    }
    return sum;
}

/// Springs between the points of two faces, one a copy of the other.
double MotionBook::stored_in_ties() const
{
    double sum = 0;
    for (const SideTie& tie : model_.side_ties) {
        const FacePoints a = points_of(model_, tie.a);
        const Vector3d period = middle_of_face(model_, tie.b) - middle_of_face(model_, tie.a);
        const Vector3d apart =
            model_.blocks[tie.a.block].moments.centroid + period - model_.blocks[tie.b.block].moments.centroid;
        const Place of_a = place_of(now_, tie.a.block), of_b = place_of(now_, tie.b.block);
        for (const auto& [lever, weight] : a.points) {
            const Vector3d gap = of_a.at(lever) + period - of_b.at(lever + apart);
            const double along = gap.dot(a.normal);
            sum += 0.5 * weight * (tie.normal * along * along + tie.shear * (gap.squaredNorm() - along * along));
        }
    }
    return sum;
}

}  // namespace voussoir::testing
