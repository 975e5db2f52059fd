#include "libdda/contact/stone_bending.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdda/contact/normal_stiffness.h"
#include "libdda/geometry/plane.h"

namespace voussoir::contact
{

namespace
{

/// A half stone as a beam along the normal, of the second moments of the stone.
template <int D>
struct HalfBeam {
    MatrixIn<D> section;  // m2, second moments of the section in the plane of the face, over its area
    double depth = 0;     // m
    double area = 0;      // m2, of the section

    HalfBeam(const Model& model, const HalfStone<D>& half, const VectorIn<D>& normal)
    {
        const Block& block = model.blocks[half.block];
        const MatrixIn<D> drawn = from_space<D>(block.moments.second) / block.moments.volume;
        const MatrixIn<D> spread = half.map * drawn * half.map.transpose();
        const MatrixIn<D> along = MatrixIn<D>::Identity() - normal * normal.transpose();
        section = along * spread * along;
        depth = std::sqrt(3 * normal.dot(spread * normal));
        area = block.moments.volume / (2 * depth);
    }
};

/// Modulus against bending [Pa]: of what cannot move across its plane it is that of a plate.
double bending_modulus(const Model& model, const BlockMaterial& material)
{
    const bool in_plane_strain = is_planar(model.kinematics) && model.plane == PlaneCondition::strain;
    return material.young / (in_plane_strain ? 1 - material.poisson * material.poisson : 1);
}

/// Of one half stone, under moments of the same mean on all of its section: the face takes its share of that.
template <int D>
MatrixIn<D> flexibility_of(const Model& model, const HalfStone<D>& half, const VectorIn<D>& normal, double area)
{
    const HalfBeam<D> beam(model, half, normal);
    const MatrixIn<D> across = normal * normal.transpose(), along = MatrixIn<D>::Identity() - across;
    const MatrixIn<D> inverse = (beam.section + beam.section.trace() * across).inverse();
    const double modulus = bending_modulus(model, model.materials[model.blocks[half.block].material]);
    return beam.depth / (modulus * area) * along * inverse * along;
}

/// Torsion constant J of a section over its area [m2], by c of J = A^4 / (c Ip): of a rectangle that of its sides,
/// of an ellipse 4 pi^2; what the section is, its area tells from the second moments.
double torsion_constant(const Eigen::Matrix3d& section, double area)
{
    const double polar = section.trace();
    // The minors of what has no extent across its plane are the product of its principal moments.
    const double product = 0.5 * (polar * polar - section.squaredNorm());
    const double apart = std::sqrt(std::max(0.0, 0.25 * polar * polar - product));
    const double long_square = 12 * (0.5 * polar + apart), short_square = 12 * (0.5 * polar - apart);
    const double slender = std::sqrt(short_square / long_square), to_fourth = std::pow(slender, 4);
    const double of_rectangle = short_square * (1.0 / 3 - 0.21 * slender * (1 - to_fourth / 12));
    constexpr double pi = std::numbers::pi;
    const double of_ellipse = area * area / (4 * pi * pi * polar);
    const double roundness = std::clamp((area / std::sqrt(product) - 12) / (4 * pi - 12), 0.0, 1.0);
    return (1 - roundness) * of_rectangle + roundness * of_ellipse;
}

/// A joint whose stiffness follows from its stones is there for the contact alone: what it yields in bending is
/// taken off the stones, so that both together bend as the stones would.
double left_by_joint(Kinematics kinematics, const JointMaterial& joint)
{
    if (joint.stiffness.kind != ContactStiffness::Kind::from_modulus) return 1;
    return std::max(0.0, 1 - 1 / (times_modulus(kinematics, joint) * joint.stiffness.factor));
}

}  // namespace

template <int D>
MatrixIn<D> bending_flexibility(const Model& model, const HalfStone<D>& a, const HalfStone<D>& b,
                                const VectorIn<D>& normal, double area)
{
    MatrixIn<D> sum = MatrixIn<D>::Zero();
    const JointMaterial& joint = model.joint_between(a.block, b.block);
    if (!is_deformable(model.kinematics) || joint.face == FaceLaw::corners) return sum;
    for (const HalfStone<D>& half : {a, b})
        if (!half.held) sum += flexibility_of(model, half, normal, area);
    return left_by_joint(model.kinematics, joint) * sum;
}

template <int D>
double twist_flexibility(const Model& model, const HalfStone<D>& a, const HalfStone<D>& b,
                         const VectorIn<D>& normal, double area)
{
    double sum = 0;
    if constexpr (twists<D>) {
        if (!is_deformable(model.kinematics) || model.joint_between(a.block, b.block).face == FaceLaw::corners)
            return 0;
        for (const HalfStone<D>& half : {a, b}) {
            if (half.held) continue;
            const BlockMaterial& material = model.materials[model.blocks[half.block].material];
            const HalfBeam<D> beam(model, half, normal);
            sum += 2 * (1 + material.poisson) / material.young * beam.depth /
                   (area * torsion_constant(beam.section, beam.area));
        }
    }
    return sum;
}

#define VOUSSOIR_INSTANTIATE(D)                                                                                   \
    template MatrixIn<D> bending_flexibility(const Model&, const HalfStone<D>&, const HalfStone<D>&,              \
                                             const VectorIn<D>&, double);                                         \
    template double twist_flexibility(const Model&, const HalfStone<D>&, const HalfStone<D>&, const VectorIn<D>&, \
                                      double)
VOUSSOIR_INSTANTIATE(3);
VOUSSOIR_INSTANTIATE(2);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::contact
