#include "libdda/solve/cholmod_solver.h"

#include <cholmod.h>

#include <Eigen/Core>
#include <new>
#include <vector>

namespace voussoir::solve
{

namespace
{

/// Lower triangle by columns, scalar by scalar, as CHOLMOD wants it (stype -1).
class CholmodSolver : public LinearSolver
{
 public:
    CholmodSolver()
    {
        cholmod_start(&common_);
        common_.print = 0;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_AMD;
        common_.postorder = 1;
        // Without threads or an optimised BLAS in the way: the same bits on every run.
        common_.supernodal = CHOLMOD_SIMPLICIAL;
        common_.final_ll = 1;
    }
    CholmodSolver(const CholmodSolver&) = delete;
    CholmodSolver& operator=(const CholmodSolver&) = delete;
    ~CholmodSolver() override
    {
        cholmod_free_factor(&factor_, &common_);
        cholmod_free_sparse(&matrix_, &common_);
        cholmod_finish(&common_);
    }

    LinearReport solve(const BlockMatrix& matrix, const Eigen::VectorXd& right_hand_side,
                       Eigen::VectorXd& solution) override
    {
        if (matrix.block_size != block_size_ || matrix.columns != columns_ || matrix.row_start != row_start_)
            analyse(matrix);
        scatter(matrix);
        LinearReport report;
        report.factorisations = 1;
        cholmod_factorize(matrix_, factor_, &common_);
        refuse_without_memory(factor_);
        if (common_.status != CHOLMOD_OK || factor_->minor < factor_->n) return report;
        report.factor_entries = static_cast<std::int64_t>(factor_->nzmax);

        cholmod_dense b{};
        b.nrow = b.nzmax = b.d = right_hand_side.size();
        b.ncol = 1;
        b.x = const_cast<double*>(right_hand_side.data());
        b.xtype = CHOLMOD_REAL;
        b.dtype = CHOLMOD_DOUBLE;
        cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor_, &b, &common_);
        refuse_without_memory(factor_);
        if (!x) return report;
        solution = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(x->x), right_hand_side.size());
        cholmod_free_dense(&x, &common_);
        report.solved = solution.allFinite();
        return report;
    }

 private:
    void analyse(const BlockMatrix& m)
    {
        block_size_ = m.block_size;
        columns_ = m.columns;
        row_start_ = m.row_start;
        cholmod_free_factor(&factor_, &common_);
        cholmod_free_sparse(&matrix_, &common_);
        const int n = m.block_size, size = n * m.rows();
        std::vector<int> count(size, 0);
        visit(m, [&](int, int column, int, int) { ++count[column]; });
        std::size_t entries = 0;
        for (const int c : count) entries += c;
        matrix_ = cholmod_allocate_sparse(size, size, entries, 1, 1, -1, CHOLMOD_REAL, &common_);
        refuse_without_memory(matrix_);
        int* start = static_cast<int*>(matrix_->p);
        int* row = static_cast<int*>(matrix_->i);
        start[0] = 0;
        for (int c = 0; c < size; ++c) start[c + 1] = start[c] + count[c];
        std::vector<int> next(start, start + size);
        target_.clear();
        source_.clear();
        visit(m, [&](int r, int column, int position, int entry) {
            row[next[column]] = r;
            target_.push_back(next[column]++);
            source_.push_back(position * n * n + entry);
        });
        factor_ = cholmod_analyze(matrix_, &common_);
        refuse_without_memory(factor_);
    }

    /// Without memory is not without solution: it must not end in a cut step. @param made what was asked for
    void refuse_without_memory(const void* made)
    {
        if (made && common_.status != CHOLMOD_OUT_OF_MEMORY) return;
        columns_.clear();  // nothing analysed is kept
        row_start_.clear();
        throw std::bad_alloc();
    }

    /// Calls visitor(row, column, block position, entry in block) for every scalar of the lower triangle, rows
    /// ascending within each column.
    template <class Visitor>
    static void visit(const BlockMatrix& m, Visitor&& visitor)
    {
        const int n = m.block_size;
        for (int i = 0; i < m.rows(); ++i)
            for (int p = m.row_start[i]; p < m.row_start[i + 1]; ++p) {
                const int j = m.columns[p];
                for (int c = 0; c < n; ++c)
                    for (int r = (i == j ? c : 0); r < n; ++r) visitor(n * i + r, n * j + c, p, c * n + r);
            }
    }

    void scatter(const BlockMatrix& m)
    {
        double* values = static_cast<double*>(matrix_->x);
        for (std::size_t k = 0; k < target_.size(); ++k) values[target_[k]] = m.values[source_[k]];
    }

    cholmod_common common_{};
    cholmod_sparse* matrix_ = nullptr;
    cholmod_factor* factor_ = nullptr;
    int block_size_ = 0;
    std::vector<int> columns_, row_start_, target_, source_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_cholmod_solver()
{
    return std::make_unique<CholmodSolver>();
}

}  // namespace voussoir::solve
