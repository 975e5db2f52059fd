// What reading a case turns up on the way: faults, defaults taken, warnings.
#pragma once

#include <string>
#include <vector>

#include "importers/helper/geometry.h"
#include "libdda/errors.h"

namespace voussoir::app::reader
{

/// A default that was taken: "stages[1]", "time_step", "0.002 s".
struct TakenDefault {
    std::string path, key, value;
};

/// Gathered rather than thrown, so that the user sees everything at once.
struct Findings {
    std::string file;  // the case file as the user named it
    std::vector<Fault> faults;
    std::vector<TakenDefault> defaults;
    std::vector<std::string> warnings;
    std::vector<std::string> former_keys;  // used by the case and warned of: once each
    importers::helper::Geometry geometry;  // what the mesh files gave, refused stones too: for the certificate
    std::string mesh_place;                // where the case names its first mesh
    std::vector<std::string> apart;        // blocks that begin turned or moving
};

/// One line for each part of the case: "stages[1]: time_step = 0.002 s, integrator = newmark".
std::vector<std::string> in_words(const std::vector<TakenDefault>& defaults);

}  // namespace voussoir::app::reader
