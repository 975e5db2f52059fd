#include "libdda/model/state.h"

#include <Eigen/LU>
#include <cstring>
#include <span>

namespace voussoir
{

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{

Matrix3d green_stress(const BlockMaterial& material, const Matrix3d& map)
{
    const double lambda =
        material.young * material.poisson / ((1 + material.poisson) * (1 - 2 * material.poisson));
    const double mu = material.young / (2 * (1 + material.poisson));
    const Matrix3d strain = 0.5 * (map.transpose() * map - Matrix3d::Identity());
    return lambda * strain.trace() * Matrix3d::Identity() + 2 * mu * strain;
}

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
    void add(const Vector3d& v) { add(std::span<const double>(v.data(), 3)); }
    std::uint64_t hash() const { return hash_; }

 private:
    std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace

Pose pose_of(Kinematics kinematics, const State& state, int block)
{
    const double* x = state.coordinates.data() + block * coordinates_per_block(kinematics);
    if (is_deformable(kinematics)) return {Vector3d(x), Matrix3d(x + 3)};
    return {Vector3d(x), Eigen::Quaterniond(x[3], x[4], x[5], x[6]).toRotationMatrix()};
}

Vector3d velocity_of(Kinematics kinematics, const State& state, int block)
{
    return Vector3d(state.velocities.data() + block * unknowns_per_block(kinematics));
}

Vector3d angular_velocity_of(const Model& model, const State& state, int block)
{
    const double* v = state.velocities.data() + block * unknowns_per_block(model.kinematics);
    if (!is_deformable(model.kinematics)) return Vector3d(v + 3);
    const Matrix3d map = pose_of(model.kinematics, state, block).map, rate(v + 3);
    const Matrix3d& second = model.blocks[block].moments.second;
    const Matrix3d spread = map * second * map.transpose();
    const Matrix3d inertia = spread.trace() * Matrix3d::Identity() - spread;
    const Matrix3d m = rate * second * map.transpose();  // momentum = axial vector of m - m^T
    const Vector3d momentum(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
    return inertia.inverse() * momentum;
}

Matrix3d stress_of(const Model& model, const State& state, int block)
{
    const Matrix3d map = pose_of(model.kinematics, state, block).map;
    const Matrix3d stress = green_stress(model.materials[model.blocks[block].material], map);
    return map * stress * map.transpose() / map.determinant();
}

State initial_state(const Model& model)
{
    State state;
    const int n = coordinates_per_block(model.kinematics);
    state.coordinates.assign(model.blocks.size() * n, 0.0);
    state.velocities.assign(model.blocks.size() * unknowns_per_block(model.kinematics), 0.0);
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        double* x = state.coordinates.data() + b * n;
        Map<Vector3d> centroid(x);
        centroid = model.blocks[b].moments.centroid;
        if (is_deformable(model.kinematics))
            Map<Matrix3d>{x + 3}.setIdentity();
        else
            x[3] = 1;
    }
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
        const Vector3d c = pose_of(model.kinematics, state, foundation.block).centroid;
        state.foundation_anchors.insert(state.foundation_anchors.end(), c.data(), c.data() + 3);
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
    for (const ContactPatch& patch : state.patches) {
        for (const int i : {patch.block_a, patch.block_b, patch.part_a, patch.part_b, patch.first_point,
                            patch.point_count, static_cast<int>(patch.edge_edge), static_cast<int>(patch.intact)})
            fnv.add(i);
        fnv.add(patch.feature_a);
        fnv.add(patch.feature_b);
        fnv.add(patch.stiffness);
        fnv.add(patch.normal);
    }
    for (const ContactPoint& point : state.contact_points) {
        fnv.add(point.feature);
        fnv.add(static_cast<int>(point.status));
        for (const double x : {point.gap, point.area, point.normal_force}) fnv.add(x);
        for (const Vector3d& v : {point.position, point.shear_force, point.elastic_slip, point.plastic_slip})
            fnv.add(v);
    }
    return fnv.hash();
}

}  // namespace voussoir
