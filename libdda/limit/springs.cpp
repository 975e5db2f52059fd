#include "libdda/limit/springs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace voussoir::limit
{

namespace
{

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double no_bound = 1e6;  // times the whole load: what is infinitely strong
constexpr double least = 1e-6;    // of the whole load over all blocks, and of the scene's size: of weights
constexpr double slack = 1e-7;    // of the whole load: normal forces must not be at the edge of their own friction

Matrix3d cross_matrix(const Vector3d& v)
{
    Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

bool is_fully_held(const LimitBlock& block, bool planar)
{
    return block.turning_held && block.held[0] && block.held[2] && (planar || block.held[1]);
}

Eigen::Map<MatrixXd> block_of(solve::BlockMatrix& matrix, int position)
{
    return {matrix.block(position), matrix.block_size, matrix.block_size};
}

}  // namespace

Springs::Springs(const LimitProblem& problem) : planar_(problem.planar), unknowns_(problem.planar ? 3 : 6)
{
    scale(problem);
    number_rows(problem);
    add_springs(problem);
    weigh(problem);
    find_pattern();
}

void Springs::scale(const LimitProblem& problem)
{
    for (const LimitBlock& block : problem.blocks) force_ += block.dead.norm();
    Vector3d middle = Vector3d::Zero();
    for (const LimitBlock& block : problem.blocks)
        middle += block.centroid / static_cast<double>(problem.blocks.size());
    for (const LimitBlock& block : problem.blocks) length_ = std::max(length_, (block.centroid - middle).norm());
    if (force_ == 0) force_ = 1;
    if (length_ == 0) length_ = 1;
}

void Springs::number_rows(const LimitProblem& problem)
{
    for (const LimitBlock& block : problem.blocks) row_of_.push_back(is_fully_held(block, planar_) ? -1 : rows_++);
}

void Springs::add_springs(const LimitProblem& problem)
{
    const auto bounded = [&](double force) { return std::min(force / force_, no_bound); };
    for (const LimitContact& contact : problem.contacts) {
        const double apex = contact.friction > 0 ? contact.cohesion / contact.friction : contact.tension;
        Spring spring;
        spring.friction = contact.friction;
        spring.stiffness = contact.stiffness;
        spring.set = FrictionSet{contact.normal, contact.friction, bounded(contact.cohesion),
                                 bounded(std::min(contact.tension, apex))};
        add(problem, contact.block_a, contact.position, contact.block_b, contact.position, std::move(spring));
    }
    for (const LimitBar& bar : problem.bars) {
        Spring spring;
        spring.set = BarSet{bar.axis, bounded(bar.tension), bounded(bar.compression), bounded(bar.shear)};
        add(problem, bar.block_a, bar.end_a, bar.block_b, bar.end_b, std::move(spring));
    }
}

void Springs::add(const LimitProblem& problem, int a, const Vector3d& end_a, int b, const Vector3d& end_b,
                  Spring spring)
{
    const auto in_a = static_cast<std::size_t>(a), in_b = static_cast<std::size_t>(b);
    spring.row_a = row_of_[in_a];
    spring.row_b = row_of_[in_b];
    if (spring.row_a < 0 && spring.row_b < 0) return;
    spring.on_a = jacobian(problem.blocks[in_a], end_a);
    spring.on_b = -jacobian(problem.blocks[in_b], end_b);
    springs_.push_back(std::move(spring));
}

// Turning times the length; held components move nothing.
Springs::Jacobian Springs::jacobian(const LimitBlock& block, const Vector3d& point) const
{
    Eigen::Matrix<double, 3, 6> whole;
    whole << Matrix3d::Identity(), -cross_matrix((point - block.centroid) / length_);
    for (int axis = 0; axis < 3; ++axis)
        if (block.held[static_cast<std::size_t>(axis)]) whole.col(axis).setZero();
    if (block.turning_held) whole.rightCols<3>().setZero();
    if (!planar_) return whole;
    Jacobian in_plane(3, 3);
    in_plane << whole.col(0), whole.col(2), whole.col(4);
    return in_plane;
}

void Springs::weigh(const LimitProblem& problem)
{
    const int turning = planar_ ? 1 : 3;
    std::vector<double> squared(static_cast<std::size_t>(rows_), 0), count(squared);
    for (const Spring& spring : springs_)
        for (const auto& [row, jacobian] :
             {std::pair(spring.row_a, &spring.on_a), std::pair(spring.row_b, &spring.on_b)}) {
            if (row < 0) continue;
            squared[static_cast<std::size_t>(row)] += jacobian->rightCols(turning).squaredNorm() / turning;
            ++count[static_cast<std::size_t>(row)];
        }
    weights_ = load_ = VectorXd::Zero(rows_ * unknowns_);
    for (std::size_t b = 0; b < problem.blocks.size(); ++b) {
        if (row_of_[b] < 0) continue;
        const LimitBlock& block = problem.blocks[b];
        const auto row = static_cast<std::size_t>(row_of_[b]);
        const double share = std::max(block.dead.norm() / force_, least / rows_);
        const double lever = std::max(count[row] > 0 ? squared[row] / count[row] : 0, least);
        auto weights = weights_.segment(row_of_[b] * unknowns_, unknowns_);
        weights.setConstant(share);
        weights.tail(turning) *= lever;
        int unknown = row_of_[b] * unknowns_;
        for (int axis = 0; axis < 3; ++axis) {
            if (planar_ && axis == 1) continue;
            if (!block.held[static_cast<std::size_t>(axis)]) load_[unknown] = block.dead[axis] / force_;
            ++unknown;
        }
    }
}

void Springs::find_pattern()
{
    const auto ordered = [](const Spring& spring) {
        return std::pair(std::max(spring.row_a, spring.row_b), std::min(spring.row_a, spring.row_b));
    };
    std::vector<std::pair<int, int>> pairs;
    for (const Spring& spring : springs_)
        if (ordered(spring).second >= 0) pairs.push_back(ordered(spring));
    solve::set_pattern(pattern_, unknowns_, rows_, pairs);
    for (Spring& spring : springs_) {
        if (spring.row_a >= 0) spring.diagonal_a = pattern_.diagonal(spring.row_a);
        if (spring.row_b >= 0) spring.diagonal_b = pattern_.diagonal(spring.row_b);
        const auto [row, column] = ordered(spring);
        if (column >= 0) spring.beside = pattern_.position(row, column);
    }
}

Vector3d Springs::apart(const Spring& spring, const VectorXd& motion) const
{
    Vector3d apart = Vector3d::Zero();
    if (spring.row_a >= 0) apart += spring.on_a * motion.segment(spring.row_a * unknowns_, unknowns_);
    if (spring.row_b >= 0) apart += spring.on_b * motion.segment(spring.row_b * unknowns_, unknowns_);
    return apart;
}

NearestForce Springs::force_of(const Spring& spring, const VectorXd& motion) const
{
    const Vector3d given = -spring.stiffness * apart(spring, motion);
    NearestForce nearest = std::visit([&](const auto& set) { return nearest_force(set, given); }, spring.set);
    nearest.derivative *= spring.stiffness;
    return nearest;
}

void Springs::gradient(double mass, const VectorXd& motion, VectorXd& gradient) const
{
    gradient = mass * weights_.cwiseProduct(motion) - load_;
    for (const Spring& spring : springs_) {
        const Vector3d force = force_of(spring, motion).force;
        if (spring.row_a >= 0)
            gradient.segment(spring.row_a * unknowns_, unknowns_) -= spring.on_a.transpose() * force;
        if (spring.row_b >= 0)
            gradient.segment(spring.row_b * unknowns_, unknowns_) -= spring.on_b.transpose() * force;
    }
}

void Springs::stiffness(double mass, const VectorXd& motion, solve::BlockMatrix& matrix) const
{
    if (matrix.columns.empty()) matrix = pattern_;
    std::fill(matrix.values.begin(), matrix.values.end(), 0);
    for (int row = 0; row < rows_; ++row)
        block_of(matrix, matrix.diagonal(row)).diagonal() = mass * weights_.segment(row * unknowns_, unknowns_);
    for (const Spring& spring : springs_) {
        const Matrix3d derivative = force_of(spring, motion).derivative;
        if (derivative.isZero(0)) continue;
        const Jacobian a = derivative * spring.on_a, b = derivative * spring.on_b;
        if (spring.row_a >= 0) block_of(matrix, spring.diagonal_a) += spring.on_a.transpose() * a;
        if (spring.row_b >= 0) block_of(matrix, spring.diagonal_b) += spring.on_b.transpose() * b;
        if (spring.beside < 0) continue;
        if (spring.row_a > spring.row_b)
            block_of(matrix, spring.beside) += spring.on_a.transpose() * b;
        else
            block_of(matrix, spring.beside) += spring.on_b.transpose() * a;
    }
}

std::vector<double> Springs::normal_forces(const VectorXd& motion) const
{
    std::vector<double> forces;
    for (const Spring& spring : springs_)
        if (const auto* set = std::get_if<FrictionSet>(&spring.set))
            forces.push_back(force_of(spring, motion).force.dot(set->normal));
    return forces;
}

void Springs::rub_as_under(const std::vector<double>& normal_forces)
{
    auto normal = normal_forces.begin();
    for (Spring& spring : springs_)
        if (auto* set = std::get_if<FrictionSet>(&spring.set))
            *set = {set->normal, 0, spring.friction * std::max(0.0, *normal++) + slack, 0};
}

double Springs::most_beyond_friction(const VectorXd& motion) const
{
    double most = 0;
    for (const Spring& spring : springs_)
        if (const auto* set = std::get_if<FrictionSet>(&spring.set)) {
            const Vector3d force = force_of(spring, motion).force;
            const double normal = force.dot(set->normal);
            most = std::max(most, (force - normal * set->normal).norm() - spring.friction * normal);
        }
    return most;
}

std::vector<BlockVelocity> Springs::velocities(const VectorXd& moved) const
{
    std::vector<BlockVelocity> velocities(row_of_.size());
    for (std::size_t b = 0; b < row_of_.size(); ++b) {
        if (row_of_[b] < 0) continue;
        const auto own = moved.segment(row_of_[b] * unknowns_, unknowns_);
        if (planar_)
            velocities[b] = {{own[0] * length_, 0, own[1] * length_}, {0, own[2], 0}};
        else
            velocities[b] = {own.head<3>() * length_, own.tail<3>()};
    }
    return velocities;
}

double Springs::power(const VectorXd& motion, const VectorXd& velocities) const
{
    double power = 0;
    for (const Spring& spring : springs_) power -= force_of(spring, motion).force.dot(apart(spring, velocities));
    return power * force_ * length_;
}

}  // namespace voussoir::limit
