// A helper program: text in, text out, under a time limit.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace voussoir::importers::process
{

/// How a child process ended.
struct ChildAnswer {
    std::string output;   // what the child wrote to its standard output
    std::string failure;  // why it gave no answer, in words; empty when it ended with exit code 0
    bool out_of_time =
        false;  // that is why: of the wall time it was given, or of the processor time it took itself
};

/// Starts `program`, writes `input` to it, reads until it ends; kills it after `seconds` of wall time, or when it
/// writes more than `max_output` bytes. Never throws for what the child does.
/// @param on_line is told each line of the output as it comes
ChildAnswer ask_child(const std::filesystem::path& program, const std::string& input, double seconds,
                      std::size_t max_output, const std::function<void(const std::string& line)>& on_line = {});

/// Where the helpers are: in libexec/voussoir of an installed `voussoir`, else beside the running program; the
/// environment's VOUSSOIR_BIN_DIR overrides both.
std::filesystem::path helper_folder();

}  // namespace voussoir::importers::process
