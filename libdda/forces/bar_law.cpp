#include "libdda/forces/bar_law.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libdda/block/orthonormal.h"

namespace voussoir::step
{

namespace
{

/// Along the axis: what is elastic of it lies between two stretches.
struct AxialLaw {
    double stiffness, plastic, tension, compression;  // N/m, m, N

    double force(double stretch) const
    {
        return std::clamp(stiffness * (stretch - plastic), -compression, tension);
    }
    bool is_elastic(double stretch) const
    {
        const double trial = stiffness * (stretch - plastic);
        return trial >= -compression && trial <= tension;
    }
    /// The mean of the force between two stretches, and its derivative by the second.
    std::pair<double, double> mean(double from, double to) const
    {
        const double low = plastic - compression / stiffness, high = plastic + tension / stiffness;
        const double first = std::min(from, to), last = std::max(from, to), way = last - first;
        if (first >= low && last <= high) return {stiffness * (0.5 * (first + last) - plastic), 0.5 * stiffness};
        const double a = std::clamp(first, low, high), b = std::clamp(last, low, high);
        double work = stiffness * (0.5 * (a + b) - plastic) * (b - a);
        if (first < low) work -= compression * (std::min(last, low) - first);
        if (last > high) work += tension * (last - std::max(first, high));
        if (!(way > 0)) return {force(to), 0};
        const double average = work / way;
        return {average, std::max(0.0, (force(to) - average) / (to - from))};
    }
};

template <int D>
void add_axial(const Bar& bar, double start, double end, double end_share, BarForce<D>& result)
{
    const AxialLaw law{bar.axial, result.plastic[0], bar.tension, bar.compression};
    const double at_end = law.force(end);
    result.force[0] = end_share * at_end;
    result.tangent(0, 0) = law.is_elastic(end) ? end_share * bar.axial : 0;
    if (end_share < 1) {
        const auto [mean, slope] = law.mean(start, end);
        result.force[0] += (1 - end_share) * mean;
        result.tangent(0, 0) += (1 - end_share) * slope;
    }
    // A bar that carries nothing is slack: it comes back to the length at which it was.
    if (!law.is_elastic(end) && at_end != 0) result.plastic[0] = end - at_end / bar.axial;
}

template <int D>
using Across = Eigen::Matrix<double, D - 1, 1>;
template <int D>
using AcrossSquare = Eigen::Matrix<double, D - 1, D - 1>;

/// Across it: the force at `x`, the stretch less what is plastic, and its derivative.
template <int D>
struct LateralLaw {
    double stiffness, limit;  // N/m, N

