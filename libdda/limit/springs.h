// Blocks on springs that never bear more than friction, strength and metal allow.
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "libdda/limit/friction_set.h"
#include "libdda/limit/limit_problem.h"
#include "libdda/solve/block_matrix.h"

namespace voussoir::limit
{

/// How a block begins to move.
struct BlockVelocity {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();
};

/// The springs of a problem, of stiffness one but for faces with all their points, and the loads on its blocks.
/// Forces are over the whole load, lengths over the size of the scene; a motion has a row for each block that is
/// not wholly held: along its axes, and its turns.
class Springs
{
 public:
    /// @param problem may go; planar ones have 3 unknowns a row, others 6
    explicit Springs(const LimitProblem& problem);

    Eigen::VectorXd no_motion() const { return Eigen::VectorXd::Zero(load_.size()); }
    /// (rows x unknowns) what blocks carry; against turning as if it lay where they are touched
    const Eigen::VectorXd& weights() const { return weights_; }
    /// mass x weights x motion less the loads and what springs bear; the gradient of a convex energy.
    void gradient(double mass, const Eigen::VectorXd& motion, Eigen::VectorXd& gradient) const;
    /// Its derivative.
    void stiffness(double mass, const Eigen::VectorXd& motion, solve::BlockMatrix& matrix) const;

    /// (contacts that do not lie between held blocks) over the whole load
    std::vector<double> normal_forces(const Eigen::VectorXd& motion) const;
    /// From now on friction is a cohesion, by these normal forces.
    void rub_as_under(const std::vector<double>& normal_forces);
    /// Most that the shear of a contact exceeds its friction, over the whole load.
    double most_beyond_friction(const Eigen::VectorXd& motion) const;

    /// Of all blocks.
    std::vector<BlockVelocity> velocities(const Eigen::VectorXd& moved) const;
    /// What the forces of springs in a motion take of these velocities [W].
    double power(const Eigen::VectorXd& motion, const Eigen::VectorXd& velocities) const;

 private:
    using Jacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 6>;
    struct Spring {
        int row_a = -1, row_b = -1;                         // -1: held
        Jacobian on_a, on_b;                                // motion of its ends by those of the blocks
        int diagonal_a = -1, diagonal_b = -1, beside = -1;  // positions in the matrix
        std::variant<FrictionSet, BarSet> set;
        double friction = 0;   // -, of a contact
        double stiffness = 1;  // -
    };
    void scale(const LimitProblem& problem);
    void number_rows(const LimitProblem& problem);
    void add_springs(const LimitProblem& problem);
    void add(const LimitProblem& problem, int a, const Eigen::Vector3d& end_a, int b, const Eigen::Vector3d& end_b,
             Spring spring);
    Jacobian jacobian(const LimitBlock& block, const Eigen::Vector3d& point) const;
    void weigh(const LimitProblem& problem);
    void find_pattern();
    Eigen::Vector3d apart(const Spring& spring, const Eigen::VectorXd& motion) const;
    NearestForce force_of(const Spring& spring, const Eigen::VectorXd& motion) const;

    bool planar_;
    int unknowns_, rows_ = 0;
    double force_ = 0, length_ = 0;  // N, m
    std::vector<int> row_of_;        // (blocks) -1: held
    std::vector<Spring> springs_;
    Eigen::VectorXd weights_, load_;  // (rows x unknowns)
    solve::BlockMatrix pattern_;
};

}  // namespace voussoir::limit
