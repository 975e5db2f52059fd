// The map of sliding.
#include <fmt/format.h>

#include "app/studies/stability/axes.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"
#include "app/studies/stability/one_block.h"

namespace voussoir::app::studies::stability
{

StabilityScene sliding_scene()
{
    StabilityScene scene;
    scene.name = "sliding";
    scene.title = "A block slides on a base that moves";
    scene.quantity = "largest distance from the reference over all times / largest sliding";
    scene.text =
        "A stone of 1 x 1 x 0.1 m (200 kg, rigid) on a fixed base, friction coefficient 0.2, four contact points. "
        "The ground accelerates by one sine of 5 m/s2 and 3 s: the block slides, reverses and comes to rest. The "
        "reference is the same block on an elastic-frictional shear spring and a normal spring under each lower "
        "edge, integrated at a twentieth of the stiffest spring's time unit: a soft spring causes a lag, in the "
        "reference as well.";
    scene.reference = "block on elastic-frictional springs (ODE)";
    scene.tolerance = 0.02;
    scene.over_stiffness_and_step = true;
    for (const double k : contact_stiffnesses)
        for (const double h : time_steps)
            add_cell(scene, fmt::format("k={:.0e}", k), {{"contact stiffness", k, "N/m"}}, h,
                     [k, h] { return run_sliding(sliding_block(k), h); });
    return scene;
}

}  // namespace voussoir::app::studies::stability
