#include "importers/process/program_start.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>

#include "libdda/text/printable.h"

namespace voussoir::importers::process
{

namespace
{

constexpr rlim_t least_stack = rlim_t{1} << 20;  // bytes; the readers and the libraries want about a quarter of it

bool no_output = false;

std::atomic<bool> memory_ran_out{false};
std::atomic<int> places_that_cannot_throw{0};

/// Where memory runs out in a place that cannot throw, in a library or before main, the program would crash.
[[noreturn]] void end_for_want_of_memory()
{
    if (!memory_ran_out) std::abort();  // our own mistake
    const char* const name = program_invocation_short_name;
    for (const char* words : {name, ": out of memory; it ended at once\n"})
        static_cast<void>(write(STDERR_FILENO, words, std::strlen(words)) + 1);
    _exit(1);
}

[[noreturn]] void note_want_of_memory()
{
    memory_ran_out = true;
    if (places_that_cannot_throw > 0) end_for_want_of_memory();
    throw std::bad_alloc();
}

/// Before the objects of other files are made, which need memory too.
__attribute__((constructor(101))) void expect_want_of_memory()
{
    std::set_new_handler(note_want_of_memory);
    std::set_terminate(end_for_want_of_memory);
}

bool is_open(int descriptor)
{
    return fcntl(descriptor, F_GETFD) != -1 || errno != EBADF;
}

void open_standard_descriptors()
{
    no_output = !is_open(STDOUT_FILENO);
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (is_open(descriptor)) continue;
        // The lowest that is free: this one.
        const int made = open("/dev/null", descriptor == STDIN_FILENO ? O_RDONLY : O_WRONLY);
        if (made != descriptor) _exit(1);  // nothing can be said
    }
}

/// Raising the limit here would be too late for the threads that libraries have made, and are to make.
void require_stack()
{
    rlimit stack{};
    if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= least_stack) return;
    std::fprintf(stderr, "voussoir: the stack is limited to %llu KiB; at least %llu are needed: ulimit -s 8192\n",
                 static_cast<unsigned long long>(stack.rlim_cur >> 10),
                 static_cast<unsigned long long>(least_stack >> 10));
    std::exit(1);
}

}  // namespace

void begin_program()
{
    open_standard_descriptors();
    require_stack();
}

void begin_helper()
{
    begin_program();
    // A request that breaks off, or that memory does not hold, is none.
    std::cin.exceptions(std::ios::badbit);
    // Who asks does so through a socket that it made. Started by hand there is none, and nobody to follow.
    ucred asking{};
    socklen_t size = sizeof asking;
    if (getsockopt(STDIN_FILENO, SOL_SOCKET, SO_PEERCRED, &asking, &size) != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != asking.pid) std::exit(1);  // it has ended before it could be followed
}

bool had_no_output()
{
    return no_output;
}

void complain(const char* program, const char* what)
{
    std::fprintf(stderr, "%s: %s\n", program, text::printable_lines(what).c_str());
}

EndsWithoutMemory::EndsWithoutMemory()
{
    ++places_that_cannot_throw;
}

EndsWithoutMemory::~EndsWithoutMemory()
{
    --places_that_cannot_throw;
}

SignalsHeld::SignalsHeld()
{
    sigset_t ending{};
    sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, signal);
    pthread_sigmask(SIG_BLOCK, &ending, &before_);
}

SignalsHeld::~SignalsHeld()
{
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace voussoir::importers::process
