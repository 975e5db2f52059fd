#include "libdda/limit/linear_program.h"

#include <ClpSimplex.hpp>
#include <vector>

namespace voussoir::limit
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

int LinearProgram::add_variable(double objective, double lower, double upper)
{
    pending_.objectives.push_back(objective);
    pending_.column_lower.push_back(lower);
    pending_.column_upper.push_back(upper);
    return variables_++;
}

int LinearProgram::add_row(const Row& row, double lower, double upper)
{
    for (const auto& [variable, value] : row) {
        pending_.columns.push_back(variable);
        pending_.values.push_back(value);
    }
    pending_.row_starts.push_back(static_cast<int>(pending_.columns.size()));
    pending_.row_lower.push_back(lower);
    pending_.row_upper.push_back(upper);
    return rows_++;
}

// CLP takes rows and columns one by one in a time that grows with what it has: they are handed over together.
void LinearProgram::load()
{
    if (!pending_.objectives.empty())
        model_->addColumns(static_cast<int>(pending_.objectives.size()), pending_.column_lower.data(),
                           pending_.column_upper.data(), pending_.objectives.data(), nullptr);
    if (!pending_.row_lower.empty())
        model_->addRows(static_cast<int>(pending_.row_lower.size()), pending_.row_lower.data(),
                        pending_.row_upper.data(), pending_.row_starts.data(), pending_.columns.data(),
                        pending_.values.data());
    pending_ = {};
}

void LinearProgram::set_upper(int row, double upper)
{
    load();
    model_->setRowUpper(row, upper);
}

void LinearProgram::set_objective(int variable, double objective)
{
    load();
    model_->setObjectiveCoefficient(variable, objective);
}

void LinearProgram::fix(int variable, double value)
{
    load();
    model_->setColumnBounds(variable, value, value);
}

// Near infeasibility CLP may call a solution optimal (secondary status 3) that violates rows by up to 3e-4, in
// both methods: what it says is believed only of a solution that keeps the rows.
bool LinearProgram::maximise()
{
    load();
    model_->dual();
    if (model_->isProvenOptimal() && keeps_rows()) return true;
    model_->allSlackBasis(true);  // the last basis led nowhere
    model_->primal();
    return model_->isProvenOptimal() && keeps_rows();
}

bool LinearProgram::keeps_rows() const
{
    std::vector<double> rows(static_cast<std::size_t>(model_->numberRows()), 0.0);
    const double* solution = model_->primalColumnSolution();
    model_->times(1, solution, rows.data());
    for (int r = 0; r < model_->numberRows(); ++r) {
        const double value = rows[static_cast<std::size_t>(r)];
        if (value < model_->rowLower()[r] - most_violation || value > model_->rowUpper()[r] + most_violation)
            return false;
    }
    for (int c = 0; c < model_->numberColumns(); ++c)
        if (solution[c] < model_->columnLower()[c] - most_violation ||
            solution[c] > model_->columnUpper()[c] + most_violation)
            return false;
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

double LinearProgram::price(int row) const
{
    return model_->dualRowSolution()[row];
}

}  // namespace voussoir::limit
