// Loops over long vectors, piece by piece on several threads, with sums that do not depend on how many there are.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "libdda/model/parallel.h"

namespace voussoir::solve
{

/// The unknowns of the rows of a block matrix, cut into pieces of 256 rows; one piece of fewer rows than
/// `blocks_worth_threads`. The rows alone decide, not the number of threads.
class Pieces
{
 public:
    Pieces(int rows, int unknowns_of_row, int threads)
        : size_(static_cast<Eigen::Index>(rows) * unknowns_of_row),
          piece_(static_cast<Eigen::Index>(unknowns_of_row) *
                 (rows < blocks_worth_threads ? std::max(rows, 1) : 256)),
          pieces_(static_cast<std::size_t>((size_ + piece_ - 1) / piece_)),
          threads_(threads)
    {
    }

    std::size_t count() const { return pieces_; }

    /// The piece that begins with an unknown.
    std::size_t at(Eigen::Index from) const { return static_cast<std::size_t>(from / piece_); }

    /// Calls work(first unknown, how many) for every piece.
    template <class Work>
    void each(const Work& work) const
    {
        each_in_parallel(pieces_, threads_, [&](std::size_t piece) {
            const Eigen::Index from = static_cast<Eigen::Index>(piece) * piece_;
            work(from, std::min(piece_, size_ - from));
        });
    }

    /// The sum of what part(first unknown, how many) gives for every piece, added up in their order.
    template <class Part>
    double sum(const Part& part)
    {
        if (pieces_ == 1) return part(Eigen::Index{0}, size_);
        sums_.resize(pieces_);
        each([&](Eigen::Index from, Eigen::Index count) { sums_[at(from)] = part(from, count); });
        double total = 0;
        for (const double of_piece : sums_) total += of_piece;
        return total;
    }

    double dot(const Eigen::VectorXd& u, const Eigen::VectorXd& v)
    {
        return sum([&](Eigen::Index from, Eigen::Index count) {
            return u.segment(from, count).dot(v.segment(from, count));
        });
    }

 private:
    Eigen::Index size_, piece_;
    std::size_t pieces_;
    int threads_;
    std::vector<double> sums_;  // of the pieces
};

}  // namespace voussoir::solve
