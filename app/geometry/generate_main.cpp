// voussoir-generate: meshes of masonry patterns, one named object per stone.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "importers/mesh/write_obj.h"
#include "importers/patterns/arch_bridge.h"
#include "libdda/errors.h"

namespace
{

void add_options(CLI::App& command, voussoir::ArchBridge& bridge)
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

/// The command with every parameter spelled out, so that a default that changes one day changes no mesh.
std::string command_line(const voussoir::ArchBridge& bridge, const std::filesystem::path& file)
{
    std::ostringstream line;
    line.precision(17);
    line << "voussoir-generate arch-bridge --span " << bridge.span << " --rise " << bridge.rise << " --voussoirs "
         << bridge.voussoirs << " --springing-thickness " << bridge.springing_thickness << " --crown-thickness "
         << bridge.crown_thickness << " --width " << bridge.width << " --abutment-length "
         << bridge.abutment_length << " --abutment-depth " << bridge.abutment_depth << " -o "
         << file.filename().string();
    return line.str();
}

void write(const voussoir::ArchBridge& bridge, const std::filesystem::path& file)
{
    const std::string text = voussoir::to_obj(
        voussoir::arch_bridge(bridge),
        {command_line(bridge, file), "Made by the program above (GPL-3.0-or-later); this mesh itself is CC0-1.0.",
         "Metres, z up, x along the span, springings at z = 0."});
    std::ofstream stream(file, std::ios::binary);
    stream << text << std::flush;
    if (!stream) throw voussoir::InputError(file.string(), "the file cannot be written", "choose another place");
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        CLI::App program("Meshes of masonry patterns, one named object per stone.", "voussoir-generate");
        program.require_subcommand(1);
        CLI::App* arch =
            program.add_subcommand("arch-bridge", "a segmental stone arch between two abutment blocks");
        voussoir::ArchBridge bridge;
        std::string file;
        add_options(*arch, bridge);
        arch->add_option("-o,--output", file, "OBJ file to write")->required();
        try {
            program.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return program.exit(error) == 0 ? 0 : 2;
        }
        write(bridge, file);
        return 0;
    } catch (const voussoir::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