    Across<D> force(const Across<D>& x) const
    {
        const double trial = stiffness * x.norm();
        return trial <= limit ? Across<D>(stiffness * x) : Across<D>(limit / x.norm() * x);
    }
    AcrossSquare<D> tangent(const Across<D>& x) const
    {
        const AcrossSquare<D> one = AcrossSquare<D>::Identity();
        if (stiffness * x.norm() <= limit) return stiffness * one;
        const Across<D> way = x.normalized();
        return limit / x.norm() * (one - way * way.transpose());
    }
    /// Adds the integrals of the force and of t times its derivative over the part of the way from `from` to `to`
    /// on which t goes from t_0 to t_1.
    void add_part(const Across<D>& from, const Across<D>& to, double t_0, double t_1, Across<D>& force_sum,
                  AcrossSquare<D>& tangent_sum) const
    {
        struct Gauss {
            double place, weight;
        };
        const double middle = 0.5 * (t_0 + t_1), half = 0.5 * (t_1 - t_0);
        for (const Gauss& gauss :
             {Gauss{0.8611363115940526, 0.3478548451374538}, Gauss{0.3399810435848563, 0.6521451548625461}})
            for (const double t : {middle - half * gauss.place, middle + half * gauss.place}) {
                const Across<D> x = from + t * (to - from);
                force_sum += half * gauss.weight * force(x);
                tangent_sum += half * gauss.weight * t * tangent(x);
            }
    }
    /// The mean of the force on the straight way, and its derivative by the end: exact but for Gauss's rule of
    /// four points where it yields.
    void mean(const Across<D>& from, const Across<D>& to, Across<D>& force_sum, AcrossSquare<D>& tangent_sum) const
    {
        // Where it crosses the circle within which it is elastic.
        const Across<D> way = to - from;
        const double radius = limit / stiffness, a = way.squaredNorm(), half = from.dot(way);
        const double inside = half * half - a * (from.squaredNorm() - radius * radius);
        double entry = 0, exit = 0;
        if (std::isfinite(radius) && a > 0 && inside > 0) {
            entry = std::clamp((-half - std::sqrt(inside)) / a, 0.0, 1.0);
            exit = std::clamp((-half + std::sqrt(inside)) / a, 0.0, 1.0);
        }
        const double ends[] = {0, entry, exit, 1};
        for (std::size_t i = 1; i < std::size(ends); ++i)
            if (ends[i] > ends[i - 1]) add_part(from, to, ends[i - 1], ends[i], force_sum, tangent_sum);
    }
};

template <int D>
void add_lateral(const Bar& bar, const VectorIn<D>& start, const VectorIn<D>& end, double end_share,
                 BarForce<D>& result)
{
    const LateralLaw<D> law{bar.lateral, bar.shear};
    const Across<D> plastic = result.plastic.template tail<D - 1>();
    const Across<D> from = start.template tail<D - 1>() - plastic, to = end.template tail<D - 1>() - plastic;
    Across<D> force = Across<D>::Zero();
    AcrossSquare<D> tangent = AcrossSquare<D>::Zero();
    if (end_share < 1) law.mean(from, to, force, tangent);
    const Across<D> at_end = law.force(to);
    result.force.template tail<D - 1>() = (1 - end_share) * force + end_share * at_end;
    result.tangent.template bottomRightCorner<D - 1, D - 1>() =
        (1 - end_share) * tangent + end_share * law.tangent(to);
    if (bar.lateral * to.norm() > bar.shear)
        result.plastic.template tail<D - 1>() = end.template tail<D - 1>() - at_end / bar.lateral;
}

/// Directions across a unit vector: with it they make a right-handed frame.
MatrixIn<3> frame_along(const Eigen::Vector3d& axis)
{
    MatrixIn<3> frame;
    frame << axis, axis.unitOrthogonal(), axis.cross(axis.unitOrthogonal());
    return frame;
}

MatrixIn<2> frame_along(const Eigen::Vector2d& axis)
{
    MatrixIn<2> frame;
    frame << axis, Eigen::Vector2d(-axis.y(), axis.x());
    return frame;
}

template <int D>
double energy_of(const Model& model, const State& state)
{
    double energy = 0;
    for (std::size_t i = 0; i < model.bars.size(); ++i) {
        if (is_out<D>(state, i)) continue;
        const Bar& bar = model.bars[i];
        const PlacedBar<D> placed = place_bar<D>(bar, pose_in<D>(model.kinematics, state, bar.block_a),
                                                 pose_in<D>(model.kinematics, state, bar.block_b));
        energy += bar_energy<D>(bar, bar_force<D>(bar, placed.stretch, plastic_stretch<D>(state, i)).force);
    }
    return energy;
}

}  // namespace

template <int D>
BarForce<D> bar_force(const Bar& bar, const VectorIn<D>& stretch, const VectorIn<D>& plastic)
{
    return bar_force_in_step<D>(bar, stretch, stretch, plastic, 1);
}

template <int D>
BarForce<D> bar_force_in_step(const Bar& bar, const VectorIn<D>& start, const VectorIn<D>& end,
                              const VectorIn<D>& plastic, double end_share)
{
    BarForce<D> result;
    result.plastic = plastic;
    if (bar.axial > 0) add_axial<D>(bar, start[0], end[0], end_share, result);
    if (bar.lateral > 0) add_lateral<D>(bar, start, end, end_share, result);
    return result;
}

template <int D>
double bar_energy(const Bar& bar, const VectorIn<D>& force)
{
    double energy = 0;
    if (bar.axial > 0) energy += 0.5 * force[0] * force[0] / bar.axial;
    if (bar.lateral > 0) energy += 0.5 * force.template tail<D - 1>().squaredNorm() / bar.lateral;
    return energy;
}

template <int D>
PlacedBar<D> place_bar(const Bar& bar, const PoseIn<D>& a, const PoseIn<D>& b)
{
    const VectorIn<D> anchor_a = from_space<D>(bar.anchor_a), anchor_b = from_space<D>(bar.anchor_b);
    PlacedBar<D> placed;
    placed.end_a = a.centroid + a.map * anchor_a;
    placed.end_b = b.centroid + b.map * anchor_b;
    const VectorIn<D> apart = placed.end_b - placed.end_a;
    if (bar.is_rod) {
        const double length = apart.norm();
        placed.frame.col(0) = apart / std::max(length, std::numeric_limits<double>::min());
        placed.stretch[0] = length - bar.length;
    } else {
        placed.frame = orthonormal<D>(a.map * frame_along(from_space<D>(bar.axis)));
        placed.stretch = placed.frame.transpose() * apart;
    }
    return placed;
}

double bars_energy(const Model& model, const State& state)
{
    if (model.bars.empty()) return 0;
    return is_planar(model.kinematics) ? energy_of<2>(model, state) : energy_of<3>(model, state);
}

#define VOUSSOIR_INSTANTIATE(D)                                                                   \
    template BarForce<D> bar_force<D>(const Bar&, const VectorIn<D>&, const VectorIn<D>&);        \
    template BarForce<D> bar_force_in_step<D>(const Bar&, const VectorIn<D>&, const VectorIn<D>&, \
                                              const VectorIn<D>&, double);                        \
    template double bar_energy<D>(const Bar&, const VectorIn<D>&);                                \
    template PlacedBar<D> place_bar<D>(const Bar&, const PoseIn<D>&, const PoseIn<D>&)
VOUSSOIR_INSTANTIATE(2);
VOUSSOIR_INSTANTIATE(3);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
