// Buttresses, and flying buttresses with their piers.
#pragma once

#include <string>
#include <vector>

#include "importers/patterns/arch_curve.h"
#include "importers/patterns/facade.h"

namespace voussoir::importers::patterns
{

/// From the top of the one below to its own. Lengths in m.
struct ButtressStage {
    double height = 2;  // without its weathering
    double depth = 1;   // from the wall to its face
};

/// A mass against a wall that steps back as it rises. Lengths in m.
struct Buttress {
    double width = 1;                   // along the wall
    BlockFormat block{0.8, 0.4};        // of its stones
    std::vector<ButtressStage> stages;  // from below, each less deep than the one before
    double weathering = 0.785398163;    // rad, slope from the horizontal of the stones on each set-off
};

/// "slab" (group foundation), "stage_1_c01_b01" ..., "stage_1_weathering" ... (buttress). The wall is at x = 0,
/// the buttress stands at x > 0, its middle is y = 0, its foot z = 0. The weathering of a stage is one stone as
/// deep as the stage, whose back slopes down from the next one; the last one slopes down from the wall.
/// @param name before all names @throws InputError with what makes no buttress
Pattern buttress(const Buttress& buttress, const std::string& name);

/// A half arch from a wall to a pier that is weighed down. Lengths in m.
struct FlyingButtress {
    ArchCurve curve;              // of the whole arch whose right half this is: twice the span, an even number of
                                  // voussoirs
    double width = 0.6;           // along the wall
    BlockFormat block{0.8, 0.4};  // of pier and pinnacle
    double pier_depth = 1.5;      // along x
    double pier_height = 4;       // from the slab to the springing
    double pinnacle = 0;          // height of the courses on the pier behind the arch; 0: none
    double wall_thickness = 0.8;
};

/// "wall" and "slab" (group foundation), "voussoir_01" at the wall ... (voussoirs), "pier_c01_b01" ... and
/// "impost" (pier), "pinnacle_c01_b01" ... (pinnacle). The face of the wall is x = 0, the arch leaves it at a
/// vertical joint, the pier stands at x >= span; the springing is z = 0, the middle y = 0.
/// @param name before all names @throws InputError with what makes no flying buttress
Pattern flying_buttress(const FlyingButtress& buttress, const std::string& name);

}  // namespace voussoir::importers::patterns
