#include <algorithm>
#include <string>

#include "app/commands/commands.h"
#include "app/commands/explicit_case.h"
#include "app/commands/outputs.h"
#include "app/commands/say.h"
#include "app/reader/case_file.h"
#include "importers/mesh/write_obj.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

/// A case with a pattern as its only entry.
std::string pattern_text(const GenerateArguments& arguments, bool holds_foundation)
{
    std::string keys;
    for (const std::string& key : arguments.keys) {
        const std::size_t equals = key.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError(key, "no key=value", "give keys as in a case: span=\"10 m\"");
        keys += (keys.empty() ? "" : ", ") + key.substr(0, equals) + ": " + key.substr(equals + 1);
    }
    return "title: " + arguments.what +
           "\nmaterials: {stone: {density: 2400 kg/m3, young: 10 GPa, poisson: 0.2}}\n"
           "joints: {dry: {friction: 35 deg}}\nblocks:\n  - {" +
           arguments.what + ": {" + keys + "}}\n" +
           (holds_foundation ? "foundation: {blocks: foundation}\n" : "") +
           "stages: [{name: self-weight, type: static}]\noutput: {every: 20 ms}\n";
}

bool has_group(const Model& model, const std::string& name)
{
    return std::find(model.groups.begin(), model.groups.end(), name) != model.groups.end();
}

Case read(const GenerateArguments& arguments)
{
    const bool is_file = arguments.what.ends_with(".yaml") || arguments.what.ends_with(".yml");
    if (is_file && arguments.keys.empty()) return reader::read_case(arguments.what, {});
    if (is_file) throw InputError(arguments.keys.front(), "a key beside a case file", "write it into the case");
    const Case free = reader::read_case_text(arguments.what, pattern_text(arguments, false), {});
    if (!has_group(free.model, "foundation")) return free;
    return reader::read_case_text(arguments.what, pattern_text(arguments, true), {});
}

}  // namespace

int generate_command(const GenerateArguments& arguments)
{
    const std::string kind = arguments.output.extension().string();
    if (kind != ".obj" && kind != ".yaml")
        throw InputError(arguments.output.string(), "neither .obj nor .yaml",
                         "give the file one of these endings");
    const Case the_case = read(arguments);
    std::string command = "voussoir generate " + arguments.what;
    for (const std::string& key : arguments.keys) command += " '" + key + "'";
    const std::string text = kind == ".yaml" ? "# Written by " + command + "\n" + explicit_case(the_case)
                                             : importers::mesh::to_obj(surfaces_of(the_case.model),
                                                                       {"Written by " + command, "Metres, z up."});
    write_named_file(arguments.output, text);
    say(std::to_string(the_case.model.blocks.size()) + " blocks written to " + arguments.output.string());
    return exit_done;
}

}  // namespace voussoir::app::commands
