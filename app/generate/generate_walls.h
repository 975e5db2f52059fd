// The sub-commands `wall` and `house` of voussoir-generate.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"

namespace CLI
{
class App;
}

namespace voussoir::app::generate
{

/// What a sub-command makes.
struct GeneratedMesh {
    std::vector<importers::mesh::PolygonSurface> surfaces;
    std::string
        command;       // with every parameter spelled out, so that a default that changes one day changes no mesh
    std::string axes;  // "Metres, z up, ..."
};

/// A pattern whose parameters were, or will be, read from the command line.
class PatternCommand
{
 public:
    virtual ~PatternCommand() = default;
    /// @throws InputError with every parameter that makes no such thing
    virtual GeneratedMesh make() const = 0;
};

/// Adds the options of a wall, of a house to a sub-command. What is returned must outlive the parsing.
std::unique_ptr<PatternCommand> add_wall_options(CLI::App& command);
std::unique_ptr<PatternCommand> add_house_options(CLI::App& command);

}  // namespace voussoir::app::generate
