#include "app/commands/interrupt.h"

#include <csignal>

namespace voussoir
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
}

bool interrupted()
{
    return signal_came != 0;
}

}  // namespace voussoir
