#include "libdda/model/state.h"

#include <Eigen/LU>
#include <cstring>
#include <span>

#include "libdda/model/elasticity.h"

namespace voussoir
{

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{

class Fnv1a
{
 public:
    template <class T>
    void add(std::span<const T> values)
    {
        static_assert(std::is_arithmetic_v<T>);
        for (const T value : values) {
            unsigned char bytes[sizeof(T)];
            std::memcpy(bytes, &value, sizeof(T));
            for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 1099511628211ULL;
        }
    }
    template <class T>
    void add(T value)
    {
        add(std::span<const T>(&value, 1));
    }
    template <int D>
    void add(const Eigen::Matrix<double, D, 1>& v)
    {
        add(std::span<const double>(v.data(), D));
    }
    std::uint64_t hash() const { return hash_; }

 private:
    std::uint64_t hash_ = 14695981039346656037ULL;
};

template <int D>
void add_contacts(const ContactSetIn<D>& contacts, Fnv1a& fnv)
{
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        for (const int i : {patch.block_a, patch.block_b, patch.part_a, patch.part_b, patch.first_point,
                            patch.point_count, static_cast<int>(patch.edge_edge), static_cast<int>(patch.intact)})
            fnv.add(i);
        fnv.add(patch.feature_a);
        fnv.add(patch.feature_b);
        fnv.add(patch.stiffness);
        fnv.add(patch.bending_energy);
        fnv.add(patch.normal);
    }
    for (const ContactPointIn<D>& point : contacts.points) {
        fnv.add(point.feature);
        fnv.add(static_cast<int>(point.status));
        for (const double x : {point.gap, point.rest_gap, point.area, point.normal_force}) fnv.add(x);
        for (const VectorIn<D>& v : {point.position, point.shear_force, point.elastic_slip, point.plastic_slip})
            fnv.add(v);
    }
}

Matrix3d skew(const Vector3d& r)
{
    Matrix3d m;
    m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return m;
}

}  // namespace

template <>
PoseIn<3> pose_in<3>(Kinematics kinematics, const State& state, int block)
{
    const double* x = state.coordinates.data() + block * coordinates_per_block(kinematics);
    if (is_deformable(kinematics)) return {Vector3d(x), Matrix3d(x + 3)};
    return {Vector3d(x), Eigen::Quaterniond(x[3], x[4], x[5], x[6]).toRotationMatrix()};
}

template <>
PoseIn<2> pose_in<2>(Kinematics kinematics, const State& state, int block)
{
    const double* x = state.coordinates.data() + block * coordinates_per_block(kinematics);
    if (is_deformable(kinematics)) return {Vector2d(x), Matrix2d(x + 2)};
    return {Vector2d(x), Eigen::Rotation2Dd(x[2]).toRotationMatrix()};
}

Pose pose_of(Kinematics kinematics, const State& state, int block)
{
    if (!is_planar(kinematics)) return pose_in<3>(kinematics, state, block);
    const PoseIn<2> pose = pose_in<2>(kinematics, state, block);
    return {to_space(pose.centroid), to_space(pose.map, 1)};
}

Vector3d velocity_of(Kinematics kinematics, const State& state, int block)
{
    const double* v = state.velocities.data() + block * unknowns_per_block(kinematics);
    return is_planar(kinematics) ? to_space(Vector2d(v)) : Vector3d(v);
}

Matrix3d map_rate_of(Kinematics kinematics, const State& state, int block)
{
    const double* v = state.velocities.data() + block * unknowns_per_block(kinematics);
    switch (kinematics) {
        case Kinematics::spatial_deformable:
            return Matrix3d(v + 3);
        case Kinematics::planar_deformable:
            return to_space(Matrix2d(v + 2), 0);
        case Kinematics::spatial_rigid:
            return skew(Vector3d(v + 3)) * pose_of(kinematics, state, block).map;
        case Kinematics::planar_rigid:
            break;
    }
    return skew(Vector3d(0, -v[2], 0)) * pose_of(kinematics, state, block).map;
}

