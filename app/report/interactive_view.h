// The interactive view of a report: the run as data for a script that the build has bundled.
#pragma once

#include <string>

#include "app/report/document.h"
#include "app/report/run_record.h"

namespace voussoir::app::report
{

/// The bundled script, from beside this program. Without hash and text where it was built without npm.
ViewScript view_script();

/// The run as JSON for the script: stones, joints and as many of the stored frames as fit into a page, evenly
/// chosen, the first, the last and the described one always. Displacements and turns are single precision,
/// openings, slips and normal forces a 65535th of their largest. Strains are not in it. Empty when not even two
/// frames fit.
/// @param magnification of displacements that the view begins with
std::string view_data(const RunRecord& record, double magnification);

/// Which of `count` frames are kept when `most` are: evenly, with the first, the last and `wanted`. @returns
/// ascending
std::vector<std::size_t> kept_frames(std::size_t count, std::size_t most, std::size_t wanted);

}  // namespace voussoir::app::report
