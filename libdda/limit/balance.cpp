#include "libdda/limit/balance.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "libdda/solve/cholmod_solver.h"

namespace voussoir::limit
{

namespace
{

using Eigen::VectorXd;

// Mass of all blocks, over springs of stiffness one: what cannot be balanced moves against it. It is lowered step
// by step, for Newton's method finds the directions of slip where motion by springs and motion by mass are alike.
constexpr double first_mass = 1, last_mass = 1e-9, lowering = 0.1;
constexpr double moving = 1e-5;  // of the acceleration of a load: blocks that gain more do not stand
// Of what springs of stiffness one give way under the whole load: blocks that go that far move freely. Farther on
// the rounding of their motion comes near what springs between them give way.
constexpr double far_gone = 1e4;
constexpr double little = 0.02;  // of that acceleration, that an error shall be
constexpr double enough = 0.3;   // that it may be where rounding allows no less: blocks move all the same
constexpr int most_on_the_way = 30, most_iterations = 200, most_trials = 30;
constexpr double good_slope = 0.1;  // of the slope along a direction at its start, at the end of a line search
constexpr int most_states = 40;     // of normal forces
constexpr double beyond_friction = 1e-4;  // of the whole load, that a force may be

/// Newton's method for the motion of least energy.
class Settling
{
 public:
    explicit Settling(const Springs& springs)
        : springs_(springs), motion_(springs.no_motion()), before_(motion_), solver_(solve::make_cholmod_solver())
    {
    }

    Balance settle()
    {
        Balance balance;
        for (mass_ = first_mass; mass_ > last_mass * (1 + lowering); mass_ *= lowering) {
            begin_with_mass();
            if (iterate(most_on_the_way, balance.iterations) && is_plain()) {
                judge(balance);
                return balance;
            }
        }
        begin_with_mass();
        if (iterate(most_iterations, balance.iterations) || error_of(gradient_) <= enough * fastest())
            judge(balance);
        return balance;
    }
    const VectorXd& motion() const { return motion_; }

 private:
    /// Blocks that move do so with accelerations that hardly depend on the mass, others stay: two motions tell
    /// both.
    void begin_with_mass()
    {
        const VectorXd ahead = motion_ + (motion_ - before_) / lowering;
        before_ = motion_;
        VectorXd there;
        springs_.gradient(mass_, motion_, gradient_);
        springs_.gradient(mass_, ahead, there);
        if (error_of(there) >= error_of(gradient_)) return;
        motion_ = ahead;
        gradient_ = there;
    }
    /// Until the error is little; false where that is not reached.
    bool iterate(int most, int& iterations)
    {
        VectorXd direction;
        for (int i = 0; i < most; ++i) {
            if (error_of(gradient_) <= little * std::max(fastest(), moving)) return true;
            ++iterations;
            springs_.stiffness(mass_, motion_, matrix_);
            if (!solver_->solve(matrix_, -gradient_, direction).solved || !go_along(direction)) return false;
        }
        return false;
    }
    /// Goes to where the energy along a direction is nearly least; false where it does not fall.
    bool go_along(const VectorXd& direction)
    {
        const double at_start = gradient_.dot(direction);
        if (!(at_start < 0)) return false;
        double low = 0, high = 0, low_slope = at_start, high_slope = 0, step = 1;
        VectorXd place, there;
        for (int trial = 0; trial < most_trials; ++trial) {
            place = motion_ + step * direction;
            springs_.gradient(mass_, place, there);
            const double slope = there.dot(direction);
            if (std::abs(slope) <= -good_slope * at_start) break;
            if (slope < 0) {
                low = step, low_slope = slope;
                if (high == 0) break;  // farther only by another direction
            } else {
                high = step, high_slope = slope;
            }
            const double cut = low_slope / (low_slope - high_slope);
            step = low + (high - low) * std::clamp(cut, 0.1, 0.9);
        }
        motion_ = place;
        gradient_ = there;
        return true;
    }
    /// Whether blocks are in balance already, or move freely: a lower mass would say no more.
    bool is_plain() const { return fastest() <= 0.1 * moving || motion_.lpNorm<Eigen::Infinity>() >= far_gone; }
    double fastest() const { return mass_ * motion_.lpNorm<Eigen::Infinity>(); }
    /// The energy is convex, and its curvature at least the mass: what is left of the gradient bounds the error of
    /// the accelerations.
    double error_of(const VectorXd& gradient) const
    {
        return gradient.cwiseQuotient(springs_.weights()).lpNorm<Eigen::Infinity>();
    }
    void judge(Balance& balance) const
    {
        balance.acceleration = fastest();
        if (fastest() <= moving) {
            balance.standing = Standing::balanced;
        } else {
            balance.standing = Standing::mechanism;
            // By how much farther blocks go with less mass: without what springs give way, which hardly depends on
            // it.
            const VectorXd farther = motion_ - before_;
            balance.velocities = springs_.velocities(farther);
            balance.dissipation = springs_.power(motion_, farther);
        }
    }

    const Springs& springs_;
    double mass_ = first_mass;
    VectorXd motion_, before_, gradient_;  // before: with the mass of before
    solve::BlockMatrix matrix_;
    std::unique_ptr<solve::LinearSolver> solver_;
};

bool has_strength(const LimitContact& contact)
{
    return contact.cohesion > 0 || contact.tension > 0;
}

}  // namespace

Balance balance_of(const LimitProblem& problem)
{
    const Springs springs(problem);
    return Settling(springs).settle();
}

Standing standing_without_dilatancy(const LimitProblem& problem)
{
    if (std::any_of(problem.contacts.begin(), problem.contacts.end(), has_strength)) return Standing::unknown;
    Springs springs(problem);
    std::vector<double> normal;
    for (int i = 0; i <= most_states; ++i) {
        Settling settling(springs);
        const Standing standing = settling.settle().standing;
        if (i == 0 && standing != Standing::balanced) return standing;
        if (standing == Standing::unknown) break;
        if (i > 0 && standing == Standing::balanced &&
            springs.most_beyond_friction(settling.motion()) <= beyond_friction)
            return standing;
        const std::vector<double> next = springs.normal_forces(settling.motion());
        if (i == 0) normal = next;
        for (std::size_t k = 0; k < normal.size(); ++k) normal[k] = (normal[k] + next[k]) / 2;
        springs.rub_as_under(normal);
    }
    return Standing::mechanism;
}

}  // namespace voussoir::limit
