// What converge varies: the time step, the contact stiffness and, if asked, the integrator.
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"

namespace voussoir::app::studies::converge
{

struct ConvergeSetting {
    Integrator integrator = Integrator::newmark;  // of the dynamic stages
    double step_factor = 1;                       // times the time step of every dynamic stage
    double stiffness_factor = 1;                  // times the contact stiffness of every joint

    bool operator==(const ConvergeSetting&) const = default;
};

/// The series to run. Factors fall in step and rise in stiffness, so that each run is finer than the one before.
struct ConvergePlan {
    std::vector<Integrator> integrators;    // a series of time steps for each; the first is the case's own
    std::vector<double> step_factors;       // falling
    std::vector<double> stiffness_factors;  // rising
    std::vector<std::string> notes;         // what is left out of the default, and why
    bool compares = true;                   // else one setting will do: a threshold is a result of its own
};

/// What the command line says of them; empty is the default: for a threshold fewer, since each takes many runs.
struct ConvergeChoices {
    std::vector<std::string> time_steps;    // "4 ms": of the first dynamic stage, the others keep their proportion
    std::vector<double> stiffness_factors;  // times the case's own
    std::vector<std::string> integrators;  // newmark, energy_decaying; by default the latter beside the case's own
    bool of_threshold = false;
};

/// The first dynamic stage: its time step and integrator name the runs.
/// @throws InputError when the case has none: static stages have no time step to vary
const Stage& first_dynamic_stage(const Case& the_case);

/// The same, or the first stage of a case that has no dynamic one.
const Stage& leading_stage(const Case& the_case);

/// @throws InputError with every value that is not a time, not positive, given twice, or a time step that a
/// dynamic stage cannot be run with: longer than the stage, or below its min_time_step. A case without a dynamic
/// stage has thresholds, over contact stiffnesses, and nothing else to compare
ConvergePlan plan_of(const ConvergeChoices& choices, const Case& the_case);

/// The `step_error` [m] with which steps that follow it change by a factor, as all others do: a step's error goes
/// with its third power.
double scaled_step_error(double step_error, double step_factor);

/// The case with a setting put in.
Case with_setting(const Case& the_case, const ConvergeSetting& setting);

}  // namespace voussoir::app::studies::converge
