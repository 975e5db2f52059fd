#include "app/commands/interrupt.h"

#include <csignal>

namespace voussoir::app::commands
{
namespace
{

volatile std::sig_atomic_t signal_came = 0;

void note_signal(int)
{
    signal_came = 1;
}

}  // namespace

void catch_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = note_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESETHAND | SA_RESTART;  // the second one is not caught
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    struct sigaction before = {};
    sigaction(SIGHUP, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // nohup ignores it
    std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error of writing, which is told
    std::signal(SIGPIPE, SIG_IGN);  // a run outlives the reader of its messages
}

bool interrupted()
{
    return signal_came != 0;
}

}  // namespace voussoir::app::commands
