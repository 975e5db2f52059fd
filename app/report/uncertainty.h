// How sure the key results of a run are.
#pragma once

#include <string>

#include "app/report/document.h"

namespace voussoir::app::report
{

/// Adds a column to a table whose rows begin with the name of a quantity: how far the runs of the error estimate
/// are from it, or "not known". @param summary JSON text of the run's summary
void add_uncertainty(const std::string& summary, Table& table);

}  // namespace voussoir::app::report
