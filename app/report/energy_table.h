// The energy of a run: where it came from, where it went, and what of it.
#pragma once

#include <string>
#include <vector>

#include "app/report/document.h"

namespace voussoir::app::report
{

/// Terms that a curve of the diagram of energies adds up.
struct EnergyCurve {
    std::string words;
    std::vector<std::string> terms;
};

/// All of the balance but its residual: the first, "put in", is at every moment the sum of the others.
std::vector<EnergyCurve> energy_curves();

/// Every term of the balance above a billionth, in the order in which energy passes through a structure. Shares
/// are of what the balance is judged by: the largest of what was put in, lost, stored or there at the start.
/// @param summary as in summary.json, which has all of them
Table energy_table(const std::string& summary);

/// "Of 153 kJ put in by the motion: integrator 0.06 %, ..., and the rest is stored or was given back." Empty where
/// the run did not note it.
std::string energy_in_words(const std::string& summary);

}  // namespace voussoir::app::report
