#include "tests/verification/experiments/cube_by_impulses.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voussoir::verification
{
namespace
{

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double gravity = 9.81, half = cube_edge / 2;

struct Corner {
    Vector3d lever = Vector3d::Zero();    // m
    Vector3d impulse = Vector3d::Zero();  // Ns, so far in this step
    double before = 0;                    // m/s, normal speed before the step
    Vector3d slip = Vector3d::Zero();     // m/s, before the step
    double least = 0;                     // Ns, along the normal: what a compression gives back
};

/// Its inertia is the same about every axis, so nothing turns the spin in flight.
class Cube
{
 public:
    Cube(const Toss& toss, const CubeSetting& setting, const ImpactLaw& law)
        : setting_(setting),
          law_(law),
          centre_(toss.measured.centres[0]),
          turn_(toss.measured.turns[0]),
          velocity_(toss.velocity),
          spin_(toss.spin)
    {
    }

    void step(double h)
    {
        velocity_old_ = velocity_;
        spin_old_ = spin_;
        velocity_.z() -= gravity * h;
        meet(h);
        centre_ += h / 2 * (velocity_old_ + velocity_);
        const Vector3d way = h / 2 * (spin_old_ + spin_);
        if (way.norm() > 0)
            turn_ = (Quaterniond(Eigen::AngleAxisd(way.norm(), way.normalized())) * turn_).normalized();
    }

    const Vector3d& centre() const { return centre_; }
    const Quaterniond& turn() const { return turn_; }

 private:
    static Vector3d speed_at(const Vector3d& v, const Vector3d& w, const Vector3d& lever)
    {
        return v + w.cross(lever);
    }
    static double mobility(const Vector3d& lever, const Vector3d& along)
    {
        return 1 / cube_mass + lever.cross(along).squaredNorm() / cube_inertia;
    }
    void push(const Corner& corner, const Vector3d& impulse)
    {
        velocity_ += impulse / cube_mass;
        spin_ += corner.lever.cross(impulse) / cube_inertia;
    }

    void meet(double h)
    {
        std::array<Corner, 8> corners;
        std::size_t count = 0;
        for (int i = 0; i < 8; ++i) {
            Corner corner;
            corner.lever = turn_ * (half * Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
            corner.slip = speed_at(velocity_old_, spin_old_, corner.lever);
            corner.before = corner.slip.z();
            corner.slip.z() = 0;
            if (centre_.z() + corner.lever.z() + h / 2 * corner.before <= setting_.table)
                corners[count++] = corner;
        }
        const auto end = corners.begin() + static_cast<std::ptrdiff_t>(count);
        const bool gives_back = law_.restitution == ImpactLaw::Restitution::of_the_impulse;
        sweep(corners.begin(), end, !gives_back);
        if (!gives_back) return;
        for (auto corner = corners.begin(); corner != end; ++corner)
            corner->least = (1 + restitution_of(*corner)) * corner->impulse.z();
        sweep(corners.begin(), end, false);
    }

    template <class Iterator>
    void sweep(Iterator begin, Iterator end, bool rebounds)
    {
        for (int i = 0; begin != end && i < 200; ++i) {
            double most = 0;
            for (Iterator corner = begin; corner != end; ++corner) most = std::max(most, act(*corner, rebounds));
            if (most < 1e-10) break;
        }
    }

    bool strikes(const Corner& corner) const { return -corner.before > law_.slowest; }

    double restitution_of(const Corner& corner) const
    {
        const double whole = setting_.restitution.value_or(0), approach = -std::min(corner.before, 0.0);
        return law_.half_speed > 0 ? whole * law_.half_speed / (law_.half_speed + approach) : whole;
    }

    /// @param rebounds whether its speed afterwards is restitution times its approach
    /// @returns the change of velocity [m/s]
    double act(Corner& corner, bool rebounds)
    {
        const Vector3d old = corner.impulse;
        const Vector3d up = Vector3d::UnitZ();
        const double wanted = rebounds ? -restitution_of(corner) * std::min(corner.before, 0.0) : 0;
        const Vector3d now = speed_at(velocity_, spin_, corner.lever);
        corner.impulse.z() =
            std::max(corner.least, corner.impulse.z() + (wanted - now.z()) / mobility(corner.lever, up));
        push(corner, corner.impulse - old);
        const Vector3d middle = corner.impulse;
        Vector3d slip = speed_at(velocity_, spin_, corner.lever);
        slip.z() = 0;
        if (strikes(corner)) slip += law_.tangential * corner.slip;
        if (slip.norm() > 0) {
            Vector3d rub = corner.impulse - slip / mobility(corner.lever, slip.normalized());
            rub.z() = 0;
            const double friction =
                strikes(corner) ? law_.friction.value_or(setting_.friction) : setting_.friction;
            const double bound = friction * corner.impulse.z();
            if (rub.norm() > bound) rub *= bound / rub.norm();
            corner.impulse.head<2>() = rub.head<2>();
        }
        push(corner, corner.impulse - middle);
        return (corner.impulse - old).norm() / cube_mass;
    }

    CubeSetting setting_;
    ImpactLaw law_;
    Vector3d centre_;  // m
    Quaterniond turn_;
    Vector3d velocity_, spin_;                                                // m/s, rad/s
    Vector3d velocity_old_ = Vector3d::Zero(), spin_old_ = Vector3d::Zero();  // at the start of the step
};

}  // namespace

TrackedMotion cube_by_impulses(const Toss& toss, const CubeSetting& setting, double step, const ImpactLaw& law)
{
    Cube cube(toss, setting, law);
    TrackedMotion predicted;
    double time = 0;
    for (const double row : toss.measured.times) {
        const int parts = static_cast<int>(std::ceil((row - time) / step));
        for (int i = 0; i < parts; ++i) cube.step((row - time) / parts);
        time = row;
        predicted.times.push_back(row);
        predicted.centres.push_back(cube.centre());
        predicted.turns.push_back(cube.turn());
    }
    return predicted;
}

}  // namespace voussoir::verification
