#include "libdda/forces/free_field.h"

#include <Eigen/LU>

namespace voussoir::step
{

namespace
{

/// Traction of a column on a plane across its layers: at the prediction, and what each of its unknowns adds.
template <class K>
struct Traction {
    typename K::Vector steady = K::Vector::Zero();  // Pa
    Eigen::Matrix<double, K::dimension, K::unknowns> rate =
        Eigen::Matrix<double, K::dimension, K::unknowns>::Zero();  // Pa per unit of each
};

/// A_mid S N as the step blends them, S N linear about the prediction. @param normal of the face as it is drawn
template <class K>
Traction<K> traction_of(const BlockStep<K>& column, const typename K::Vector& normal)
{
    Traction<K> result;
    if constexpr (K::deformable) {
        using Matrix = typename K::Matrix;
        const Matrix& map = column.predicted.map;
        const Matrix middle = 0.5 * (column.step_rotation * column.start.map + map);
        const double end = 0.5 * (1 + column.elastic_blend);
        Matrix blended = (1 - end) * column.start_strain + end * green_strain_of(map);
        if (!column.memory.branches.empty()) blended += column.memory.steady;
        const Matrix stress = column.elasticity.stress(blended);
        result.steady = middle * stress * normal;
        for (int k = K::dimension; k < K::unknowns; ++k) {
            const Matrix l = K::gradient(K::Unknowns::Unit(k)) * map, half = map.transpose() * l;
            const Matrix more = column.elasticity.stress(Matrix(end * 0.5 * (half + half.transpose())));
            result.rate.col(k) = 0.5 * l * stress * normal + middle * more * normal;
        }
    }
    return result;
}

}  // namespace

template <class K>
typename K::Square add_free_field(const Model& model, const FaceIn<K::dimension>& face, int column,
                                  const typename K::Matrix& impedance, double end, double h,
                                  const std::vector<BlockStep<K>>& blocks, AppliedForce<K>& force)
{
    constexpr int D = K::dimension;
    using Vector = typename K::Vector;
    const BlockStep<K>&own = blocks[force.block], &field = blocks[column];
    const typename K::Matrix back = own.predicted.map.inverse();
    const Vector apart = from_space<D>(
        Eigen::Vector3d(model.blocks[force.block].moments.centroid - model.blocks[column].moments.centroid));
    const Traction<K> traction = traction_of<K>(field, (own.predicted.map.transpose() * face.normal).normalized());
    const typename K::Unknowns flight = blended_velocity(field, end, h);
    typename K::Square coupling = K::Square::Zero();
    for (const auto& point : face.points) {
        // A column that goes on for ever sideways knows heights alone.
        Vector height = back * point.lever + apart;
        height.template head<D - 1>().setZero();
        const Vector lever = field.predicted.map * height;
        const Vector pull = traction.steady + impedance * K::displacement(flight, lever);
        K::add_force(force.constant, point.lever, Vector(point.weight * pull));
        for (int k = 0; k < K::unknowns; ++k) {
            const Vector moved = K::displacement(K::Unknowns::Unit(k), lever);
            const Vector by = traction.rate.col(k) + (1 + end) / h * (impedance * moved);
            typename K::Unknowns column_of = K::Unknowns::Zero();
            K::add_force(column_of, point.lever, Vector(point.weight * by));
            coupling.col(k) += column_of;
        }
    }
    return coupling;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                            \
    template K::Square add_free_field<K>(const Model&, const FaceIn<K::dimension>&, int, const K::Matrix&, \
                                         double, double, const std::vector<BlockStep<K>>&, AppliedForce<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
