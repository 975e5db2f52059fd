// The value at which a structure collapses, found by bisection at every setting: what there is to compare of a
// case whose end states say nothing.
#pragma once

#include <string>
#include <vector>

#include "app/case/case_reader.h"
#include "app/studies/converge/study.h"

namespace voussoir::app::studies::converge
{

/// "foundation.motion.x.scale=1..3", "stages[0].body_acceleration[0].x.sine.acceleration=0.1 g..0.5 g".
struct Threshold {
    std::string key;                   // as it was written: one or, between commas, several
    std::vector<std::string> keys;     // as --set takes them; all have the same value
    double stands = 0, collapses = 0;  // in `unit`; either may be the larger
    std::string unit;                  // as written; empty for a bare number
    double bracket = 0.01;             // -, share of the middle at which the bisection ends
};

/// @throws InputError when the text is no threshold
Threshold read_threshold(const std::string& text);

/// What --set takes to give the keys a value.
std::vector<std::string> settings_of(const Threshold& threshold, double value);

/// Runs the bisection at every setting and judges the thresholds in every series. A setting at which the structure
/// collapses already where it should stand, or stands where it should collapse, or at which a run gives up, is a
/// failure of that setting.
/// @param the_case read with its `overrides`
/// @param read reads it anew at every value
/// @throws InputError when the case cannot be read with the key; Interrupted
ConvergeStudy run_threshold_study(const Case& the_case, const SettingList& list, const Threshold& threshold,
                                  const CollapseRule& rule, int threads, const ConvergeWatch& watch,
                                  const CaseReader& read);

}  // namespace voussoir::app::studies::converge
