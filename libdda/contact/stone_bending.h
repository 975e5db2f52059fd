// How stones bend beside a face.
//
// A block of uniform strain does not bend. What the half stone between a face and its centroid would turn under
// the moment of the face's pressure is a turn of the face here: the gap is that of the stones as they are drawn
// plus slope . (place - centre), slope = flexibility x moment, and the moment is that of the pressure at this gap.
// It has no mass, and is found anew wherever forces are. In the same way the two half stones twist under the
// couple of the face's friction. Source: docs/faces.md, "Stones that bend".
#pragma once

#include <Eigen/LU>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::contact
{

/// Whether stones twist about the normal of a face: those of planar scenes do not.
template <int D>
constexpr bool twists = D == 3;

constexpr double noticeable_twist = 0.1;  // of what a joint turns about its normal: less twist does not matter

/// One of the two stones of a face.
template <int D>
struct HalfStone {
    int block = 0;     // index into Model::blocks
    MatrixIn<D> map;   // of the block
    bool held = true;  // fully: it is as the ground is
};

/// What the two half stones turn by a moment of the pressure, about a vector in the plane of the face
/// [1/(Nm)]. Symmetric; zero unless stones are deformable and faces rest on points.
/// @param normal unit; @param area of the face [m2]
template <int D>
MatrixIn<D> bending_flexibility(const Model& model, const HalfStone<D>& a, const HalfStone<D>& b,
                                const VectorIn<D>& normal, double area);

/// What they twist by a couple about the normal [1/(Nm)]. Zero in planar scenes too.
template <int D>
double twist_flexibility(const Model& model, const HalfStone<D>& a, const HalfStone<D>& b,
                         const VectorIn<D>& normal, double area);

/// The moment of the forces of a face [Nm], and how it falls as the stones turn.
template <int N>
struct MomentOf {
    VectorIn<N> moment = VectorIn<N>::Zero();  // Nm
    MatrixIn<N> second = MatrixIn<N>::Zero();  // Nm
    double noise = 0;  // (Nm)2, sum of the squares of moments: rounding leaves a share of it

    /// @param stiffness of the force [N/m]; @param place m
    void add(double force, double stiffness, const VectorIn<N>& place)
    {
        moment += force * place;
        second += stiffness * place * place.transpose();
        noise += force * force * place.squaredNorm();
    }
    void add(double of_force, double of_stiffness)
    {
        moment.array() += of_force;
        second.array() += of_stiffness;
        noise += of_force * of_force;
    }
};

/// What the stones turn by a moment that the forces would have if they did not [1/(Nm)]. Symmetric.
/// @param share of the moment at the end, in that which acts; @param second of MomentOf [Nm]
template <int N>
MatrixIn<N> give_of(const MatrixIn<N>& flexibility, double share, const MatrixIn<N>& second)
{
    return flexibility * (share * MatrixIn<N>::Identity() + second * flexibility).inverse();
}

constexpr double balance_tolerance = 1e-13;  // of the points' moments
constexpr int most_balance_steps = 40, most_halvings = 10;

/// Solves steady + share x moment = forces(flexibility x moment) from `moment`. Forces fall as the stones give
/// way, so that there is one solution; Newton's steps are halved where they overshoot.
/// @param forces turn -> MomentOf<N>
template <int N, class Forces>
void balance_moment(const MatrixIn<N>& flexibility, const VectorIn<N>& steady, double share, const Forces& forces,
                    VectorIn<N>& moment)
{
    const auto left_over = [&](const VectorIn<N>& m, const MomentOf<N>& at) {
        return VectorIn<N>(steady + share * m - at.moment);
    };
    const auto size_of = [&](const VectorIn<N>& m) { return m.dot(flexibility * m); };
    MomentOf<N> at = forces(VectorIn<N>(flexibility * moment));
    VectorIn<N> rest = left_over(moment, at);
    for (int step = 0; step < most_balance_steps; ++step) {
        const double now = size_of(rest);
        if (now <= balance_tolerance * balance_tolerance * flexibility.trace() * at.noise) return;
        const VectorIn<N> way = -(share * MatrixIn<N>::Identity() + at.second * flexibility).inverse() * rest;
        const VectorIn<N> from = moment;
        double part = 1;
        for (int halving = 0; halving < most_halvings; ++halving, part *= 0.5) {
            moment = from + part * way;
            at = forces(VectorIn<N>(flexibility * moment));
            rest = left_over(moment, at);
            if (size_of(rest) < now) break;
        }
        if (size_of(rest) >= now) return;  // by rounding
    }
}

}  // namespace voussoir::contact
