// What makes the members of an ensemble differ: one key of the case, and the values it takes.
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/case/case_reader.h"

namespace voussoir::app::studies::ensemble
{

struct Variation {
    std::string key;                  // "blocks[0].house.imperfection.seed"
    std::vector<std::string> values;  // at least one, all different
};

/// Reads "KEY=VALUE,VALUE,...", where a value may be a list or a map: KEY=[a,b,c],[d,e,f]. @throws InputError when
/// it is not that
Variation read_variation(const std::string& text);

/// The case once for every value. @throws InputError with the faults of the first that cannot be read, or when
/// the members have no dynamic stage or no point to follow
std::vector<Case> read_members(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                               const Variation& variation, const CaseReader& read);

}  // namespace voussoir::app::studies::ensemble
