// Energies of a state as it stands.
#pragma once

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Kinetic energy of all components that are not held [J].
double kinetic_energy(const Model& model, const State& state);

/// Strain energy of all blocks that have unknowns [J]; 0 in a rigid scene.
double strain_energy(const Model& model, const State& state);

/// A ledger whose start values are those of the state.
EnergyLedger open_ledger(const Model& model, const State& state);

/// Angular momentum of a block about its centroid [Nms].
Eigen::Vector3d angular_momentum(const Model& model, const State& state, int block);

}  // namespace voussoir
