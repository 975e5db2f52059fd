// What a run did, as curves beside its reference.
#pragma once

#include <string>
#include <vector>

namespace voussoir
{

/// A line of a benchmark's picture.
struct VerifyCurve {
    std::string name;  // in the legend
    std::vector<double> x, y;
    bool is_reference = false;
};

/// What the engine did beside its reference, on linear axes.
struct VerifyPicture {
    std::string x_title, y_title;  // with units
    std::vector<VerifyCurve> curves;
};

/// A curve thinned to what a picture can show.
VerifyCurve curve_of(const std::string& name, const std::vector<double>& x, const std::vector<double>& y,
                     bool is_reference = false);

}  // namespace voussoir
