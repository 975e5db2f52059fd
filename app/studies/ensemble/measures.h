// What is compared: numbers of a run that an engineer decides by, and their medians over the members.
#pragma once

#include <string>
#include <vector>

#include "app/studies/ensemble/member_run.h"

namespace voussoir::app::studies::ensemble
{

struct EnsembleMeasure {
    std::string name;  // "south_top: peak drift"
    std::string unit;  // "mm"; "" of a count
};

/// Peak and residual drift of every history's point, then the joints.
/// @param limit see run_member [m]
std::vector<EnsembleMeasure> measures_of(const Case& member, double limit);

/// In the order of `measures_of`, in its units. Of a collapsed run all are infinite, of one that gave up NaN.
std::vector<double> values_of(const MemberRun& run);

/// Middle of a list, or mean of the two in the middle; NaN if one value is or there is none.
double median_of(std::vector<double> values);

/// Largest less smallest; 0 where all are infinite, NaN if one value is NaN or there is none.
double range_of(const std::vector<double>& values);

}  // namespace voussoir::app::studies::ensemble
