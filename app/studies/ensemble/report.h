// What `voussoir ensemble` writes: the table, the page, the JSON, the diagrams.
#pragma once

#include <string>
#include <vector>

#include "app/plots/diagram.h"
#include "app/studies/ensemble/study.h"

namespace voussoir::app::studies::ensemble
{

/// One finished run, in a line.
std::string run_in_words(const EnsembleStudy& study, const MemberRun& run);

/// The verdict in a sentence.
std::string verdict_of(const EnsembleStudy& study);

/// "12.3", "collapsed", "-" where a run gave up.
std::string value_in_words(double value);

/// For a terminal.
std::string ensemble_table(const EnsembleStudy& study);

/// ensemble.md. @param command how the page was made; @param figures names of the diagrams, `ensemble/NAME.png`
std::string ensemble_page(const EnsembleStudy& study, const std::string& command,
                          const std::vector<std::string>& figures);

/// See docs/ensemble.md for the fields; what does not exist is null.
std::string ensemble_json(const EnsembleStudy& study);

/// One figure: the drift of each point over time, one curve a run, one colour a setting.
std::vector<plots::Figure> ensemble_figures(const EnsembleStudy& study);

}  // namespace voussoir::app::studies::ensemble
