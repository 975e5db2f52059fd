// Motions that end at rest where they began.
#pragma once

#include <vector>

namespace voussoir::records::synthetic
{

/// Adds c0 b0 + c1 b1, b0 = x^2 (1-x)^2 and b1 = x b0 for x from 0 to 1 over the record, so that velocity and
/// displacement of the piecewise linear acceleration both end at zero; the ends keep their values.
/// @param samples (n >= 4), in any unit, evenly spaced
void bring_to_rest(std::vector<double>& samples);

}  // namespace voussoir::records::synthetic
