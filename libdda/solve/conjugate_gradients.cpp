#include "libdda/solve/conjugate_gradients.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "libdda/solve/block_kernels.h"
#include "libdda/solve/coarse_space.h"
#include "libdda/solve/incomplete_factor.h"

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

constexpr int rows_in_piece = 256;

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
        factor_.factorise<N>(a, at_work_);
        is_coarse_ = coarse_.prepare(a, factor_.columns(), at_work_);
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
        each_piece(a.rows(), [&](int, int first, int end) {
            Kernels<N>::multiply_rows(a, factor_.columns(), first, end, x, y);
        });
    }

    /// Calls work(piece, first row, row after the last); the rows alone decide what the pieces are.
    template <class Work>
    void each_piece(int rows, const Work& work)
    {
        const int size = rows < blocks_worth_threads ? std::max(rows, 1) : rows_in_piece;
        each_in_parallel(static_cast<std::size_t>((rows + size - 1) / size), at_work_, [&](std::size_t piece) {
            const int first = static_cast<int>(piece) * size;
            work(static_cast<int>(piece), first, std::min(first + size, rows));
        });
    }

    /// The sum of what `part` gives for the unknowns (from, count) of every piece, added up in their order.
    template <int N, class Part>
    double sum(int rows, const Part& part)
    {
        sums_.assign(rows / rows_in_piece + 1, 0.0);
        each_piece(rows,
                   [&](int piece, int first, int end) { sums_[piece] = part(N * first, N * (end - first)); });
        double total = 0;
        for (const double of_piece : sums_) total += of_piece;
        return total;
    }

    template <int N>
    LinearReport iterate(const BlockMatrix& a, const VectorXd& b, VectorXd& x)
    {
        factorise<N>(a);
        LinearReport report{false, 1, 0, factor_.entries()};
        const int rows = a.rows();

        product_.resize(b.size());
        residual_ = b;
        if (is_coarse_) {
            coarse_.start(b, at_work_, x);
            product<N>(a, x, product_);
            residual_ -= product_;
        } else {
            x.setZero(b.size());
        }
        improve<N>(residual_, z_);
        direction_ = z_;
        const auto dot = [&](const VectorXd& u, const VectorXd& v) {
            return sum<N>(rows,
                          [&](int from, int count) { return u.segment(from, count).dot(v.segment(from, count)); });
        };
        double rz = dot(residual_, z_);
        double square = dot(residual_, residual_);
        const double target = tolerance_ * b.norm();
        while (report.iterations < max_iterations_) {
            if (std::sqrt(square) <= target) break;
            ++report.iterations;
            product<N>(a, direction_, product_);
            const double curvature = dot(direction_, product_);
            if (!(curvature > 0) || !(rz > 0)) return report;  // not positive definite, or not a number
            const double step = rz / curvature;
            square = sum<N>(rows, [&](int from, int count) {
                x.segment(from, count) += step * direction_.segment(from, count);
                residual_.segment(from, count) -= step * product_.segment(from, count);
                return residual_.segment(from, count).squaredNorm();
            });
            improve<N>(residual_, z_);
            const double next = dot(residual_, z_);
            each_piece(rows, [&](int, int first, int end) {
                direction_.segment(N * first, N * (end - first)) =
                    z_.segment(N * first, N * (end - first)) +
                    next / rz * direction_.segment(N * first, N * (end - first));
            });
            rz = next;
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
    std::vector<double> sums_;  // scratch, of pieces
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
