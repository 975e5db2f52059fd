// What every program does first, whoever started it, and how.
#pragma once

#include <csignal>

namespace voussoir::importers::process
{

/// The descriptors 0 to 2 exist from now on: without them the first file that is opened would be the standard
/// output, and messages would be written into it. One that was closed takes nothing and says nothing.
/// Ends the program with a sentence and exit code 1 where the stack is too small to work on.
void begin_program();

/// The same for a helper that another program started: it ends, with SIGTERM, when that program does, be it
/// killed.
void begin_helper();

/// Was the standard output closed when the program began?
bool had_no_output();

/// "PROGRAM: what happened" on the standard error, as a terminal may be shown it.
void complain(const char* program, const char* what);

/// As long as it lives, want of memory ends the program at once, with a sentence and exit code 1, and throws
/// nothing: for code that cannot be unwound. Braced lists of nlohmann-json cannot: g++ 12 destroys elements that
/// were not made.
class EndsWithoutMemory
{
 public:
    EndsWithoutMemory();
    ~EndsWithoutMemory();
    EndsWithoutMemory(const EndsWithoutMemory&) = delete;
    EndsWithoutMemory& operator=(const EndsWithoutMemory&) = delete;
};

/// Holds back the signals that end a program, as long as it lives, so that a file is not left half written.
class SignalsHeld
{
 public:
    SignalsHeld();
    ~SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
    sigset_t before_{};
};

}  // namespace voussoir::importers::process
