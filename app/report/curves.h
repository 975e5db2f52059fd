// Curves over time, as reports draw them.
#pragma once

#include <string>
#include <vector>

#include "app/plots/diagram.h"

namespace voussoir::app::report
{

/// The curve y / unit over x, thinned where it is long: of each stretch its least and its greatest value.
plots::Curve thinned(const std::string& name, const std::vector<double>& x, const std::vector<double>& y,
                     double unit = 1);

/// Lines over "time [s]", without marks and logarithms.
plots::Diagram over_time(const std::string& y_title, std::vector<plots::Curve> curves);

/// Diagrams over time one under another, others side by side.
plots::Figure figure_of(const std::string& name, const std::string& title, std::vector<plots::Diagram> diagrams);

}  // namespace voussoir::app::report
