// Ctrl-C, the job scheduler's termination, the terminal's end: the step under way is finished and the files are
// closed.
#pragma once

namespace voussoir::app::commands
{

/// From now on the first SIGINT, SIGTERM or SIGHUP only sets the flag; a second one ends the program at once.
void catch_interrupts();

/// Has a signal come?
bool interrupted();

}  // namespace voussoir::app::commands
