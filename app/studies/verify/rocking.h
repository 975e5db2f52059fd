// Blocks that rock on a base which shakes for half a sine.
#pragma once

#include <functional>
#include <vector>

#include "app/studies/verify/references/rocking.h"
#include "app/studies/verify/run_scene.h"

namespace voussoir::app::studies::verify
{

/// The block of a reference, 1 m thick, and what a reference of rigid blocks that do not slide leaves open.
struct RockingCase {
    references::RockingBlock block;       // the amplitude 0: it is left to itself
    double density = 2500, young = 1e12;  // kg/m3, Pa
    double friction = 60;                 // degrees
    ContactStiffness stiffness{};         // by the rule of the setting, unless given
    double relaxation_time = 0;           // s, of the joint
};

/// A block at rest on a base that then shakes along x, away from +x first. Stages: rest, motion.
scenes::StagedScene rocking_scene(const scenes::SceneSetting& setting, const RockingCase& rocking,
                                  double duration);

/// Lean at the end of every step, relative to the rest before the motion.
struct LeanRecord {
    std::vector<double> times, angles;  // s, rad
};

/// Runs the scene and adds its cost to `result`. @param stop after which step to end the run; empty: at its end
LeanRecord watch_rocking(const scenes::SceneSetting& setting, const RockingCase& rocking, double duration,
                         VerifyResult& result, const std::function<bool(double time, double lean)>& stop = {});

/// Largest difference up to `end` [s] over the largest angle up to there.
double lean_difference(const LeanRecord& record, const std::vector<double>& exact, double end);

plots::Diagram lean_picture(const LeanRecord& record, const std::vector<double>& exact);

/// Largest |angle| of each swing that begins or goes on after a time [s]: apexes of free rocking [rad].
std::vector<double> apexes_after(const LeanRecord& record, double time);

}  // namespace voussoir::app::studies::verify
