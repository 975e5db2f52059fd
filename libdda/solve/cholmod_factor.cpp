#include "libdda/solve/cholmod_factor.h"

#include <cholmod.h>

#include <new>
#include <vector>

namespace voussoir::solve
{

/// Lower triangle by columns, scalar by scalar, as CHOLMOD wants it (stype -1).
struct CholmodFactor::Implementation {
    Implementation()
    {
        cholmod_start(&common);
        common.print = 0;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        common.postorder = 1;
        // Without threads or an optimised BLAS in the way: the same bits on every run.
        common.supernodal = CHOLMOD_SIMPLICIAL;
        common.final_ll = 1;
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;
    ~Implementation()
    {
        cholmod_free_factor(&factor, &common);
        cholmod_free_sparse(&matrix, &common);
        cholmod_finish(&common);
    }

    bool is_pattern_of(const BlockMatrix& m) const
    {
        return m.block_size == block_size && m.columns == columns && m.row_start == row_start;
    }

    void analyse(const BlockMatrix& m)
    {
        block_size = m.block_size;
        columns = m.columns;
        row_start = m.row_start;
        cholmod_free_factor(&factor, &common);
        cholmod_free_sparse(&matrix, &common);
        const int n = m.block_size, size = n * m.rows();
        std::vector<int> count(size, 0);
        visit(m, [&](int, int column, int, int) { ++count[column]; });
        std::size_t total = 0;
        for (const int c : count) total += c;
        matrix = cholmod_allocate_sparse(size, size, total, 1, 1, -1, CHOLMOD_REAL, &common);
        refuse_without_memory(matrix);
        int* start = static_cast<int*>(matrix->p);
        int* row = static_cast<int*>(matrix->i);
        start[0] = 0;
        for (int c = 0; c < size; ++c) start[c + 1] = start[c] + count[c];
        std::vector<int> next(start, start + size);
        target.clear();
        source.clear();
        visit(m, [&](int r, int column, int position, int entry) {
            row[next[column]] = r;
            target.push_back(next[column]++);
            source.push_back(position * n * n + entry);
        });
        factor = cholmod_analyze(matrix, &common);
        refuse_without_memory(factor);
        cost = {common.fl, common.lnz};
    }

    /// Without memory is not without solution: it must not end in a cut step. @param made what was asked for
    void refuse_without_memory(const void* made)
    {
        if (made && common.status != CHOLMOD_OUT_OF_MEMORY) return;
        columns.clear();  // nothing analysed is kept
        row_start.clear();
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
        double* values = static_cast<double*>(matrix->x);
        for (std::size_t k = 0; k < target.size(); ++k) values[target[k]] = m.values[source[k]];
    }

    cholmod_common common{};
    cholmod_sparse* matrix = nullptr;
    cholmod_factor* factor = nullptr;
    FactorCost cost;
    int block_size = 0;
    std::vector<int> columns, row_start, target, source;
};

CholmodFactor::CholmodFactor() : implementation_(std::make_unique<Implementation>()) {}
CholmodFactor::~CholmodFactor() = default;
CholmodFactor::CholmodFactor(CholmodFactor&&) noexcept = default;
CholmodFactor& CholmodFactor::operator=(CholmodFactor&&) noexcept = default;

FactorCost CholmodFactor::analyse(const BlockMatrix& matrix)
{
    if (!implementation_->is_pattern_of(matrix)) implementation_->analyse(matrix);
    return implementation_->cost;
}

bool CholmodFactor::factorise(const BlockMatrix& matrix)
{
    Implementation& the = *implementation_;
    analyse(matrix);
    the.scatter(matrix);
    cholmod_factorize(the.matrix, the.factor, &the.common);
    the.refuse_without_memory(the.factor);
    return the.common.status == CHOLMOD_OK && the.factor->minor >= the.factor->n;
}

std::int64_t CholmodFactor::entries() const
{
    return static_cast<std::int64_t>(implementation_->factor->nzmax);
}

bool CholmodFactor::solve(const Eigen::MatrixXd& right_hand_sides, Eigen::MatrixXd& solutions)
{
    Implementation& the = *implementation_;
    cholmod_dense b{};
    b.nrow = b.d = right_hand_sides.rows();
    b.ncol = right_hand_sides.cols();
    b.nzmax = b.nrow * b.ncol;
    b.x = const_cast<double*>(right_hand_sides.data());
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, the.factor, &b, &the.common);
    the.refuse_without_memory(the.factor);
    if (!x) return false;
    solutions = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(x->x), right_hand_sides.rows(),
                                                  right_hand_sides.cols());
    cholmod_free_dense(&x, &the.common);
    return solutions.allFinite();
}

}  // namespace voussoir::solve
