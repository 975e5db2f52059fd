// Errors and time steps in words, the same in every table.
#pragma once

#include <string>

namespace voussoir::app::words
{

/// "0.13 %", "3.2e-06", "0"; errors of 0.1 % and more as per cent.
std::string error_in_words(double error);

/// "1 ms", "0.1 ms". @param time_step [s]
std::string step_in_words(double time_step);

}  // namespace voussoir::app::words
