// The map of rocking, and what soft springs make of an uplift.
#include <fmt/format.h>

#include "app/studies/stability/axes.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"
#include "app/studies/stability/one_block.h"

namespace voussoir::app::studies::stability
{

namespace
{

/// A pier of 600 kg let go while it leans on an edge.
OneBlock leaning_pier(double stiffness)
{
    OneBlock scene;
    scene.length = 1;
    scene.width = 0.1;
    scene.height = 3;
    scene.friction = 1.5;
    scene.stiffness = stiffness;
    scene.pulse_end = 0;
    scene.start_lean = 0.2;
    return scene;
}

/// A pier of 1200 kg under a half sine of ground acceleration that lifts its edge.
OneBlock lifted_pier(double stiffness, Integrator integrator)
{
    OneBlock scene;
    scene.width = 0.2;
    scene.height = 3;
    scene.friction = 1.5;
    scene.stiffness = stiffness;
    scene.amplitude = 5;
    scene.period = 1;
    scene.pulse_end = 0.5;
    scene.integrator = integrator;
    return scene;
}

}  // namespace

StabilityScene rocking_scene()
{
    StabilityScene scene;
    scene.name = "rocking";
    scene.title = "A block rocks on its edges";
    scene.quantity = "largest distance from the reference over all times / largest lean";
    scene.text =
        "A pier of 1 x 0.1 x 3 m (600 kg, rigid) on a fixed base, friction coefficient 1.5, four contact points, "
        "is released at a rotation of 0.2 rad about an edge, and swings back until a twentieth of that is left; "
        "on the softest springs it overturns, and is followed to 0.5 rad. The reference is the same block on the "
        "springs under its two lower edges. The impact of the edge is treated in the scene `landing`, and the "
        "uplift of a block by soft springs in `uplift`.";
    scene.reference = "block on the springs under its edges (ODE)";
    scene.tolerance = 0.02;
    scene.over_stiffness_and_step = true;
    for (const double k : contact_stiffnesses)
        for (const double h : time_steps)
            add_cell(scene, fmt::format("k={:.0e}", k), {{"contact stiffness", k, "N/m"}}, h,
                     [k, h] { return run_swing(leaning_pier(k), h); });
    return scene;
}

StabilityScene uplift_scene()
{
    StabilityScene scene;
    scene.name = "uplift";
    scene.title = "A pier is lifted off its edge by a pulse";
    scene.quantity = "largest distance from the reference over all times / largest lean";
    scene.text =
        "A pier of 1 x 0.2 x 3 m (1200 kg, rigid), friction coefficient 1.5, under a half sine of ground "
        "acceleration of 5 m/s2 and 0.5 s, from rest until it has returned. The reference is the block on "
        "springs. Where the springs are so soft that their stored energy throws the block up, the motion depends "
        "on the damping of their vibration by the integrator: omega h / 4 of critical damping by Newmark's (the "
        "default), a tenth of that by the energy-decaying one.";
    scene.reference = "block on the springs under its edges (ODE)";
    scene.tolerance = 0.02;
    for (const Integrator integrator : {Integrator::newmark, Integrator::energy_decaying})
        for (const double k : {1e5, 1e6, 1e7, 1e8, 1e10, 1e12})
            for (const double h : {1e-3, 1e-2}) {
                const char* name = integrator == Integrator::newmark ? "newmark" : "energy_decaying";
                add_cell(scene, fmt::format("{}-k={:.0e}", name, k), {{name, k, "N/m"}}, h,
                         [=] { return run_swing(lifted_pier(k, integrator), h); });
            }
    return scene;
}

StabilityScene step_error_scene()
{
    StabilityScene scene;
    scene.name = "step_error";
    scene.title = "A block rocks in steps that follow their error";
    scene.quantity = "largest distance from the reference over all times / largest lean";
    scene.text =
        "The pier of `rocking` on springs of 1e8 N/m, whose steps are at most as long as the time step and "
        "err by at most the wanted error. Errors too large to be noticed leave the time step alone; errors "
        "smaller than the springs yield make the steps follow the vibration on them.";
    scene.reference = "block on the springs under its edges (ODE)";
    scene.tolerance = 0.02;
    for (const double error : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3})
        for (const double h : {2e-3, 1e-2, 5e-2})
            add_cell(scene, fmt::format("e={:.0e}", error), {{"error of a step", error, "m"}}, h, [error, h] {
                OneBlock pier = leaning_pier(1e8);
                pier.step_error = error;
                return run_swing(pier, h);
            });
    return scene;
}

}  // namespace voussoir::app::studies::stability
