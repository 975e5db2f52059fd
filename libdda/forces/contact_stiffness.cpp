#include "libdda/forces/contact_stiffness.h"

#include "libdda/model/parallel.h"

namespace voussoir::step
{
namespace
{

/// C of one point: -dN/dg n n^T plus the shear tangent without the coupling to the normal force.
template <int D>
MatrixIn<D> point_stiffness(const PointStep<D>& p, const VectorIn<D>& n, bool published)
{
    const double k_t = 0.5 * (1 + p.shear_blend) * p.shear_stiffness;
    const MatrixIn<D> across = n * n.transpose(), along = MatrixIn<D>::Identity() - across;
    if (published) {
        if (p.status == ContactStatus::open) return MatrixIn<D>::Zero();
        MatrixIn<D> c = 0.5 * (1 + p.normal_blend) * p.normal_stiffness * across;
        if (p.status == ContactStatus::locked) c += k_t * along;
        return c;
    }
    MatrixIn<D> c = p.normal_tangent * across;
    if (p.turns_round) {
        const MatrixIn<D> ahead = p.heading * p.heading.transpose();
        return c + p.tangent_along * ahead + p.tangent_across * (along - ahead);
    }
    if (p.status == ContactStatus::locked) c += k_t * along;
    if (p.status == ContactStatus::sliding) {
        const double length = p.trial.norm();
        const VectorIn<D> slipping = p.trial / length;
        c += k_t * p.bound / length * (along - slipping * slipping.transpose());
    }
    return c;
}

/// Adds the stiffness c of one point to the blocks of its patch.
template <class K>
void add_point(const PointStep<K::dimension>& p, const typename K::Matrix& c, PatchStep<K>& patch)
{
    if (patch.row_a >= 0) K::add_stiffness(patch.aa, p.lever_a, p.lever_a, c);
    if (patch.row_b >= 0) K::add_stiffness(patch.bb, p.lever_b, p.lever_b, c);
    if (patch.row_a >= 0 && patch.row_b >= 0) K::add_stiffness(patch.ab, p.lever_a, p.lever_b, -c);
}

/// Sums of k w w^T over the points of a patch, w = (1, y): points that share the matrix C then cost one expansion.
template <int D>
struct WeightSums {
    using Weights = Eigen::Matrix<double, D + 1, 1>;
    using Sums = Eigen::Matrix<double, D + 1, D + 1>;
    Sums aa = Sums::Zero(), ab = Sums::Zero(), bb = Sums::Zero();

    void add(double k, const PointStep<D>& p)
    {
        Weights a, b;
        a << 1, p.lever_a;
        b << 1, p.lever_b;
        aa += k * a * a.transpose();
        ab -= k * a * b.transpose();
        bb += k * b * b.transpose();
    }

    static void expand(const Sums& sums, const MatrixIn<D>& c, typename DeformableIn<D>::Square& block)
    {
        for (int j = 0; j <= D; ++j)
            for (int i = 0; i <= D; ++i) block.template block<D, D>(D * i, D * j) += sums(i, j) * c;
    }

    void expand(const MatrixIn<D>& c, PatchStep<DeformableIn<D>>& patch) const
    {
        if (patch.row_a >= 0) expand(aa, c, patch.aa);
        if (patch.row_b >= 0) expand(bb, c, patch.bb);
        if (patch.row_a >= 0 && patch.row_b >= 0) expand(ab, c, patch.ab);
    }
};

template <int D>
bool has_stiffness(const PointStep<D>& p, bool published)
{
    return p.status != ContactStatus::open || (!published && p.normal_tangent != 0);
}

/// Locked points of a deformable patch share the directions n n^T and 1 - n n^T.
template <int D>
void add_points(const std::vector<PointStep<D>>& points, bool published, PatchStep<DeformableIn<D>>& patch)
{
    WeightSums<D> normal, shear;
    bool any = false;
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        const PointStep<D>& p = points[i];
        if (!has_stiffness(p, published)) continue;
        if (p.status != ContactStatus::locked || (p.turns_round && !published)) {
            add_point(p, point_stiffness<D>(p, patch.normal, published), patch);
            continue;
        }
        normal.add(published ? 0.5 * (1 + p.normal_blend) * p.normal_stiffness : p.normal_tangent, p);
        shear.add(0.5 * (1 + p.shear_blend) * p.shear_stiffness, p);
        any = true;
    }
    if (!any) return;
    const MatrixIn<D> across = patch.normal * patch.normal.transpose();
    normal.expand(across, patch);
    shear.expand(MatrixIn<D>::Identity() - across, patch);
}

/// The levers of all points of a patch from one block differ from those from the other by the same vector t: with
/// T(y + t) = T(y) G the stiffness of one block gives the others, G = [1, -t x; 0, 1].
void spread_from_a(const Eigen::Vector3d& t, PatchStep<SpatialRigid>& patch)
{
    using Matrix = Eigen::Matrix3d;
    const Matrix turn = skew(t);
    SpatialRigid::Square across = patch.aa;  // aa G
    across.topRightCorner<3, 3>() -= patch.aa.topLeftCorner<3, 3>() * turn;
    across.bottomRightCorner<3, 3>() -= patch.aa.bottomLeftCorner<3, 3>() * turn;
    patch.ab = -across;
    patch.bb = across;  // G^T aa G
    patch.bb.bottomRows<3>() += turn * across.topRows<3>();
}

void add_points(const std::vector<PointStep<3>>& points, bool published, PatchStep<SpatialRigid>& patch)
{
    const PointStep<3>* any = nullptr;
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        const PointStep<3>& p = points[i];
        if (!has_stiffness(p, published)) continue;
        any = &p;
        const Eigen::Vector3d& lever = patch.row_a >= 0 ? p.lever_a : p.lever_b;
        SpatialRigid::add_stiffness(patch.row_a >= 0 ? patch.aa : patch.bb, lever, lever,
                                    point_stiffness<3>(p, patch.normal, published));
    }
    if (any && patch.row_a >= 0 && patch.row_b >= 0) spread_from_a(any->lever_b - any->lever_a, patch);
}

void add_points(const std::vector<PointStep<2>>& points, bool published, PatchStep<PlanarRigid>& patch)
{
    for (int i = patch.first; i < patch.first + patch.count; ++i)
        if (has_stiffness(points[i], published))
            add_point(points[i], point_stiffness<2>(points[i], patch.normal, published), patch);
}

}  // namespace

template <class K>
void patch_stiffness(bool published, const std::vector<PointStep<K::dimension>>& points, PatchStep<K>& patch)
{
    patch.aa.setZero();
    patch.ab.setZero();
    patch.bb.setZero();
    add_points(points, published, patch);
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
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        const PointStep<K::dimension>& p = points[i];
        if (!has_stiffness(p, false)) continue;
        const typename K::Vector& lever = of_a ? p.lever_a : p.lever_b;
        K::add_stiffness(stiffness, lever, lever, point_stiffness<K::dimension>(p, patch.normal, false));
    }
}

#define VOUSSOIR_INSTANTIATE(K)                                                                               \
    template void patch_stiffness(bool, const std::vector<PointStep<K::dimension>>&, PatchStep<K>&);          \
    template void contact_stiffness(bool, int, ContactStep<K>&);                                              \
    template void add_block_stiffness(const PatchStep<K>&, const std::vector<PointStep<K::dimension>>&, bool, \
                                      K::Square&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
