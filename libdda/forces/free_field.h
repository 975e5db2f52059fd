// What ground that moves as it would without the model does to the model's side. Source: docs/method.md,
// Boundaries.
#pragma once

#include "libdda/block/block_face.h"
#include "libdda/forces/applied_forces.h"

namespace voussoir::step
{

/// Adds to the force on a face what its column does: its stress on the face, and, if there are dashpots, their
/// pull by its velocity. The column feels nothing of it.
/// @param face of the block that the force is on, with the map of its prediction @param column index into
/// Model::blocks @param impedance of the dashpots; zero: none @param end share of the end of the step
/// @returns what takes the unknowns of the column to the part of the force that they make
template <class K>
typename K::Square add_free_field(const Model& model, const FaceIn<K::dimension>& face, int column,
                                  const typename K::Matrix& impedance, double end, double h,
                                  const std::vector<BlockStep<K>>& blocks, AppliedForce<K>& force);

}  // namespace voussoir::step
