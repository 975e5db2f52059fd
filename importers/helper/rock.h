// Rock cut by joint sets, by the helper program: CGAL is not loaded into the program that asks.
#pragma once

#include <string>

#include "importers/exact/joint_sets.h"
#include "importers/helper/geometry.h"

namespace voussoir::importers::helper
{

/// Has the helper cut a body. @throws InputError when it gives no answer, with what it said
exact::CutRock ask_for_rock(const exact::RockRequest& request, const GeometryLimits& limits);

// What the program and its helper say to each other, doubles to the last bit.
std::string to_json(const exact::RockRequest& request);
std::string to_json(const exact::CutRock& rock);
/// Is a request one for rock?
bool asks_for_rock(const std::string& text);
/// @throws std::exception when the text is not what to_json wrote
exact::RockRequest rock_request_from_json(const std::string& text);
exact::CutRock rock_from_json(const std::string& text);

}  // namespace voussoir::importers::helper
