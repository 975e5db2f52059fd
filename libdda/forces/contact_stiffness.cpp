#include "libdda/forces/contact_stiffness.h"

#include <array>

#include "libdda/forces/point_tangent.h"
#include "libdda/model/parallel.h"

namespace voussoir::step
{
namespace
{

template <int D>
bool has_stiffness(const PointStep<D>& p, bool published)
{
    return p.status != ContactStatus::open || (!published && p.normal_tangent != 0);
}

/// Sums of k w w^T over the points of a patch, w = (1, y): points that share the matrix C cost one expansion.
/// Number by number: vectors put together from single numbers would wait for memory.
template <int D>
class WeightSums
{
 public:
    void add(double k, const VectorIn<D>& y)
    {
        weight_ += k;
        for (int i = 0; i < D; ++i) {
            const double ky = k * y[i];
            first_[i] += ky;
            for (int j = 0; j <= i; ++j) second_[D * i + j] += ky * y[j];
        }
    }
    double weight() const { return weight_; }
    VectorIn<D> first() const { return VectorIn<D>(first_.data()); }
    MatrixIn<D> second() const
    {
        MatrixIn<D> result;
        for (int i = 0; i < D; ++i)
            for (int j = 0; j <= i; ++j) result(i, j) = result(j, i) = second_[D * i + j];
        return result;
    }

 private:
    double weight_ = 0;
    std::array<double, D> first_{};
    std::array<double, D * D> second_{};
};

/// stiffness += sum of k T(y)^T C T(y), C symmetric
template <int D>
void expand(const WeightSums<D>& sums, const MatrixIn<D>& c, typename DeformableIn<D>::Square& stiffness)
{
    const VectorIn<D> first = sums.first();
    const MatrixIn<D> second = sums.second();
    const auto weight = [&](int i, int j) {
        return i == 0 ? (j == 0 ? sums.weight() : first[j - 1]) : (j == 0 ? first[i - 1] : second(i - 1, j - 1));
    };
    for (int j = 0; j <= D; ++j)
        for (int i = 0; i <= D; ++i) stiffness.template block<D, D>(D * i, D * j) += weight(i, j) * c;
}
void expand(const WeightSums<3>& sums, const Eigen::Matrix3d& c, SpatialRigid::Square& stiffness)
{
    const Eigen::Matrix3d off = c * skew(SpinIn<3>(sums.first()));
    stiffness.topLeftCorner<3, 3>() += sums.weight() * c;
    stiffness.topRightCorner<3, 3>() -= off;
    stiffness.bottomLeftCorner<3, 3>() -= off.transpose();
    // Sum of k skew(y) C skew(y)^T, by the product of two permutation symbols.
    const Eigen::Matrix3d s = sums.second();
    const double trace_s = s.trace(), trace_c = c.trace();
    stiffness.bottomRightCorner<3, 3>() +=
        (trace_s * trace_c - s.cwiseProduct(c).sum()) * Eigen::Matrix3d::Identity() - trace_c * s - trace_s * c +
        s * c + c * s;
}
void expand(const WeightSums<2>& sums, const Eigen::Matrix2d& c, PlanarRigid::Square& stiffness)
{
    const Eigen::Vector2d turned(-sums.first().y(), sums.first().x());
    const Eigen::Matrix2d s = sums.second();
    Eigen::Matrix2d across;
    across << s(1, 1), -s(0, 1), -s(1, 0), s(0, 0);
    const Eigen::Vector2d off = c * turned;
    stiffness.topLeftCorner<2, 2>() += sums.weight() * c;
    stiffness.topRightCorner<2, 1>() += off;
    stiffness.bottomLeftCorner<1, 2>() += off.transpose();
    stiffness(2, 2) += across.cwiseProduct(c).sum();
}

/// What the stones beside a face take off its stiffness as they bend.
/// @param normal of the points, by levers from the block; @param shift [m] lever from it less that from block a
template <int D>
void take_bending(const BentStones<D>& stones, const WeightSums<D>& normal, const VectorIn<D>& shift,
                  const VectorIn<D>& direction, typename DeformableIn<D>::Square& stiffness)
{
    // Openings are those of the unknowns' w = (1, y) along the normal, places y - c.
    const VectorIn<D> c = stones.centre + shift, first = normal.first();
    Eigen::Matrix<double, D, D + 1> moments;
    moments.col(0) = first - normal.weight() * c;
    moments.template rightCols<D>() = normal.second() - c * first.transpose();
    const MatrixIn<D> second = moments.template rightCols<D>() - moments.col(0) * c.transpose();
    const MatrixIn<D> give = contact::give_of(stones.bending.flexibility, stones.bending.end_weight(), second);
    const Eigen::Matrix<double, D + 1, D + 1> weights = moments.transpose() * give * moments;
    const MatrixIn<D> across = direction * direction.transpose();
    for (int j = 0; j <= D; ++j)
        for (int i = 0; i <= D; ++i)
            stiffness.template block<D, D>(D * i, D * j) -= 0.5 * (weights(i, j) + weights(j, i)) * across;
}

/// The same as they twist.
template <int D>
class TwistSum
{
    using K = DeformableIn<D>;

