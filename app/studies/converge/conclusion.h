// What a study comes to: the setting to run the case with, and what is known of its results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/converge/study.h"

namespace voussoir::app::studies::converge
{

/// What is known of a quantity at the setting that is recommended.
struct KnownQuantity {
    std::string name, unit;
    std::optional<double> value;   // that the run with this setting gives
    std::optional<double> within;  // -, of the series' scale: error and uncertainty together; none: not known
    std::string why_not;           // it is not known; empty where it is
};

/// The cheapest setting that meets the tolerance in all quantities, or else the one of which most is known.
struct Conclusion {
    double tolerance = 0;                  // -, that was wanted
    bool meets = false;                    // all quantities are within it
    const SeriesRow* row = nullptr;        // in the study; null when no run gave a value
    bool is_static = false;                // the case has no dynamic stage
    std::vector<KnownQuantity> known;      // one for each quantity
    std::vector<std::string> case_lines;   // for the case file; empty when the case has this setting already
    std::vector<std::string> set_options;  // the same as arguments of --set
    std::vector<std::string> joint_lines;  // for the case file, where joints are meant to be rigid
    std::vector<std::string> remarks;      // sentences: joints, other integrators, what to do instead
};

/// An uncertainty above this is no knowledge. [-]
inline constexpr double most_uncertain = 0.3;

/// @param study with at least one quantity
Conclusion conclude(const ConvergeStudy& study);

/// The conclusion for a terminal or, between fences, for a page.
std::vector<std::string> in_words(const Conclusion& conclusion);

}  // namespace voussoir::app::studies::converge
