#include "app/studies/verify/references/linear_program.h"

#include <ClpSimplex.hpp>
#include <vector>

namespace voussoir::app::studies::verify::references
{

namespace
{

constexpr double most_violation = 1e-8;  // of a row or a bound, in what are numbers of the order of 1

}  // namespace

LinearProgram::LinearProgram() : model_(std::make_unique<ClpSimplex>())
{
    model_->setLogLevel(0);
    model_->setOptimizationDirection(-1);
    model_->setPrimalTolerance(1e-9);
    model_->setDualTolerance(1e-9);
    model_->scaling(0);  // tolerances are those of the rows as they are
}

LinearProgram::~LinearProgram() = default;

int LinearProgram::add_variable(double objective)
{
    model_->addColumn(0, nullptr, nullptr, 0, COIN_DBL_MAX, objective);
    return model_->numberColumns() - 1;
}

int LinearProgram::add_row(const Row& row, double lower, double upper)
{
    std::vector<int> columns;
    std::vector<double> values;
    for (const auto& [variable, value] : row) {
        columns.push_back(variable);
        values.push_back(value);
    }
    model_->addRow(static_cast<int>(row.size()), columns.data(), values.data(), lower, upper);
    return model_->numberRows() - 1;
}

void LinearProgram::set_upper(int row, double upper)
{
    model_->setRowUpper(row, upper);
}

void LinearProgram::set_objective(int variable, double objective)
{
    model_->setObjectiveCoefficient(variable, objective);
}

void LinearProgram::fix(int variable, double value)
{
    model_->setColumnBounds(variable, value, value);
}

// Near infeasibility CLP may call a solution optimal (secondary status 3) that violates rows by up to 3e-4, in
// both methods: what it says is believed only of a solution that keeps the rows.
bool LinearProgram::maximise()
{
    model_->dual();
    if (model_->isProvenOptimal() && keeps_rows()) return true;
    model_->allSlackBasis(true);  // the last basis led nowhere
    model_->primal();
    return model_->isProvenOptimal() && keeps_rows();
}

bool LinearProgram::keeps_rows() const
{
    std::vector<double> rows(static_cast<std::size_t>(model_->numberRows()), 0.0);
    model_->times(1, model_->primalColumnSolution(), rows.data());
    for (int r = 0; r < model_->numberRows(); ++r) {
        const double value = rows[static_cast<std::size_t>(r)];
        if (value < model_->rowLower()[r] - most_violation || value > model_->rowUpper()[r] + most_violation)
            return false;
    }
    for (int c = 0; c < model_->numberColumns(); ++c)
        if (model_->primalColumnSolution()[c] < -most_violation) return false;
    return true;
}

double LinearProgram::greatest() const
{
    return model_->objectiveValue();
}

double LinearProgram::value(int variable) const
{
    return model_->primalColumnSolution()[variable];
}

}  // namespace voussoir::app::studies::verify::references
