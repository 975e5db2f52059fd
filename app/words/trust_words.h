// How far a run can be trusted, in a few lines and in sentences.
#pragma once

#include <string>
#include <vector>

#include "libdda/analysis/trust.h"
#include "libdda/model/stage.h"

namespace voussoir::app::words
{

/// "first modes 4.31, 5.02 Hz; the integrator damps them by at most 0.003 % of critical; ...": a line without a
/// full stop.
std::string vibrations_in_words(const Trust& trust);

/// "of 563 kJ put in: friction 40 %, ..."; empty when nothing moved.
std::string shares_in_words(const EnergyShares& shares);

/// One sentence for each limit that is exceeded: what is too much, the limit, and the remedy.
std::vector<std::string> warnings_of(const Trust& trust, const std::vector<Stage>& stages);

}  // namespace voussoir::app::words
