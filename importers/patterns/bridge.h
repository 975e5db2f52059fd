// A stone bridge of one or several arches, equal or not, with piers, spandrel walls, backing, fill and parapets.
#pragma once

#include "importers/patterns/arch_curve.h"
#include "importers/patterns/facade.h"
#include "importers/patterns/imperfection.h"

namespace voussoir::importers::patterns
{

/// What lies between the spandrel walls above the backing.
enum class Fill {
    none,
    mass,    // weight and inertia on the stones below, without pressure on the walls
    blocks,  // stones twice as long as the others
};

/// All lengths in m.
struct Bridge {
    std::string name;               // before the names of its stones; may be empty
    std::vector<ArchCurve> arches;  // from left to right
    double width = 4;               // of arches, piers and abutments
    int stones_across = 3;          // voussoirs side by side
    BlockFormat block{1, 0.5};      // of piers, walls and backing
    double abutment_length = 3;     // from the springing to the back
    double pier_width = 2;          // along the bridge
    double pier_height = 3;         // from the foundation slab to the springing; of the abutments too
    double cutwater = 0;            // from the face of the pier to its edge; 0: none
    double spandrel_thickness = 0;  // of the walls at both faces; 0: none
    double backing = 0;             // height above the springing
    double cover = 0;               // from the crown of the extrados to the road
    double parapet_height = 0;      // above the road; 0: none
    double parapet_thickness = 0;   // at most that of the spandrel walls
    Fill fill = Fill::none;
    double fill_density = 1800;  // kg/m3, of fill as mass
    StoneImperfection imperfection;
};

/// "arch_1_voussoir_01" ..., "arch_1_keystone", "pier_1_c02_b01", "pier_1_impost_b01", "pier_1_cutwater_south",
/// "abutment_left", "spandrel_south_1_c03_b02", "backing_1_c01_b04", "fill_...", "parapet_south_b01". Groups:
/// foundation (abutments and the slabs under piers), voussoirs, pier, spandrel, backing, fill, parapet. x is along
/// the bridge, y across, z up; the springing is z = 0 and the middle of the bridge x = y = 0.
///
/// Voussoirs have stepped backs, as masons cut them where walls stand on them: each ends in a level bed and an
/// upright face. A step is at least 0.6 courses high; near the crown several voussoirs share a level, and are
/// higher by at most that than the thickness asked for. Courses of walls, backing and fill lie between these beds,
/// so that all their stones are boxes. Those of different arches do not meet: over the pier between them what
/// stands there has an upright joint, up to the highest backs of all arches; the courses above run through.
/// @throws InputError with every parameter that makes no bridge
Pattern bridge(const Bridge& bridge);

}  // namespace voussoir::importers::patterns
