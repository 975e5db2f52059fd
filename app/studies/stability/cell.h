// A cell of the failure map: one scene at one setting, what it is held to, and what it may cost.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/case/case_reader.h"

namespace voussoir::app::studies::stability
{

/// "contact stiffness", 1e8, "N/m".
struct CellParameter {
    std::string name;
    double value = 0;  // infinite: of a rigid block
    std::string unit;  // may be empty: ratios
};

/// What a cell's runs gave, as its own process tells it.
struct CellRun {
    double error = 0;       // by the cell's quantity
    std::string refusal;    // why there was no step at all; empty when there was
    std::string diagnosis;  // what the run said when it gave up; empty when it did not
    std::string warning;    // what a run that came to its end said of its own accuracy; empty when nothing
    std::string note;       // what else is worth knowing, one line
    std::int64_t steps = 0, step_cuts = 0, iterations = 0;  // of the judged run, not of what it is compared with
    double cpu_time = 0;                                    // s, of the judged run
    double energy_residual = 0;                             // unaccounted share of the energy, of the judged run
    double max_penetration = 0;                             // m
};

/// One cell.
struct StabilityCell {
    std::string name;  // as typed: sliding/k=1e+08/h=0.001
    std::string scene;
    std::vector<CellParameter> parameters;
    double time_step = 0;   // s
    std::string reference;  // what the error is measured against
    double tolerance = 0;   // of the error
    double budget = 0;      // s of processor time, with what it is compared with
    std::function<CellRun()> run;
};

/// A scene and its cells.
struct StabilityScene {
    std::string name;
    std::string title;      // A block slides on a base that moves
    std::string text;       // what it is, how the error is defined; for the page
    std::string quantity;   // largest distance / largest displacement
    std::string reference;  // of its cells, if they name no other
    double tolerance = 0;   // the same
    // A scene over contact stiffness and time step is a heat map; the others are lines of a table.
    bool over_stiffness_and_step = false;
    std::vector<StabilityCell> cells;
};

/// All scenes, the three heat maps first.
/// @param read reads the case files of scenes that are one
std::vector<StabilityScene> stability_scenes(const CaseReader& read);

/// "1e+08 N/m", "rigid".
std::string in_words(const CellParameter& parameter);

}  // namespace voussoir::app::studies::stability
