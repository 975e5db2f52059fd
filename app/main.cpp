// voussoir: what an earthquake does to stone structures, block by block. The command line and the exit codes.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "app/command_line/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/say.h"
#include "app/version/version.h"
#include "app/words/nearest_word.h"
#include "importers/process/program_start.h"
#include "libdda/errors.h"

namespace
{

using namespace voussoir;

/// Runs the chosen command; what it throws becomes a message and an exit code.
int guarded(const std::function<int()>& command)
{
    try {
        return command();
    } catch (const InputError& error) {
        app::commands::complain(error);
        return app::commands::exit_bad_input;
    } catch (const std::filesystem::filesystem_error& error) {
        app::commands::complain(error.path1().string() + ": " + error.code().message() + "; name another one");
        return app::commands::exit_bad_input;
    } catch (const std::bad_alloc&) {
        app::commands::complain("voussoir: out of memory");
    } catch (const std::exception& error) {
        app::commands::complain(std::string("voussoir: ") + error.what());
    }
    return app::commands::exit_failure;
}

/// What the command line asks for by itself, --help, or is wrong with it. @returns the exit code
int answer(const CLI::App& program, const CLI::ParseError& error)
{
    std::ostringstream text, faults;
    const bool done = program.exit(error, text, faults) == 0;
    app::commands::say_lines(text.str());
    // Of two lines: the fault, with what was typed, and where help is.
    std::string fault = faults.str();
    if (!fault.empty() && fault.back() == '\n') fault.pop_back();
    const std::size_t help = std::min(fault.rfind('\n'), fault.size());
    for (const std::string& line : {fault.substr(0, help), fault.substr(std::min(help + 1, fault.size()))})
        if (!line.empty()) app::commands::complain(line);
    return done ? app::commands::exit_done : app::commands::exit_bad_input;
}

/// Nobody asks for words that nobody can read: a run of the program that lost some of them has failed.
int heard(int code)
{
    const std::string reason = app::commands::unsaid();
    if (reason.empty()) return code;
    app::commands::complain("standard output: cannot be written: " + reason +
                            "; what it should have said is lost");
    return code == app::commands::exit_done ? app::commands::exit_failure : code;
}

/// A word where the command should be that is none: --help after it would be taken for that of the program.
/// @throws InputError
void refuse_unknown_command(const CLI::App& program, int argument_count, char** arguments)
{
    const auto is_word = [](const char* argument) { return *argument != '-'; };
    char** const word = std::find_if(arguments + 1, arguments + argument_count, is_word);
    if (word == arguments + argument_count) return;
    std::vector<std::string> commands;
    for (const CLI::App* command : program.get_subcommands({})) commands.push_back(command->get_name());
    if (std::find(commands.begin(), commands.end(), *word) != commands.end()) return;
    throw InputError("voussoir", "no command \"" + std::string(*word) + "\"",
                     app::words::suggestion(*word, commands));
}

int run_program(int argument_count, char** arguments)
{
    CLI::App program{
        "Seismic analysis of stone structures, block by block (3D discontinuous deformation analysis)",
        "voussoir"};
    program.set_version_flag("--version", "voussoir " + app::version::in_words(app::version::engine_version()));
    program.require_subcommand(1);
    program.footer(
        "Exit codes: 0 done, 1 failure, 2 bad input, 3 the analysis failed to converge, 4 interrupted, 5 of run: "
        "the structure\n"
        "does not stand, or it is undecided whether it does.");
    std::function<int()> chosen;
    app::command_line::add_case_commands(program, chosen);
    app::command_line::add_picture_commands(program, chosen);
    app::command_line::add_study_commands(program, chosen);
    try {
        refuse_unknown_command(program, argument_count, arguments);
        program.parse(argument_count, arguments);
    } catch (const InputError& error) {
        app::commands::complain(error);
        return app::commands::exit_bad_input;
    } catch (const CLI::ParseError& error) {
        return heard(answer(program, error));
    }
    return heard(guarded(chosen));
}

}  // namespace

int main(int argument_count, char** arguments)
{
    std::signal(SIGPIPE, SIG_IGN);  // what was asked for is done, though the reader of the words has had enough
    importers::process::begin_program();
    try {
        return run_program(argument_count, arguments);
    } catch (...) {  // even the message could not be made
        std::fputs("voussoir: out of memory\n", stderr);
        return app::commands::exit_failure;
    }
}
