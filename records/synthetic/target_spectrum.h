// Target spectra: what a design code or a site study asks the ground motion to be.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace voussoir::records::synthetic
{

/// Elastic response spectrum of pseudo-acceleration.
struct TargetSpectrum {
    std::string name;                  // "Eurocode 8 type 1, ground B, 0.25 g"
    double damping = 0.05;             // ratio
    std::function<double(double)> at;  // period [s] -> [m/s2]
    double shortest = 0, longest = 4;  // s, periods for which it is given
};

/// The elastic spectra of Eurocode 8. Source: [EN1998-1-2004], 3.2.2.2 with tables 3.2 and 3.3, vertical 3.2.2.3
/// with table 3.4.
struct Eurocode8 {
    int type = 1;             // 1: large distant earthquakes; 2: magnitude up to 5.5
    char ground = 'A';        // A to E
    double acceleration = 0;  // m/s2, design ground acceleration a_g on ground A
    bool vertical = false;    // then a_vg = 0.9 a_g (type 1) or 0.45 a_g (type 2), whatever the ground
    double damping = 0.05;    // ratio; eta = sqrt(10 / (5 + xi in per cent)), at least 0.55
};

/// @throws InputError for another type, ground, acceleration or damping
TargetSpectrum eurocode_8(const Eurocode8& parameters);

/// Linear between the points (n >= 2) of ascending periods [s] and their accelerations [m/s2].
/// @throws InputError when periods do not ascend or a value is not positive
TargetSpectrum tabulated_spectrum(std::string name, std::vector<double> periods, std::vector<double> accelerations,
                                  double damping);

}  // namespace voussoir::records::synthetic
