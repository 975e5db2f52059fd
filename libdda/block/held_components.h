// Which unknowns of a block are no unknowns.
#pragma once

#include <algorithm>
#include <array>

#include "libdda/block/kinematics_traits.h"
#include "libdda/model/model.h"

namespace voussoir::step
{

/// What a foundation and tied sides leave of the unknowns of a block. Steps and impacts ask here alike.
template <class K>
struct HeldComponents {
    std::array<bool, K::unknowns> held{};
    bool sides_tied = false;  // it neither turns nor stretches sideways

    /// Whether the block has a spin.
    bool turns() const { return !held[K::dimension]; }
};

/// @param is_foundation false: the foundations of the model need not be looked through for it
template <class K>
HeldComponents<K> held_components(const Model& model, int block, bool is_foundation = true)
{
    constexpr int D = K::dimension;
    HeldComponents<K> result;
    if (is_foundation)
        for (const Foundation& foundation : model.foundations) {
            if (foundation.block != block) continue;
            for (int k = 0; k < D; ++k) result.held[k] = foundation.translation_held[axis_in_space<D>(k)];
            std::fill(result.held.begin() + D, result.held.end(), foundation.rotation_held);
        }
    // The columns of L that horizontal lines would turn and stretch by.
    result.sides_tied = std::binary_search(model.tied_sides.begin(), model.tied_sides.end(), block);
    if (result.sides_tied) std::fill(result.held.begin() + D, result.held.end() - D, true);
    return result;
}

}  // namespace voussoir::step
