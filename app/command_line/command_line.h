// The commands of the program and their options.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace voussoir::app::command_line
{

/// Adds --set, repeatable; it takes one value each time, so that what follows it is not swallowed.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);

/// Adds commands to the program; the one that is called for becomes `chosen`, which runs it and returns the exit
/// code. What makes and runs cases: run, check, import, generate, record.
void add_case_commands(CLI::App& program, std::function<int()>& chosen);
/// What shows results: render, report, compare.
void add_picture_commands(CLI::App& program, std::function<int()>& chosen);
/// What runs cases or scenes many times, or asks for their limit: verify, limit, converge, ensemble, stability.
void add_study_commands(CLI::App& program, std::function<int()>& chosen);

}  // namespace voussoir::app::command_line
