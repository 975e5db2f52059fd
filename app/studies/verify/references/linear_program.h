// A linear program, solved by the simplex method of CLP. Source: [ClpManual].
#pragma once

#include <memory>
#include <utility>
#include <vector>

class ClpSimplex;

namespace voussoir::app::studies::verify::references
{

/// maximise c x subject to rows and x >= 0, coefficients and x of the order of 1. Solved again after a change it
/// goes on from its last basis.
class LinearProgram
{
 public:
    /// Coefficients of one row: (variable, value), each variable at most once.
    using Row = std::vector<std::pair<int, double>>;

    LinearProgram();
    ~LinearProgram();
    LinearProgram(const LinearProgram&) = delete;
    LinearProgram& operator=(const LinearProgram&) = delete;

    /// A variable x >= 0. @param objective its c @returns its number
    int add_variable(double objective);
    /// lower <= row x <= upper. @pre its variables have been added @returns its number
    int add_row(const Row& row, double lower, double upper);
    void set_upper(int row, double upper);
    void set_objective(int variable, double objective);
    void fix(int variable, double value);

    /// Whether there is a greatest value and it was found, at a place that keeps all rows to 1e-8.
    bool maximise();
    double greatest() const;
    double value(int variable) const;

 private:
    bool keeps_rows() const;

    std::unique_ptr<ClpSimplex> model_;
};

}  // namespace voussoir::app::studies::verify::references
