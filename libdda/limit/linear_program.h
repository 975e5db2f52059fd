// A linear program, solved by the simplex method of CLP. Source: [ClpManual].
#pragma once

#include <limits>
#include <memory>
#include <utility>
#include <vector>

class ClpSimplex;

namespace voussoir::limit
{

/// maximise c x subject to rows and bounds, coefficients and x of the order of 1. Solved again after a change it
/// goes on from its last basis.
class LinearProgram
{
 public:
    /// Coefficients of one row: (variable, value), each variable at most once.
    using Row = std::vector<std::pair<int, double>>;
    static constexpr double infinite = std::numeric_limits<double>::max();  ///< No bound.

    LinearProgram();
    ~LinearProgram();
    LinearProgram(const LinearProgram&) = delete;
    LinearProgram& operator=(const LinearProgram&) = delete;

    /// A variable lower <= x <= upper. @param objective its c @returns its number
    int add_variable(double objective, double lower = 0, double upper = infinite);
    /// lower <= row x <= upper. @pre its variables have been added @returns its number
    int add_row(const Row& row, double lower, double upper);
    void set_upper(int row, double upper);
    void set_objective(int variable, double objective);
    void fix(int variable, double value);

    /// Whether there is a greatest value and it was found, at a place that keeps all rows to 1e-8.
    bool maximise();
    double greatest() const;
    double value(int variable) const;
    /// By how much the greatest value grows with the bound of a row that holds it.
    double price(int row) const;

 private:
    void load();
    bool keeps_rows() const;

    /// Added since the last solution.
    struct Pending {
        std::vector<double> objectives, column_lower, column_upper;
        std::vector<int> row_starts{0}, columns;
        std::vector<double> values, row_lower, row_upper;
    };
    std::unique_ptr<ClpSimplex> model_;
    Pending pending_;
    int variables_ = 0, rows_ = 0;
};

}  // namespace voussoir::limit
