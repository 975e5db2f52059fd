// A mechanism as an engineer would tell it.
#pragma once

#include <string>
#include <vector>

#include "app/report/mechanism.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::report
{

struct MechanismWords {
    std::string headline;             // one sentence
    std::vector<std::string> joints;  // one each, from the most to the least moved
    std::vector<std::string> bodies;  // one each that moves
};

MechanismWords words_of(const Mechanism& mechanism, const results::RecordedModel& model, const Course& course);

using words::length_in_words;

/// "1.67 MPa", "52.2 kPa".
std::string stress_in_words(double pascals);

/// "stands", "hinges", "slides", "overturns", "sheds", "mixed", "loose".
const char* name_of(MechanismKind kind);

/// "a, b, c and 12 others" of these blocks.
std::string names_in_words(const std::vector<int>& blocks, const std::vector<std::string>& names,
                           std::size_t most = 4);

}  // namespace voussoir::app::report
