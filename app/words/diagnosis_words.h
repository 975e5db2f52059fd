// What a run says of itself, in sentences: the likely cause and the remedy, in the words of the case file.
#pragma once

#include <string>
#include <vector>

#include "libdda/model/diagnosis.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"

namespace voussoir::app::words
{

/// One sentence without a full stop. @param diagnosis whole, of a run of this model and these stages
std::string in_words(const Diagnosis& diagnosis, const Model& model, const std::vector<Stage>& stages);

/// Why the run ended before its end; empty when it did not.
std::string message_of(const RunReport& report, const Model& model, const std::vector<Stage>& stages);

/// The warnings of a run, in their order.
std::vector<std::string> warnings_of(const RunReport& report, const Model& model,
                                     const std::vector<Stage>& stages);

}  // namespace voussoir::app::words
