// What `voussoir converge` writes: the table, the page, the JSON, the diagrams.
#pragma once

#include <string>
#include <vector>

#include "app/plots/diagram.h"
#include "app/studies/converge/study.h"

namespace voussoir::app::studies::converge
{

/// The tables of all quantities and what they say, for a terminal.
std::string converge_table(const ConvergeStudy& study);

/// converge.md.
/// @param command how the page was made, written at its head
/// @param figures names of the quantities' diagrams, `converge/NAME.png` beside the page; empty when none were
/// drawn
std::string converge_page(const ConvergeStudy& study, const std::string& command,
                          const std::vector<std::string>& figures);

/// See docs/converge.md for the fields; what does not exist is null.
std::string converge_json(const ConvergeStudy& study);

/// One figure a quantity: error against time step, against CPU time and against contact stiffness. A name is that
/// of the quantity in letters that every file system takes, with a number before it.
std::vector<plots::Figure> converge_figures(const ConvergeStudy& study);

}  // namespace voussoir::app::studies::converge
