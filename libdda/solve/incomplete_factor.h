// The incomplete factor of a large matrix in parts, which threads make and use side by side.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "libdda/model/parallel.h"
#include "libdda/solve/block_kernels.h"
#include "libdda/solve/block_matrix.h"
#include "libdda/solve/single_precision.h"

namespace voussoir::solve
{

/// Connected parts of a pattern; a single one of fewer rows than `blocks_worth_threads`. The pattern alone
/// decides, not the number of threads: results are the same on any.
struct Domains {
    std::vector<int> of_row;
    int count = 0;
};
/// @param least_rows of a domain, some; @param most domains, some
Domains divide_into_domains(const BlockMatrix& pattern, int least_rows, int most);

/// Incomplete Cholesky, block by block, on the pattern of the matrix: exact for a chain in one domain. First come
/// the rows inside the domains, then those that border on a domain of a lower number, domain by domain; border
/// rows of different domains are left uncoupled, the only blocks that are dropped. So each domain's inside, and
/// then each domain's border, is worked on by itself. A factor in several domains is made in double precision and
/// used in single. Source: docs/numerics.md 3.
class IncompleteFactor
{
 public:
    /// Gets ready for the pattern of a matrix: columns() are known.
    template <int N>
    void prepare(const BlockMatrix& a)
    {
        if (a.block_size != l_.block_size || a.columns != columns_ || a.row_start != row_start_) analyse(a);
        l_.values.resize(l_.columns.size() * N * N);
    }

    template <int N>
    void factorise(const BlockMatrix& a, int threads)
    {
        prepare<N>(a);
        factorise<N>(a, threads, [] {});
    }

    /// @param a prepared for
    /// @param beside other work, which one thread does while others are at this
    template <int N, class Beside>
    void factorise(const BlockMatrix& a, int threads, const Beside& beside)
    {
        const auto factorise_rows = [&](int first, int end) {
            for (int i = first; i < end; ++i) {
                for (int p = l_.row_start[i]; p < l_.row_start[i + 1]; ++p) {
                    const auto taken = Kernels<N>::block(a, taken_[p].position);
                    typename Kernels<N>::Block own(l_.block(p));
                    if (taken_[p].turned)
                        own = taken.transpose();
                    else
                        own = taken;
                }
                Kernels<N>::factorise_row(Kernels<N>::block(a, taken_[l_.diagonal(i)].position), i, l_);
            }
        };
        each_in_parallel(count_ + 1, threads, [&](std::size_t i) {
            if (i == 0)
                beside();
            else
                factorise_rows(inside_[i - 1], inside_[i]);
        });
        each_in_parallel(count_, threads, [&](std::size_t d) { factorise_rows(border_[d], border_[d + 1]); });
        if (count_ > 1) round<N>(threads);
    }

    /// z = (L L^T)^-1 r
    template <int N>
    void apply(const Eigen::VectorXd& r, int threads, Eigen::VectorXd& z)
    {
        z.resize(r.size());
        if (count_ == 1) {
            Kernels<N>::precondition(l_, r, z);
            return;
        }
        ordered_.resize(r.size());
        each_in_parallel(count_, threads, [&](std::size_t d) { forward<N>(inside_[d], inside_[d + 1], r); });
        each_in_parallel(count_, threads, [&](std::size_t d) {
            forward<N>(border_[d], border_[d + 1], r);
            backward<N>(border_[d], border_[d + 1], z);
        });
        each_in_parallel(count_, threads, [&](std::size_t d) { backward<N>(inside_[d], inside_[d + 1], z); });
    }

    std::int64_t entries() const { return static_cast<std::int64_t>(l_.values.size()); }
    /// Of the matrix that was factorised.
    int block_size() const { return l_.block_size; }
    const ColumnsOf& columns() const { return of_matrix_; }

 private:
    /// Where a block of the factor comes from.
    struct Taken {
        int position = 0;  // in the matrix
        bool turned = false;
    };

    /// The factor in single precision, by rows for the way there, by columns for the way back.
    template <int N>
    void round(int threads)
    {
        using Single = SinglePrecision<N>;
        Single::resize(l_.columns.size(), by_rows_);
        Single::resize(l_.columns.size(), by_columns_);
        in_parallel(order_.size(), threads, [&](std::size_t first, std::size_t end) {
            for (int i = static_cast<int>(first); i < static_cast<int>(end); ++i) {
                for (int p = l_.row_start[i]; p < l_.row_start[i + 1]; ++p)
                    Single::put(Kernels<N>::block(l_, p), p, by_rows_);
                for (int k = below_.start[i]; k < below_.start[i + 1]; ++k)
                    Single::put(Kernels<N>::block(l_, below_.positions[k]).transpose(), k + i, by_columns_);
                Single::put(Kernels<N>::block(l_, l_.diagonal(i)).transpose(), below_.start[i + 1] + i,
                            by_columns_);
            }
        });
    }

    /// Rows first ... end of L^-1 r, all that they need of those before known.
    template <int N>
    void forward(int first, int end, const Eigen::VectorXd& r)
    {
        using Single = SinglePrecision<N>;
        for (int i = first; i < end; ++i) {
            typename Single::Sum sum = Single::Sum::Zero();
            sum.template head<N>() = r.segment<N>(N * order_[i]).template cast<float>();
            for (int p = l_.row_start[i]; p < l_.diagonal(i); ++p)
                sum -= Single::product(by_rows_, p, ordered_.data() + N * l_.columns[p]);
            typename Single::Segment(ordered_.data() + N * i) =
                Single::product(by_rows_, l_.diagonal(i), sum.data()).template head<N>();
        }
    }

    /// The same of z = L^-T L^-1 r, all that they need of those behind known.
    template <int N>
    void backward(int first, int end, Eigen::VectorXd& z)
    {
        using Single = SinglePrecision<N>;
        for (int i = end - 1; i >= first; --i) {
            const typename Single::Segment own(ordered_.data() + N * i);
            typename Single::Sum sum = Single::Sum::Zero();
            sum.template head<N>() = own;
            for (int k = below_.start[i + 1] - 1; k >= below_.start[i]; --k)
                sum -= Single::product(by_columns_, k + i, ordered_.data() + N * below_.rows[k]);
            typename Single::Segment(ordered_.data() + N * i) =
                Single::product(by_columns_, below_.start[i + 1] + i, sum.data()).template head<N>();
            z.segment<N>(N * order_[i]) = own.matrix().template cast<double>();
        }
    }

    void analyse(const BlockMatrix& a);
    void set_order(const BlockMatrix& a, std::vector<int>& place);

    std::vector<int> columns_, row_start_;  // of the matrix that was analysed
    ColumnsOf of_matrix_;
    Domains domains_;
    int count_ = 0;                     // of domains
    std::vector<int> order_;            // rows of the matrix in the order of the factor
    std::vector<int> inside_, border_;  // (domains + 1) rows of the factor where those of each begin
    BlockMatrix l_;                     // rows in its own order
    std::vector<Taken> taken_;          // of each block of it
    ColumnsOf below_;                   // its columns
    std::vector<float> by_rows_;        // its blocks, as they are there
    std::vector<float> by_columns_;     // turned, the diagonal one last in each column
    Eigen::VectorXf ordered_;           // scratch
};

}  // namespace voussoir::solve
