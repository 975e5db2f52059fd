#include "libdda/solve/conjugate_gradients.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "libdda/solve/block_kernels.h"
#include "libdda/solve/coarse_space.h"
#include "libdda/solve/incomplete_factor.h"
#include "libdda/solve/pieces.h"

namespace voussoir::solve
{

using Eigen::VectorXd;

namespace
{

template <int N>
using BlockSize = std::integral_constant<int, N>;

/// What `work` gives for a block size, one of the four kinematics'.
template <class Work>
auto with_block_size(int block_size, const Work& work)
{
    if (block_size == 12) return work(BlockSize<12>());
    if (block_size == 6) return work(BlockSize<6>());
    return work(BlockSize<3>());
}

class ConjugateGradientSolver : public LinearSolver
{
 public:
    ConjugateGradientSolver(double tolerance, int max_iterations)
        : tolerance_(tolerance), max_iterations_(max_iterations)
    {
    }

    void place(const RowPlaces& places) override { coarse_.place(places); }
    void set_tolerance(double tolerance) override { tolerance_ = tolerance; }
    void use_threads(int threads) override { threads_ = threads; }

    LinearReport solve(const BlockMatrix& matrix, const VectorXd& right_hand_side, VectorXd& solution) override
    {
        return with_block_size(matrix.block_size,
                               [&](auto size) { return iterate<size>(matrix, right_hand_side, solution); });
    }

    bool prepare(const BlockMatrix& matrix) override
    {
        with_block_size(matrix.block_size, [&](auto size) { factorise<size>(matrix); });
        return true;
    }

    void multiply(const BlockMatrix& matrix, const VectorXd& x, VectorXd& y) override
    {
        y.resize(x.size());
        with_block_size(matrix.block_size, [&](auto size) { product<size>(matrix, x, y); });
    }

    void precondition(const VectorXd& r, VectorXd& z) override
    {
        with_block_size(factor_.block_size(), [&](auto size) { improve<size>(r, z); });
    }

 private:
    template <int N>
    void factorise(const BlockMatrix& a)
    {
        at_work_ = a.rows() < blocks_worth_threads ? 1 : threads_;
        factor_.prepare<N>(a);
        is_coarse_ = coarse_.prepare(a, factor_.columns(), at_work_);
        factor_.factorise<N>(a, at_work_, [&] {
            if (is_coarse_) coarse_.factorise();
        });
    }

    /// z = K^-1 r, nearly. The coarse correction comes last: it leaves no residual in the coarse space, as the
    /// iteration, which starts without one, expects of an operator that is not symmetric.
    template <int N>
    void improve(const VectorXd& r, VectorXd& z)
    {
        factor_.apply<N>(r, at_work_, z);
        if (is_coarse_) coarse_.correct(r, at_work_, z);
    }

    /// y = A x
    template <int N>
    void product(const BlockMatrix& a, const VectorXd& x, VectorXd& y)
    {
        if (at_work_ <= 1) {
            Kernels<N>::multiply(a, x, y);
            return;
        }
        Pieces(a.rows(), N, at_work_).each([&](Eigen::Index from, Eigen::Index count) {
            Kernels<N>::multiply_rows(a, factor_.columns(), static_cast<int>(from / N),
                                      static_cast<int>((from + count) / N), x, y);
        });
    }

    template <int N>
    LinearReport iterate(const BlockMatrix& a, const VectorXd& b, VectorXd& x)
    {
        factorise<N>(a);
        LinearReport report{false, 1, 0, factor_.entries()};
        Pieces pieces(a.rows(), N, at_work_);

        product_.resize(b.size());
        residual_ = b;
        if (is_coarse_) {
            coarse_.start(b, at_work_, x);
            product<N>(a, x, product_);
            residual_ -= product_;
        } else {
            x.setZero(b.size());
        }
        double square = pieces.dot(residual_, residual_), rz = 0;
        const double target = tolerance_ * b.norm();
        while (std::sqrt(square) > target && report.iterations < max_iterations_) {
            improve<N>(residual_, z_);
            const double next = pieces.dot(residual_, z_);
            if (report.iterations == 0)
                direction_ = z_;
            else
                pieces.each([&](Eigen::Index from, Eigen::Index count) {
                    direction_.segment(from, count) =
                        z_.segment(from, count) + next / rz * direction_.segment(from, count);
                });
            rz = next;
            ++report.iterations;
            product<N>(a, direction_, product_);
            const double curvature = pieces.dot(direction_, product_);
            if (!(curvature > 0) || !(rz > 0)) return report;  // not positive definite, or not a number
            const double step = rz / curvature;
            square = pieces.sum([&](Eigen::Index from, Eigen::Index count) {
                x.segment(from, count) += step * direction_.segment(from, count);
                residual_.segment(from, count) -= step * product_.segment(from, count);
                return residual_.segment(from, count).squaredNorm();
            });
        }
        report.solved = std::sqrt(square) <= target;
        return report;
    }

    double tolerance_;
    int max_iterations_;
    int threads_ = 1, at_work_ = 1;  // allowed, and in use for the matrix last seen
    IncompleteFactor factor_;
    CoarseSpace coarse_;
    bool is_coarse_ = false;
    VectorXd residual_, z_, direction_, product_;
};

}  // namespace

void multiply(const BlockMatrix& matrix, const VectorXd& x, VectorXd& y)
{
    y.resize(x.size());
    with_block_size(matrix.block_size, [&](auto size) { Kernels<size>::multiply(matrix, x, y); });
}

std::unique_ptr<LinearSolver> make_conjugate_gradient_solver(double tolerance, int max_iterations)
{
    return std::make_unique<ConjugateGradientSolver>(tolerance, max_iterations);
}

}  // namespace voussoir::solve
