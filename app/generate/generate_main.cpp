// voussoir-generate: meshes of masonry patterns, one named object per stone.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "app/generate/generate_vaults.h"
#include "app/generate/generate_walls.h"
#include "importers/mesh/write_obj.h"
#include "importers/patterns/arch_bridge.h"
#include "importers/process/program_start.h"
#include "libdda/errors.h"

namespace patterns = voussoir::importers::patterns;
namespace mesh = voussoir::importers::mesh;
namespace generate = voussoir::app::generate;

namespace
{

void add_options(CLI::App& command, patterns::ArchBridge& bridge)
{
    command.add_option("--span", bridge.span, "between the intrados springings [m]")->capture_default_str();
    command.add_option("--rise", bridge.rise, "of the intrados [m]")->capture_default_str();
    command.add_option("--voussoirs", bridge.voussoirs, "number of voussoirs")->capture_default_str();
    command.add_option("--springing-thickness", bridge.springing_thickness, "of the arch at its ends [m]")
        ->capture_default_str();
    command.add_option("--crown-thickness", bridge.crown_thickness, "of the arch at its middle [m]")
        ->capture_default_str();
    command.add_option("--width", bridge.width, "of arch and abutments [m]")->capture_default_str();
    command.add_option("--abutment-length", bridge.abutment_length, "along the span [m]")->capture_default_str();
    command.add_option("--abutment-depth", bridge.abutment_depth, "below the springings [m]")
        ->capture_default_str();
}

/// The arch and the command that makes it again.
generate::GeneratedMesh make(const patterns::ArchBridge& bridge)
{
    std::ostringstream line;
    line.precision(17);
    line << "arch-bridge --span " << bridge.span << " --rise " << bridge.rise << " --voussoirs "
         << bridge.voussoirs << " --springing-thickness " << bridge.springing_thickness << " --crown-thickness "
         << bridge.crown_thickness << " --width " << bridge.width << " --abutment-length "
         << bridge.abutment_length << " --abutment-depth " << bridge.abutment_depth;
    return {patterns::arch_bridge(bridge), line.str(), "Metres, z up, x along the span, springings at z = 0."};
}

void write(const generate::GeneratedMesh& mesh, const std::filesystem::path& file)
{
    const std::string text = mesh::to_obj(
        mesh.surfaces, {"voussoir-generate " + mesh.command + " -o " + file.filename().string(),
                        "Made by the program above (GPL-3.0-or-later); this mesh itself is CC0-1.0.", mesh.axes});
    std::ofstream stream(file, std::ios::binary);
    stream << text << std::flush;
    if (!stream)
        throw voussoir::InputError(file.string(), "the file cannot be written", "choose another location");
}

}  // namespace

int main(int argc, char** argv)
{
    voussoir::importers::process::begin_program();
    try {
        CLI::App program("Meshes of masonry patterns, one named object per stone.", "voussoir-generate");
        program.require_subcommand(1);
        CLI::App* arch =
            program.add_subcommand("arch-bridge", "a segmental stone arch between two abutment blocks");
        patterns::ArchBridge bridge;
        add_options(*arch, bridge);
        CLI::App* wall = program.add_subcommand("wall", "a straight wall in running bond");
        const auto wall_command = generate::add_wall_options(*wall);
        CLI::App* house = program.add_subcommand("house", "four walls with bonded corners, openings and lintels");
        const auto house_command = generate::add_house_options(*house);
        CLI::App* dome = program.add_subcommand("dome", "a spherical dome of courses, with supports");
        const auto dome_command = generate::add_dome_options(*dome);
        CLI::App* barrel = program.add_subcommand("barrel-vault", "a vault over a circular arc, with supports");
        const auto barrel_command = generate::add_barrel_vault_options(*barrel);
        CLI::App* cross = program.add_subcommand("cross-vault", "two barrel vaults that cross, with supports");
        const auto cross_command = generate::add_cross_vault_options(*cross);
        std::string file;
        for (CLI::App* command : {arch, wall, house, dome, barrel, cross})
            command->add_option("-o,--output", file, "OBJ file to write")->required();
        try {
            program.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return program.exit(error) == 0 ? 0 : 2;
        }
        if (arch->parsed()) write(make(bridge), file);
        for (const auto& [command, pattern] : {std::pair{wall, wall_command.get()},
                                               {house, house_command.get()},
                                               {dome, dome_command.get()},
                                               {barrel, barrel_command.get()},
                                               {cross, cross_command.get()}})
            if (command->parsed()) write(pattern->make(), file);
        return 0;
    } catch (const voussoir::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
