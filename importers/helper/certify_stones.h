// Stones from surfaces: proven, fitted to each other, made of convex parts.
#pragma once

#include <vector>

#include "importers/exact/certify.h"
#include "importers/fit/fit_joints.h"
#include "importers/helper/geometry.h"

namespace voussoir::importers::helper
{

/// A stone on its way: its surface is proven or refused, its shape is not known yet.
struct StoneDraft {
    exact::Certificate surface;
    exact::CertifyOptions options;
    std::vector<mesh::Repair> repairs;  // before those of the certificate
    fit::FittedStone fitted;
};

/// Proves the surface of a stone. @param rounding of its coordinates on reading [m]
StoneDraft draft_stone(mesh::PolygonSurface surface, exact::CertifyOptions options, double rounding);

/// Fits the stones of all files that ask for it in the same way to each other; hulls and simplified scans take no
/// part.
JointFit fit_stones(const std::vector<MeshRequest>& requests, std::vector<std::vector<StoneDraft>>& files);

/// The stone with its convex parts, or with the reason why it has none.
Stone certified(StoneDraft draft);

}  // namespace voussoir::importers::helper
