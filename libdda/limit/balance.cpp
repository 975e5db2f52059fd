#include "libdda/limit/balance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "libdda/limit/friction_set.h"
#include "libdda/solve/block_matrix.h"
#include "libdda/solve/cholmod_solver.h"

namespace voussoir::limit
{

namespace
{

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Jacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 6>;

// Forces over the whole load, lengths over the size of the scene, springs of stiffness one.
// Mass of all blocks: what cannot be balanced moves against it. It is lowered step by step, for Newton's method
// finds the directions of slip where motion by springs and motion by mass are alike.
constexpr double first_mass = 1, last_mass = 1e-9, lowering = 0.1;
constexpr double moving = 1e-5;  // of the acceleration of a load: blocks that gain more do not stand
constexpr double little = 0.02;  // of that acceleration, that an error may be
constexpr int most_iterations = 200, most_trials = 30;
constexpr int most_states = 40;           // of normal forces
constexpr double beyond_friction = 1e-4;  // of the whole load, that a force may be
constexpr double good_slope = 0.1;  // of the slope along a direction at its start, at the end of a line search

Matrix3d cross_matrix(const Vector3d& v)
{
    Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

/// A spring between two blocks that bears the forces of a set.
struct Spring {
    double friction = 0;         // -, of the contact
    int row_a = -1, row_b = -1;  // -1: held
    FrictionSet set;
    bool is_bar = false;  // bears pull up to `tension`, push up to `compression`, shear up to `cohesion`
    double compression = 0;
    Jacobian on_a, on_b;                                // motion of its ends by those of the blocks
    int diagonal_a = -1, diagonal_b = -1, beside = -1;  // positions in the matrix
};

double clamp_finite(double force, double scale)
{
    return std::min(force / scale, 1e6);
}

/// Pull along the axis up to one bound, push up to another, shear up to a third, each by itself.
NearestForce nearest_bar_force(const Spring& spring, const Vector3d& given)
{
    const Vector3d& axis = spring.set.normal;  // from a to b: positive pulls a towards b
    const double along = given.dot(axis), kept = std::clamp(along, -spring.compression, spring.set.tension);
    const Vector3d across = given - along * axis;
    const double shear = across.norm();
    NearestForce nearest;
    nearest.force = kept * axis;
    if (kept == along) nearest.derivative = axis * axis.transpose();
    const Matrix3d in_plane = Matrix3d::Identity() - axis * axis.transpose();
    if (shear <= spring.set.cohesion) {
        nearest.force += across;
        nearest.derivative += in_plane;
    } else {
        const Vector3d direction = across / shear;
        nearest.force += spring.set.cohesion * direction;
        nearest.derivative += spring.set.cohesion / shear * (in_plane - direction * direction.transpose());
    }
    return nearest;
}

class SpringsOnBlocks
{
 public:
    explicit SpringsOnBlocks(const LimitProblem& problem) : problem_(problem), unknowns_(problem.planar ? 3 : 6)
    {
        scale();
        number_rows();
        add_springs();
        make_pattern();
    }

    Balance settle()
    {
        Balance balance;
        VectorXd gradient;
        motion_ = VectorXd::Zero(load_.size());
        for (mass_ = first_mass; mass_ >= 0.99 * last_mass; mass_ *= lowering) {
            begin_with_mass(gradient);
            const bool last = mass_ * lowering < 0.99 * last_mass;
            if (!iterate(last ? most_iterations : 30, gradient, balance) && last) break;
            if (last) judge(gradient, balance);
        }
        return balance;
    }

    /// (springs) over the whole load, of contacts
    std::vector<double> normal_forces() const
    {
        std::vector<double> forces;
        for (const Spring& spring : springs_)
            forces.push_back(force_of(spring, motion_).force.dot(spring.set.normal));
        return forces;
    }
    /// Friction becomes a cohesion, by these normal forces.
    void rub_as_under(const std::vector<double>& normal_forces)
    {
        constexpr double slack = 1e-7;  // of the whole load: the first forces must not be at the edge
        for (std::size_t i = 0; i < springs_.size(); ++i)
            if (!springs_[i].is_bar)
                springs_[i].set = {springs_[i].set.normal, 0,
                                   springs_[i].friction * std::max(0.0, normal_forces[i]) + slack, 0};
    }
    /// Most that the shear of a contact exceeds its friction, over the whole load.
    double most_beyond_friction() const
    {
        double most = 0;
        for (const Spring& spring : springs_) {
            if (spring.is_bar) continue;
            const Vector3d force = force_of(spring, motion_).force;
            const double normal = force.dot(spring.set.normal);
            most = std::max(most, (force - normal * spring.set.normal).norm() - spring.friction * normal);
        }
        return most;
    }

 private:
    void scale()
    {
        for (const LimitBlock& block : problem_.blocks) force_ += block.dead.norm();
        Vector3d middle = Vector3d::Zero();
        for (const LimitBlock& block : problem_.blocks)
            middle += block.centroid / static_cast<double>(problem_.blocks.size());
        for (const LimitBlock& block : problem_.blocks)
            length_ = std::max(length_, (block.centroid - middle).norm());
        if (force_ == 0) force_ = 1;
        if (length_ == 0) length_ = 1;
    }
    void number_rows()
    {
        for (const LimitBlock& block : problem_.blocks) {
            const bool fully =
                block.turning_held && block.held[0] && block.held[2] && (problem_.planar || block.held[1]);
            row_of_.push_back(fully ? -1 : rows_++);
        }
    }
    /// Motion of a point of a block by the block's own, its turning times the length; held components do nothing.
    Jacobian jacobian(int block, const Vector3d& point) const
    {
        const LimitBlock& own = problem_.blocks[static_cast<std::size_t>(block)];
        Eigen::Matrix<double, 3, 6> whole;
        whole << Matrix3d::Identity(), -cross_matrix((point - own.centroid) / length_);
        for (int axis = 0; axis < 3; ++axis)
            if (own.held[static_cast<std::size_t>(axis)]) whole.col(axis).setZero();
        if (own.turning_held) whole.rightCols<3>().setZero();
        if (!problem_.planar) return whole;
        Jacobian in_plane(3, 3);
        in_plane << whole.col(0), whole.col(2), whole.col(4);
        return in_plane;
    }
    void add_springs()
    {
        for (const LimitContact& contact : problem_.contacts) {
            Spring spring = between(contact.block_a, contact.position, contact.block_b, contact.position);
            const double tension = contact.friction > 0
                                       ? std::min(contact.tension, contact.cohesion / contact.friction)
                                       : contact.tension;
            spring.set = {contact.normal, contact.friction, clamp_finite(contact.cohesion, force_),
                          clamp_finite(tension, force_)};
            spring.friction = contact.friction;
            add(std::move(spring));
        }
        for (const LimitBar& bar : problem_.bars) {
            Spring spring = between(bar.block_a, bar.end_a, bar.block_b, bar.end_b);
            spring.is_bar = true;
            spring.set = {bar.axis, 0, clamp_finite(bar.shear, force_), clamp_finite(bar.tension, force_)};
            spring.compression = clamp_finite(bar.compression, force_);
            add(std::move(spring));
        }
    }
    Spring between(int a, const Vector3d& end_a, int b, const Vector3d& end_b) const
    {
        Spring spring;
        spring.row_a = row_of_[static_cast<std::size_t>(a)];
        spring.row_b = row_of_[static_cast<std::size_t>(b)];
        spring.on_a = jacobian(a, end_a);
        spring.on_b = -jacobian(b, end_b);
        return spring;
    }
    void add(Spring spring)
    {
        if (spring.row_a >= 0 || spring.row_b >= 0) springs_.push_back(std::move(spring));
    }
    /// Weights of blocks: what they carry, as if it lay where they are touched.
    void weigh()
    {
        std::vector<double> squared(static_cast<std::size_t>(rows_), 0), count(squared);
        for (const Spring& spring : springs_)
            for (const auto& [row, jacobian] :
                 {std::pair(spring.row_a, &spring.on_a), std::pair(spring.row_b, &spring.on_b)})
                if (row >= 0) {
                    squared[static_cast<std::size_t>(row)] += jacobian->rightCols(unknowns_ / 2).squaredNorm() / 2;
                    ++count[static_cast<std::size_t>(row)];
                }
        weights_ = VectorXd::Zero(rows_ * unknowns_);
        load_ = weights_;
        for (std::size_t b = 0; b < problem_.blocks.size(); ++b) {
            if (row_of_[b] < 0) continue;
            const LimitBlock& block = problem_.blocks[b];
            const auto row = static_cast<std::size_t>(row_of_[b]);
            const double share = std::max(block.dead.norm() / force_, 1e-6 / static_cast<double>(rows_));
            const double lever = std::max(count[row] > 0 ? squared[row] / count[row] : 0, 1e-6);
            auto weights = weights_.segment(row_of_[b] * unknowns_, unknowns_);
            auto load = load_.segment(row_of_[b] * unknowns_, unknowns_);
            const int turning = problem_.planar ? 1 : 3;
            weights.setConstant(share);
            weights.tail(turning).setConstant(share * lever);
            int i = 0;
            for (int axis = 0; axis < 3; ++axis) {
                if (problem_.planar && axis == 1) continue;
                if (!block.held[static_cast<std::size_t>(axis)]) load[i] = block.dead[axis] / force_;
                ++i;
            }
        }
    }
    void make_pattern()
    {
        std::vector<std::pair<int, int>> pairs;
        for (const Spring& spring : springs_)
            if (spring.row_a >= 0 && spring.row_b >= 0)
                pairs.emplace_back(std::max(spring.row_a, spring.row_b), std::min(spring.row_a, spring.row_b));
        solve::set_pattern(matrix_, unknowns_, rows_, pairs);
        for (Spring& spring : springs_) {
            if (spring.row_a >= 0) spring.diagonal_a = matrix_.diagonal(spring.row_a);
            if (spring.row_b >= 0) spring.diagonal_b = matrix_.diagonal(spring.row_b);
            if (spring.row_a >= 0 && spring.row_b >= 0)
                spring.beside =
                    matrix_.position(std::max(spring.row_a, spring.row_b), std::min(spring.row_a, spring.row_b));
        }
        solver_ = solve::make_cholmod_solver();
        weigh();
    }
    Vector3d apart(const Spring& spring, const VectorXd& motion) const
    {
        Vector3d apart = Vector3d::Zero();
        if (spring.row_a >= 0) apart += spring.on_a * motion.segment(spring.row_a * unknowns_, unknowns_);
        if (spring.row_b >= 0) apart += spring.on_b * motion.segment(spring.row_b * unknowns_, unknowns_);
        return apart;
    }
    /// What springs take of the motion beyond what they store, which is nothing beside it.
    double dissipation() const
    {
        double taken = 0;
        for (const Spring& spring : springs_) {
            const Vector3d force = force_of(spring, motion_).force;
            taken -= force.dot(apart(spring, motion_)) + force.squaredNorm();
        }
        return taken * force_ * length_;
    }
    NearestForce force_of(const Spring& spring, const VectorXd& motion) const
    {
        const Vector3d apart = this->apart(spring, motion);
        return spring.is_bar ? nearest_bar_force(spring, -apart) : nearest_force(spring.set, -apart);
    }
    void gradient_at(const VectorXd& motion, VectorXd& gradient) const
    {
        gradient = mass_ * weights_.cwiseProduct(motion) - load_;
        for (const Spring& spring : springs_) {
            const Vector3d force = force_of(spring, motion).force;
            if (spring.row_a >= 0)
                gradient.segment(spring.row_a * unknowns_, unknowns_) -= spring.on_a.transpose() * force;
            if (spring.row_b >= 0)
                gradient.segment(spring.row_b * unknowns_, unknowns_) -= spring.on_b.transpose() * force;
        }
    }
    Eigen::Map<MatrixXd> block(int position) { return {matrix_.block(position), unknowns_, unknowns_}; }
    void assemble()
    {
        std::fill(matrix_.values.begin(), matrix_.values.end(), 0);
        for (int row = 0; row < rows_; ++row)
            block(matrix_.diagonal(row)).diagonal() = mass_ * weights_.segment(row * unknowns_, unknowns_);
        for (const Spring& spring : springs_) {
            const Matrix3d derivative = force_of(spring, motion_).derivative;
            if (derivative.isZero(0)) continue;
            const Jacobian a = derivative * spring.on_a, b = derivative * spring.on_b;
            if (spring.row_a >= 0) block(spring.diagonal_a) += spring.on_a.transpose() * a;
            if (spring.row_b >= 0) block(spring.diagonal_b) += spring.on_b.transpose() * b;
            if (spring.beside < 0) continue;
            if (spring.row_a > spring.row_b)
                block(spring.beside) += spring.on_a.transpose() * b;
            else
                block(spring.beside) += spring.on_b.transpose() * a;
        }
    }
    /// Goes to where the energy along a direction is nearly least; false where it does not fall.
    bool go_along(const VectorXd& direction, VectorXd& gradient)
    {
        const double at_start = gradient.dot(direction);
        if (!(at_start < 0)) return false;
        double low = 0, high = 0, low_slope = at_start, high_slope = 0, step = 1;
        VectorXd place, there;
        for (int trial = 0; trial < most_trials; ++trial) {
            place = motion_ + step * direction;
            gradient_at(place, there);
            const double slope = there.dot(direction);
            if (std::abs(slope) <= -good_slope * at_start) break;
            if (slope < 0) {
                low = step, low_slope = slope;
                if (high == 0 && step >= 1) break;  // farther only by another direction
            } else {
                high = step, high_slope = slope;
            }
            const double cut = low_slope / (low_slope - high_slope);
            step = low + (high - low) * std::clamp(cut, 0.1, 0.9);
        }
        motion_ = place;
        gradient = there;
        return true;
    }
    /// The motion to begin with after a change of mass: that of before, or with the same accelerations.
    void begin_with_mass(VectorXd& gradient)
    {
        gradient_at(motion_, gradient);
        const VectorXd faster = motion_ / lowering;
        VectorXd there;
        gradient_at(faster, there);
        if (error_of(there) >= error_of(gradient)) return;
        motion_ = faster;
        gradient = there;
    }
    /// Newton's method until the error is little; false where it does not end.
    bool iterate(int most, VectorXd& gradient, Balance& balance)
    {
        VectorXd direction;
        for (int i = 0; i < most; ++i) {
            const double fastest = mass_ * motion_.lpNorm<Eigen::Infinity>();
            const double error = error_of(gradient);
            if (error <= std::max(little * fastest, 0.1 * moving)) return true;
            ++balance.iterations;
            assemble();
            if (!solver_->solve(matrix_, -gradient, direction).solved || !go_along(direction, gradient))
                return false;
        }
        return false;
    }
    /// The energy is convex, and its curvature at least the mass: what is left of the gradient bounds the error of
    /// the accelerations.
    double error_of(const VectorXd& gradient) const
    {
        return gradient.cwiseQuotient(weights_).lpNorm<Eigen::Infinity>();
    }
    void judge(const VectorXd& gradient, Balance& balance) const
    {
        const double fastest = mass_ * motion_.lpNorm<Eigen::Infinity>(), error = error_of(gradient);
        balance.acceleration = fastest;
        if (fastest + error <= moving) {
            balance.standing = Standing::balanced;
        } else if (fastest > moving && error <= little * fastest) {
            balance.standing = Standing::mechanism;
            for (const int row : row_of_) balance.velocities.push_back(velocity(row));
            balance.dissipation = dissipation();
        }
    }
    BlockVelocity velocity(int row) const
    {
        BlockVelocity moves;
        if (row < 0) return moves;
        const auto own = motion_.segment(row * unknowns_, unknowns_);
        if (problem_.planar) {
            moves.centroid = {own[0] * length_, 0, own[1] * length_};
            moves.spin = {0, own[2], 0};
        } else {
            moves.centroid = own.head<3>() * length_;
            moves.spin = own.tail<3>();
        }
        return moves;
    }

    const LimitProblem& problem_;
    int unknowns_, rows_ = 0;
    double force_ = 0, length_ = 0, mass_ = 0;
    std::vector<int> row_of_;  // (blocks) -1: held
    std::vector<Spring> springs_;
    VectorXd weights_, load_, motion_;  // (rows x unknowns)
    solve::BlockMatrix matrix_;
    std::unique_ptr<solve::LinearSolver> solver_;
};

}  // namespace

Balance balance_of(const LimitProblem& problem)
{
    return SpringsOnBlocks(problem).settle();
}

Standing standing_without_dilatancy(const LimitProblem& problem)
{
    if (std::any_of(problem.contacts.begin(), problem.contacts.end(),
                    [](const LimitContact& contact) { return contact.cohesion > 0 || contact.tension > 0; }))
        return Standing::unknown;
    SpringsOnBlocks springs(problem);
    Standing standing = springs.settle().standing;
    if (standing != Standing::balanced) return standing;
    std::vector<double> normal = springs.normal_forces();
    for (int i = 0; i < most_states; ++i) {
        springs.rub_as_under(normal);
        standing = springs.settle().standing;
        if (standing == Standing::unknown) return standing;
        if (standing == Standing::balanced && springs.most_beyond_friction() <= beyond_friction) return standing;
        const std::vector<double> next = springs.normal_forces();
        for (std::size_t k = 0; k < normal.size(); ++k) normal[k] = (normal[k] + next[k]) / 2;
    }
    return Standing::mechanism;
}

}  // namespace voussoir::limit
