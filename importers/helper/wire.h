// What the program and its geometry helper say to each other: JSON text, doubles to the last bit.
#pragma once

#include <string>
#include <vector>

#include "importers/helper/geometry.h"

namespace voussoir::importers::helper
{

struct HelperRequest {
    std::vector<MeshRequest> meshes;
    GeometryLimits limits;
};

/// @throws InputError when a file name is not UTF-8
std::string to_json(const HelperRequest& request);

/// @throws std::exception when the text is not what to_json wrote
HelperRequest request_from_json(const std::string& text);

/// What asks the helper for the formats that it reads, in place of a HelperRequest.
std::string formats_request();
std::string to_json(const std::vector<mesh::MeshFormat>& formats);

/// @throws std::exception when the text is not what to_json wrote
std::vector<mesh::MeshFormat> formats_from_json(const std::string& text);

std::string to_json(const Geometry& geometry);

/// Trusts nothing: every polyhedron is made, and so checked, again.
/// @throws std::exception when the text is not what to_json wrote
Geometry geometry_from_json(const std::string& text);

}  // namespace voussoir::importers::helper
