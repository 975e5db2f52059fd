// What domes and vaults that rest on held supports have in common.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "app/studies/verify/run_scene.h"
#include "importers/patterns/vaults.h"

namespace voussoir::app::studies::verify
{

constexpr double vault_unit_weight = 2200 * scenes::papers_gravity;  // N/m3
constexpr double degree = std::numbers::pi / 180;
constexpr double smooth = 0, rough = 37 * degree;  // rad, friction

/// The groups of a vault's blocks.
enum VaultGroup { masonry, support };

/// The stones of a grid on supports that are held. @param bearing friction of the joints at the supports [rad]
scenes::StagedScene vault_scene(const importers::patterns::StoneGrid& grid, const scenes::SceneSetting& setting,
                                double bearing);

/// What a support exerts on one stone.
struct Reaction {
    Eigen::Vector3d force;   // N
    Eigen::Vector3d centre;  // m, where its normal component acts
};

/// What the rows of vaults have in common.
Benchmark vault_row();

/// Runs a scene to rest. @returns the reactions of its supports in the order of the blocks; none when it gave up
std::vector<Reaction> rest(const scenes::StagedScene& scene, State& state, VerifyResult& result);

/// What every row says of its runs: how far the vertical reactions are from the weight, and the largest distance
/// between corners of two stones that were one at the start; nothing of the engine's contacts is asked for that.
std::string of_equilibrium(const importers::patterns::StoneGrid& grid, const Model& model, const State& state,
                           const std::vector<Reaction>& reactions);

/// "; " between the parts of a note.
inline const char* separator(const VerifyResult& result)
{
    return result.note.empty() ? "" : "; ";
}

}  // namespace voussoir::app::studies::verify
