// What stands in the way of trusting a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libdda/analysis/trust.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"

namespace voussoir::app::words
{

/// One sentence for each limit that a run has broken and for each thing it found that its reader must know, with
/// what to do in numbers. Console, summary and report have these and no others.
/// @param trust nothing: no motion began, or it was not asked for
std::vector<std::string> doubts_of(const RunReport& report, const std::optional<Trust>& trust, const Model& model,
                                   const std::vector<Stage>& stages);

}  // namespace voussoir::app::words
