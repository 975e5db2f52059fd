// The scenes of the failure map, one family a file. To add one: its line here, its line in cell.cpp, its source in
// CMakeLists.txt.
#pragma once

#include <vector>

#include "app/studies/stability/cell.h"

namespace voussoir::app::studies::stability
{

StabilityScene sliding_scene();  // a block on an elastic-frictional spring, over stiffness and time step
StabilityScene rocking_scene();  // a block on the springs under its edges, over stiffness and time step
StabilityScene wall_scene();     // 50 blocks, over stiffness and time step

StabilityScene modulus_scene();
StabilityScene column_scene();
StabilityScene density_scene();
StabilityScene size_scene();
StabilityScene shape_scene();

StabilityScene needle_scene();  // a stone stands on points
StabilityScene point_scene();   // vertex on vertex, edge on edge

StabilityScene face_scene();  // joints with points inside their faces

StabilityScene fit_scene();  // a column that does not fit as drawn

StabilityScene friction_scene();
StabilityScene coordinate_scene(const CaseReader& read);
StabilityScene gravity_scene();
StabilityScene shaking_scene();
StabilityScene impact_scene();
StabilityScene uplift_scene();      // a pulse lifts a block off soft springs
StabilityScene step_error_scene();  // steps that follow their error
StabilityScene landing_scene();     // a rocking block comes down

StabilityScene ground_scene();  // waves through boundaries, damped ground

StabilityScene bar_scene();  // rods and dowels

StabilityScene verdict_scene();  // at rest, on both sides of a limit

StabilityScene many_scene();  // 1,000 blocks stand
StabilityScene heap_scene();  // hundreds fall

}  // namespace voussoir::app::studies::stability
