// A freestanding gate: an arch between two piers under an attic.
#pragma once

#include <string>

#include "importers/patterns/arch_curve.h"
#include "importers/patterns/facade.h"

namespace voussoir::importers::patterns
{

/// All lengths in m.
struct Gate {
    ArchCurve curve;              // of the opening
    double depth = 1.2;           // along y
    BlockFormat block{0.8, 0.4};  // of piers and walls
    double pier_width = 1.2;      // along x
    double pier_height = 3;       // from the slabs to the springing
    double attic = 0.4;           // from the crown of the extrados to the top
    int stones_across = 1;        // voussoirs side by side
};

/// "slab_left" (group foundation), "pier_left_c01_b01" ..., "pier_left_impost" (pier), "voussoir_01" ...,
/// "keystone" (voussoirs), "wall_left_c01_b01" ... beside the arch, "attic_c01_b01" ... over it (wall). x is along
/// the span, the springing is z = 0, the middle x = y = 0. Voussoirs have stepped backs, as those of a bridge.
/// @param name before all names @throws InputError with what makes no gate
Pattern gate(const Gate& gate, const std::string& name);

}  // namespace voussoir::importers::patterns
