// The sub-commands `dome`, `barrel-vault` and `cross-vault` of voussoir-generate.
#pragma once

#include <memory>

#include "app/generate/generate_walls.h"

namespace voussoir::app::generate
{

/// Adds the options of a pattern to a sub-command. What is returned must outlive the parsing.
std::unique_ptr<PatternCommand> add_dome_options(CLI::App& command);
std::unique_ptr<PatternCommand> add_barrel_vault_options(CLI::App& command);
std::unique_ptr<PatternCommand> add_cross_vault_options(CLI::App& command);

}  // namespace voussoir::app::generate
