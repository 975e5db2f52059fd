#include "app/studies/verify/references/linear_program.h"

#include <ClpSimplex.hpp>

namespace voussoir::app::studies::verify::references
{

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

bool LinearProgram::maximise()
{
    model_->dual();
    if (!model_->isProvenOptimal()) {  // the last basis led nowhere
        model_->allSlackBasis(true);
        model_->primal();
    }
    return model_->isProvenOptimal();
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