 public:
    void add(const PatchStep<K>& patch, const PointStep<D>& p, const VectorIn<D>& lever, const PointTangent<D>& c)
    {
        if constexpr (contact::twists<D>) {
            const VectorIn<D> around = patch.normal.cross(p.lever - patch.stones.centre);
            VectorIn<D> force = c.along * around;
            if (c.ahead != 0) force += c.ahead * c.heading.dot(around) * c.heading;
            K::add_force(couple_, lever, force);
            stiffness_ += around.dot(force);
        }
    }
    void take(const YieldIn<1>& twist, typename K::Square& stiffness) const
    {
        const double c = twist.flexibility(0, 0);
        if (c > 0) stiffness -= c / (twist.end_weight() + c * stiffness_) * couple_ * couple_.transpose();
    }

 private:
    typename K::Unknowns couple_ = K::Unknowns::Zero();
    double stiffness_ = 0;  // Nm
};

/// The stiffness that the points of a patch give one of its blocks.
/// @param shift [m] lever from that block less that from block a
template <class K>
void add_to_block(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points, bool published,
                  const typename K::Vector& shift, typename K::Square& stiffness)
{
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    WeightSums<K::dimension> normal, shear;
    bool yields = false;
    if constexpr (K::deformable) yields = patch.stones.acts && !published;
    [[maybe_unused]] TwistSum<K::dimension> twist;
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        const PointStep<K::dimension>& p = points[i];
        if (!has_stiffness(p, published)) continue;
        const PointTangent<K::dimension> c = tangent_of(p, published);
        const Vector lever = p.lever + shift;
        normal.add(c.across, lever);
        shear.add(c.along, lever);
        if constexpr (K::deformable)
            if (yields) twist.add(patch, p, lever, c);
        if (c.ahead == 0) continue;
        typename K::Unknowns ahead = K::Unknowns::Zero();
        K::add_force(ahead, lever, c.heading);
        stiffness.noalias() += c.ahead * ahead * ahead.transpose();
    }
    if (normal.weight() == 0 && shear.weight() == 0) return;
    const Matrix across = patch.normal * patch.normal.transpose();
    expand(normal, across, stiffness);
    expand(shear, Matrix(Matrix::Identity() - across), stiffness);
    if constexpr (K::deformable) {
        if (!yields) return;
        take_bending(patch.stones, normal, shift, patch.normal, stiffness);
        twist.take(patch.stones.twist, stiffness);
    }
}

/// With T(y + t) = T(y) G the stiffness of one block gives the others, G what moves levers by t: ab = -aa G,
/// bb = G^T aa G.
template <int D>
void spread_from_a(const VectorIn<D>& t, PatchStep<DeformableIn<D>>& patch)
{
    // Columns of the gradient gain those of the translation, times t.
    patch.ab = patch.aa;
    for (int j = 0; j < D; ++j)
        patch.ab.template middleCols<D>(D + D * j) += t[j] * patch.aa.template leftCols<D>();
    patch.bb = patch.ab;
    for (int j = 0; j < D; ++j)
        patch.bb.template middleRows<D>(D + D * j) += t[j] * patch.ab.template topRows<D>();
    patch.ab = -patch.ab;
}
void spread_from_a(const Eigen::Vector3d& t, PatchStep<SpatialRigid>& patch)
{
    const Eigen::Matrix3d turn = skew(t);
    SpatialRigid::Square across = patch.aa;
    across.topRightCorner<3, 3>() -= patch.aa.topLeftCorner<3, 3>() * turn;
    across.bottomRightCorner<3, 3>() -= patch.aa.bottomLeftCorner<3, 3>() * turn;
    patch.ab = -across;
    patch.bb = across;
    patch.bb.bottomRows<3>() += turn * across.topRows<3>();
}
void spread_from_a(const Eigen::Vector2d& t, PatchStep<PlanarRigid>& patch)
{
    const Eigen::Vector2d turned(-t.y(), t.x());
    PlanarRigid::Square across = patch.aa;
    across.col(2) += patch.aa.leftCols<2>() * turned;
    patch.ab = -across;
    patch.bb = across;
    patch.bb.row(2) += turned.transpose() * across.topRows<2>();
}

}  // namespace

template <class K>
void patch_stiffness(bool published, const std::vector<PointStep<K::dimension>>& points, PatchStep<K>& patch)
{
    using Vector = typename K::Vector;
    patch.aa.setZero();
    patch.ab.setZero();
    patch.bb.setZero();
    if (patch.row_a < 0) {
        add_to_block(patch, points, published, patch.between, patch.bb);
        return;
    }
    add_to_block(patch, points, published, Vector(Vector::Zero()), patch.aa);
    if (patch.row_b >= 0) spread_from_a(patch.between, patch);
}

template <class K>
void contact_stiffness(bool published, int threads, ContactStep<K>& step)
{
    in_parallel(step.patches.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) patch_stiffness(published, step.points, step.patches[k]);
    });
}

template <class K>
void add_block_stiffness(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points, bool of_a,
                         typename K::Square& stiffness)
{
    using Vector = typename K::Vector;
    add_to_block(patch, points, false, of_a ? Vector(Vector::Zero()) : patch.between, stiffness);
}

#define VOUSSOIR_INSTANTIATE(K)                                                                               \
    template void patch_stiffness(bool, const std::vector<PointStep<K::dimension>>&, PatchStep<K>&);          \
    template void contact_stiffness(bool, int, ContactStep<K>&);                                              \
    template void add_block_stiffness(const PatchStep<K>&, const std::vector<PointStep<K::dimension>>&, bool, \
                                      K::Square&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
