// The incomplete factor of a large matrix in parts, which threads make and use side by side.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <variant>
#include <vector>

#include "libdda/model/parallel.h"
#include "libdda/solve/block_kernels.h"
#include "libdda/solve/block_matrix.h"
#include "libdda/solve/single_factor.h"

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
/// then each domain's border, is worked on by itself. A factor in several domains is made and used in single
/// precision, and made in double where too little is left of a diagonal entry. Source: docs/numerics.md 3.
class IncompleteFactor
{
 public:
    /// Gets ready for the pattern of a matrix: columns() are known.
    template <int N>
    void prepare(const BlockMatrix& a)
    {
        if (a.block_size != l_.block_size || a.columns != columns_ || a.row_start != row_start_) analyse(a);
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
        if (count_ == 1)
            beside();
        else if (factorise_in_single<N>(a, threads, beside))
            return;
        l_.values.resize(l_.columns.size() * N * N);
        const auto factorise_rows = [&](int first, int end) {
            for (int i = first; i < end; ++i) {
                for (int p = l_.row_start[i]; p < l_.row_start[i + 1]; ++p)
                    take<N>(a, p, [&](const auto& block) { typename Kernels<N>::Block(l_.block(p)) = block; });
                Kernels<N>::factorise_row(Kernels<N>::block(a, taken_[l_.diagonal(i)].position), i, l_);
            }
        };
        each_in_parallel(count_, threads, [&](std::size_t d) { factorise_rows(inside_[d], inside_[d + 1]); });
        each_in_parallel(count_, threads, [&](std::size_t d) { factorise_rows(border_[d], border_[d + 1]); });
        if (count_ == 1) return;
        in_parallel(order_.size(), threads, [&](std::size_t first, std::size_t end) {
            for (int p = l_.row_start[first]; p < l_.row_start[end]; ++p)
                single<N>().put(Kernels<N>::block(l_, p), p);
        });
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
        const Eigen::Index size = r.size() / N * SinglePrecision<N>::width;
        if (ordered_.size() != size) ordered_.setZero(size);
        each_in_parallel(count_, threads, [&](std::size_t d) { forward<N>(inside_[d], inside_[d + 1], r); });
        each_in_parallel(count_, threads, [&](std::size_t d) {
            forward<N>(border_[d], border_[d + 1], r);
            backward<N>(border_[d], border_[d + 1], z);
        });
        each_in_parallel(count_, threads, [&](std::size_t d) { backward<N>(inside_[d], inside_[d + 1], z); });
    }

    std::int64_t entries() const
    {
        return static_cast<std::int64_t>(l_.columns.size()) * l_.block_size * l_.block_size;
    }
    /// Of the matrix that was factorised.
    int block_size() const { return l_.block_size; }
    const ColumnsOf& columns() const { return of_matrix_; }

 private:
    /// Where a block of the factor comes from.
    struct Taken {
        int position = 0;  // in the matrix
        bool turned = false;
    };

    /// Calls use(block p of the factor's pattern, as the matrix has it).
    template <int N, class Use>
    void take(const BlockMatrix& a, int p, const Use& use) const
    {
        const auto taken = Kernels<N>::block(a, taken_[p].position);
        if (taken_[p].turned)
            use(taken.transpose());
        else
            use(taken);
    }

    /// @returns whether single precision is enough for this matrix; `beside` has been called
    template <int N, class Beside>
    bool factorise_in_single(const BlockMatrix& a, int threads, const Beside& beside)
    {
        SingleFactor<N>& factor = single<N>();
        factor.resize(l_);
        left_.assign(count_, 1);
        const auto factorise_rows = [&](std::size_t d, const std::vector<int>& starts) {
            for (int i = starts[d]; i < starts[d + 1] && left_[d] >= least_left; ++i)
                left_[d] = std::min(left_[d], factor.factorise_row(l_, i, [&](int p, auto& columns) {
                    take<N>(a, p, [&](const auto& block) { SinglePrecision<N>::take(block, columns); });
                }));
        };
        const auto is_enough = [&] { return *std::min_element(left_.begin(), left_.end()) >= least_left; };
        each_in_parallel(count_ + 1, threads, [&](std::size_t i) {
            if (i == 0)
                beside();
            else
                factorise_rows(i - 1, inside_);
        });
        if (!is_enough()) return false;
        each_in_parallel(count_, threads, [&](std::size_t d) { factorise_rows(d, border_); });
        return is_enough();
    }

    template <int N>
    SingleFactor<N>& single()
    {
        if (!std::holds_alternative<SingleFactor<N>>(single_)) single_.template emplace<SingleFactor<N>>();
        return std::get<SingleFactor<N>>(single_);
    }

    /// Rows first ... end of L^-1 r, all that they need of those before known.
    template <int N>
    void forward(int first, int end, const Eigen::VectorXd& r)
    {
        const SingleFactor<N>& factor = single<N>();
        for (int i = first; i < end; ++i) factor.forward(l_, i, r.segment<N>(N * order_[i]), ordered_.data());
    }

    /// The same of z = L^-T L^-1 r, all that they need of those behind known.
    template <int N>
    void backward(int first, int end, Eigen::VectorXd& z)
    {
        const SingleFactor<N>& factor = single<N>();
        for (int i = end - 1; i >= first; --i) {
            factor.backward(l_, below_, i, ordered_.data());
            z.segment<N>(N * order_[i]) = ordered_.segment<N>(factor.width * i).template cast<double>();
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
    std::variant<SingleFactor<3>, SingleFactor<6>, SingleFactor<12>> single_;  // of several domains
    std::vector<double> left_;  // of domains: of the diagonal entries of the matrix, the least part
    Eigen::VectorXf ordered_;   // scratch: as wide a segment as SinglePrecision has, zeros behind its numbers
};

}  // namespace voussoir::solve
