#include "app/commands/say.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "importers/process/program_start.h"
#include "libdda/text/printable.h"

namespace voussoir::app::commands
{
namespace
{

int first_error = 0;  // of standard output, an errno

void note_error()
{
    if (first_error == 0) first_error = errno != 0 ? errno : EIO;
}

void put(const std::string& text, std::FILE* stream)
{
    errno = 0;
    const bool whole = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
    if (!whole && stream == stdout) note_error();
}

}  // namespace

void say(std::string_view line)
{
    put(text::printable(line) + "\n", stdout);
}

void say_part(std::string_view text)
{
    put(text::printable(text), stdout);
}

void say_lines(std::string_view text)
{
    put(text::printable_lines(text), stdout);
}

void say_over(std::string_view line, bool to_errors)
{
    std::FILE* const stream = to_errors ? stderr : stdout;
    put("\r\033[K" + text::printable(line), stream);
    std::fflush(stream);
}

void complain(std::string_view line)
{
    put(text::printable(line) + "\n", stderr);
}

void complain(const InputError& error)
{
    for (const Fault& fault : error.faults) complain(to_sentence(fault));
}

void put_json(std::string_view json)
{
    if (importers::process::had_no_output())
        throw InputError("--json -", "standard output is closed", "open it, or name a file");
    put(text::printable_json(json) + "\n", stdout);
}

std::string unsaid()
{
    errno = 0;
    const bool flushed = std::fflush(stdout) == 0;
    if (!flushed || std::ferror(stdout) != 0) note_error();
    return first_error == 0 || first_error == EPIPE ? "" : std::generic_category().message(first_error);
}

}  // namespace voussoir::app::commands
