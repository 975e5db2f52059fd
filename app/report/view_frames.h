// What the interactive view of a report knows of each moment.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/results/results_reader.h"

namespace voussoir::app::report
{

/// A quantity of all stones, or all joints, frame by frame.
struct ViewQuantity {
    std::string name;            // as the script knows it
    std::vector<double> values;  // (frames x count) SI; NaN where there is none
};

struct ViewFrames {
    std::vector<double> times;  // s
    std::vector<std::string> stages;
    std::vector<float>
        moves;  // (frames x stones x 6) displacement [m], vector part of the unit quaternion (w >= 0)
    std::vector<ViewQuantity> stones, joints;
};

/// In the page, before they become text.
std::size_t bytes_of_a_frame(const results::RecordedModel& model);

/// @param model in space
void add_frame(const results::RecordedModel& model, const results::RecordedFrame& frame, ViewFrames& frames);

/// As a JSON object. Quantities as shares of the range from their lowest (at most zero) to their largest, in 65534
/// steps; 65535: none.
std::string frames_as_json(const ViewFrames& frames);

}  // namespace voussoir::app::report
