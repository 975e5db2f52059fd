// The geometry of a run: what a reader wants certified before believing its results.
#pragma once

#include "app/report/document.h"
#include "app/report/run_record.h"

namespace voussoir::app::report
{

/// Extent, sizes of stones, whether their surfaces are closed and hold the volumes that were computed with, and
/// how they hung together at the start: contact areas, partial contacts, what no joint holds or connects with the
/// ground. From the results alone; `voussoir check` examines the drawing itself.
Table geometry_table(const RunRecord& record);

}  // namespace voussoir::app::report
