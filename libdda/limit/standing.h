// Whether anything balances a structure where it is now.
#pragma once

#include <vector>

#include "libdda/limit/balance.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::limit
{

/// The problem of a model in a state, its contacts found anew: all bear that are open by no more than `reach` of
/// the smaller stone's size.
/// @param dead, live accelerations [m/s2]
LimitProblem problem_in(const Model& model, const State& state, const Eigen::Vector3d& dead,
                        const Eigen::Vector3d& live, double reach, FacePoints points);

/// Whether forces within friction could balance the weight of rigid stones where they are in a state, if all
/// contacts bore that are open by no more than `reach` of the smaller stone's size. `unknown` where ground carries
/// waves: it takes what force it is given.
/// @param gravity [m/s2]
Balance balance_in(const Model& model, const State& state, const Eigen::Vector3d& gravity, double reach);

/// The same of joints that slide without opening: standing_without_dilatancy.
/// @param moving blocks, if all others are to stay where they are; none: all may move
Standing sliding_in(const Model& model, const State& state, const Eigen::Vector3d& gravity, double reach,
                    const std::vector<int>& moving = {});

}  // namespace voussoir::limit
