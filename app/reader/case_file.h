// A YAML case file, read strictly: units on quantities, unknown keys refused, all faults listed at once with
// lines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "importers/helper/geometry.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// The stones of a case as far as they could be read, for the certificate of one that cannot be run.
struct CaseStones {
    importers::helper::Geometry geometry;  // what the mesh files gave, refused stones too
    Model model;
    std::vector<std::string> apart;  // blocks that begin turned or moving
};

/// Reads a case file and everything it names. Paths are relative to the case file.
/// @param overrides `key=value` as on the command line: "stages[1].time_step=1 ms"
/// @param stones filled before the faults of a case that cannot be run are thrown
/// @throws InputError with all faults, each placed as "arch.yaml:14: stages[1].time_step"
Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides,
               CaseStones* stones = nullptr);

/// The same of a text. @param file what faults call it; its folder is where paths begin
Case read_case_text(const std::filesystem::path& file, const std::string& text,
                    const std::vector<std::string>& overrides, CaseStones* stones = nullptr);

/// read_case as studies take it.
inline Case case_reader(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    return read_case(file, overrides);
}

}  // namespace voussoir::app::reader
