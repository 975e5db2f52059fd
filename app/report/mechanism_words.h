// A mechanism as an engineer would tell it.
#pragma once

#include <string>
#include <vector>

#include "app/report/mechanism.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::report
{

struct MechanismWords {
    std::string headline;  // one sentence
    // One each, from the most to the least moved; of many joints and bodies those that do the same together.
    std::vector<std::string> joints, bodies;
};

MechanismWords words_of(const Mechanism& mechanism, const results::RecordedModel& model, const Course& course);

using words::length_in_words;

/// "1.67 MPa", "52.2 kPa".
std::string stress_in_words(double pascals);

/// "stands", "hinges", "slides", "overturns", "sheds", "mixed", "loose".
const char* name_of(MechanismKind kind);

}  // namespace voussoir::app::report
