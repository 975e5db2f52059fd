// What a run did, as curves beside its reference.
#pragma once

#include <string>
#include <vector>

#include "app/plots/diagram.h"

namespace voussoir::app::studies::verify
{

/// A curve thinned to what a picture can show: of every bin the lowest and the highest point, and the last.
plots::Curve curve_of(const std::string& name, const std::vector<double>& x, const std::vector<double>& y,
                      bool is_reference = false);

/// A diagram with linear axes.
plots::Diagram linear_diagram(const std::string& x_title, const std::string& y_title,
                              std::vector<plots::Curve> curves);

}  // namespace voussoir::app::studies::verify
