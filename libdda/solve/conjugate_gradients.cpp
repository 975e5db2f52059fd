#include "libdda/solve/conjugate_gradients.h"

#include <Eigen/Core>

#include "libdda/solve/block_kernels.h"
#include "libdda/solve/coarse_space.h"

namespace voussoir::solve
{

using Eigen::VectorXd;

namespace
{

/// What `work` gives for the kernels of a block size, one of the four kinematics'.
template <class Work>
auto with_kernels(int block_size, const Work& work)
{
    if (block_size == 12) return work(Kernels<12>());
    if (block_size == 6) return work(Kernels<6>());
    return work(Kernels<3>());
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

    LinearReport solve(const BlockMatrix& matrix, const VectorXd& right_hand_side, VectorXd& solution) override
    {
        return with_kernels(matrix.block_size, [&](auto kernels) {
            return iterate<decltype(kernels)>(matrix, right_hand_side, solution);
        });
    }

    bool prepare(const BlockMatrix& matrix) override
    {
        with_kernels(matrix.block_size, [&](auto kernels) { factorise<decltype(kernels)>(matrix); });
        return true;
    }

    void precondition(const VectorXd& r, VectorXd& z) override
    {
        with_kernels(factor_.block_size, [&](auto kernels) { improve<decltype(kernels)>(r, z); });
    }

 private:
    template <class K>
    void factorise(const BlockMatrix& a)
    {
        if (factor_.columns != a.columns || factor_.row_start != a.row_start) factor_ = a;
        factor_.block_size = a.block_size;
        K::factorise(a, factor_);
        is_coarse_ = coarse_.prepare(a);
    }

    /// z = K^-1 r, nearly. The coarse correction comes last: it leaves no residual in the coarse space, as the
    /// iteration, which starts without one, expects of an operator that is not symmetric.
    template <class K>
    void improve(const VectorXd& r, VectorXd& z)
    {
        K::precondition(factor_, r, z);
        if (is_coarse_) coarse_.correct(r, z);
    }

    template <class K>
    LinearReport iterate(const BlockMatrix& a, const VectorXd& b, VectorXd& x)
    {
        factorise<K>(a);
        LinearReport report{false, 1, 0, static_cast<std::int64_t>(factor_.values.size())};

        product_.resize(b.size());
        residual_ = b;
        if (is_coarse_) {
            coarse_.start(b, x);
            K::multiply(a, x, product_);
            residual_ -= product_;
        } else {
            x.setZero(b.size());
        }
        improve<K>(residual_, z_);
        direction_ = z_;
        double rz = residual_.dot(z_);
        const double target = tolerance_ * b.norm();
        while (report.iterations < max_iterations_) {
            if (residual_.norm() <= target) break;
            ++report.iterations;
            K::multiply(a, direction_, product_);
            const double curvature = direction_.dot(product_);
            if (!(curvature > 0) || !(rz > 0)) return report;  // not positive definite, or not a number
            const double step = rz / curvature;
            x += step * direction_;
            residual_ -= step * product_;
            improve<K>(residual_, z_);
            const double next = residual_.dot(z_);
            direction_ = z_ + next / rz * direction_;
            rz = next;
        }
        report.solved = residual_.norm() <= target;
        return report;
    }

    double tolerance_;
    int max_iterations_;
    BlockMatrix factor_;
    CoarseSpace coarse_;
    bool is_coarse_ = false;
    VectorXd residual_, z_, direction_, product_;
};

}  // namespace

void multiply(const BlockMatrix& matrix, const VectorXd& x, VectorXd& y)
{
    y.resize(x.size());
    with_kernels(matrix.block_size, [&](auto kernels) { kernels.multiply(matrix, x, y); });
}

std::unique_ptr<LinearSolver> make_conjugate_gradient_solver(double tolerance, int max_iterations)
{
    return std::make_unique<ConjugateGradientSolver>(tolerance, max_iterations);
}

}  // namespace voussoir::solve