Vector3d angular_velocity_of(const Model& model, const State& state, int block)
{
    const double* v = state.velocities.data() + block * unknowns_per_block(model.kinematics);
    if (model.kinematics == Kinematics::spatial_rigid) return Vector3d(v + 3);
    if (model.kinematics == Kinematics::planar_rigid) return {0, -v[2], 0};
    const Matrix3d map = pose_of(model.kinematics, state, block).map;
    const Matrix3d rate = map_rate_of(model.kinematics, state, block);
    const Matrix3d second = model.mass_second(block);
    const Matrix3d spread = map * second * map.transpose();
    const Matrix3d inertia = spread.trace() * Matrix3d::Identity() - spread;
    const Matrix3d m = rate * second * map.transpose();  // momentum = axial vector of m - m^T
    const Vector3d momentum(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
    return inertia.inverse() * momentum;
}

namespace
{

/// The strain to which the elasticity of a block answers: its own, and the shares of what its branches hold.
template <class Matrix>
Matrix felt_strain(const Model& model, const State& state, int block, const Matrix& strain)
{
    Matrix felt = strain;
    int number = 0;
    if (state.branch_strains.empty()) return felt;
    for (const MaxwellBranch& branch : model.materials[model.blocks[block].material].branches)
        felt += branch.share * (strain - branch_strain_in<Matrix::RowsAtCompileTime>(state, block, number++));
    return felt;
}

}  // namespace

Matrix3d stress_of(const Model& model, const State& state, int block)
{
    const Elasticity elasticity = elasticity_of(model, block);
    if (!is_planar(model.kinematics)) {
        const Matrix3d map = pose_of(model.kinematics, state, block).map;
        const Matrix3d strain = felt_strain(model, state, block, Matrix3d(green_strain_of(map)));
        return map * elasticity.stress(strain) * map.transpose() / map.determinant();
    }
    const Matrix2d map = pose_in<2>(model.kinematics, state, block).map;
    const Matrix2d strain = felt_strain(model, state, block, Matrix2d(green_strain_of(map)));
    const double across = model.plane == PlaneCondition::strain ? elasticity.lambda * strain.trace() : 0;
    const Matrix2d within = map * elasticity.stress(strain) * map.transpose();
    return to_space(within, across) / map.determinant();
}

void set_in_motion(const Model& model, State& state)
{
    const int n = unknowns_per_block(model.kinematics), dimension = dimension_of(model.kinematics);
    for (const InitialMotion& motion : model.initial_motions) {
        double* v = state.velocities.data() + motion.block * n;
        for (int k = 0; k < dimension; ++k) v[k] = motion.velocity[axes_of(model.kinematics)[k]];
        const Pose pose = pose_of(model.kinematics, state, motion.block);
        if (model.kinematics == Kinematics::spatial_deformable)
            Eigen::Map<Matrix3d>{v + 3} = skew(motion.spin) * pose.map;
        else if (model.kinematics == Kinematics::planar_deformable)
            Eigen::Map<Matrix2d>{v + 2} = from_space<2>(Matrix3d(skew(motion.spin) * pose.map));
        else if (model.kinematics == Kinematics::spatial_rigid)
            Eigen::Map<Vector3d>{v + 3} = motion.spin;
        else
            v[2] = -motion.spin.y();  // from x to z
    }
}

State initial_state(const Model& model)
{
    State state;
    const int n = coordinates_per_block(model.kinematics), dimension = dimension_of(model.kinematics);
    state.coordinates.assign(model.blocks.size() * n, 0.0);
    state.velocities.assign(model.blocks.size() * unknowns_per_block(model.kinematics), 0.0);
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        double* x = state.coordinates.data() + b * n;
        const Vector3d& centroid = model.blocks[b].moments.centroid;
        for (int k = 0; k < dimension; ++k) x[k] = centroid[axes_of(model.kinematics)[k]];
        if (is_deformable(model.kinematics))
            for (int k = 0; k < dimension; ++k) x[dimension + k * (dimension + 1)] = 1;
        else if (dimension == 3)
            x[3] = 1;
    }
    std::size_t faces = 0;
    for (const ViscousBoundary& boundary : model.boundaries) faces += boundary.faces.size();
    state.boundary_reactions.assign(faces * dimension * (1 + dimension), 0.0);
    state.branch_strains.assign(model.blocks.size() * most_branches(model) * dimension * dimension, 0.0);
    state.bars.assign(model.bars.size() * (dimension + 1), 0.0);
    for (std::size_t i = 0; i < model.bars.size(); ++i)
        if (model.bars[i].prestress != 0)
            state.bars[i * (dimension + 1)] = -model.bars[i].prestress / model.bars[i].axial;
    set_in_motion(model, state);
    begin_stage(model, 0, state);
    return state;
}

void begin_stage(const Model& model, int stage_index, State& state)
{
    state.stage = stage_index;
    state.stage_time = 0;
    state.grid = 0;
    state.next_time_step = 0;
    state.foundation_anchors.clear();
    for (const Foundation& foundation : model.foundations) {
        const double* x = state.coordinates.data() + foundation.block * coordinates_per_block(model.kinematics);
        state.foundation_anchors.insert(state.foundation_anchors.end(), x, x + dimension_of(model.kinematics));
    }
}

std::uint64_t hash_of(const State& state)
{
    Fnv1a fnv;
    fnv.add(state.time);
    fnv.add(state.step);
    fnv.add(state.stage);
    fnv.add(state.stage_time);
    fnv.add(state.grid);
    fnv.add(state.next_time_step);
    fnv.add(std::span<const double>(state.coordinates));
    fnv.add(std::span<const double>(state.velocities));
    fnv.add(std::span<const double>(state.foundation_anchors));
    fnv.add(std::span<const double>(state.boundary_reactions));
    fnv.add(std::span<const double>(state.branch_strains));
    fnv.add(std::span<const double>(state.bars));
    add_contacts(state.contacts, fnv);
    add_contacts(state.planar_contacts, fnv);
    return fnv.hash();
}

}  // namespace voussoir
