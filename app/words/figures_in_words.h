// Errors, time steps and lengths in words, the same in every table.
#pragma once

#include <string>

namespace voussoir::app::words
{

/// "0.13 %", "3.2e-06", "0"; errors of 0.1 % and more as per cent.
std::string error_in_words(double error);

/// "1 ms", "0.1 ms". @param time_step [s]
std::string step_in_words(double time_step);

/// "4.7 %", "0.0012 %", "100 %". @param share of 1
std::string percent_in_words(double share);

/// "12.3 mm", "1.23 m", "45 µm".
std::string length_in_words(double metres);

}  // namespace voussoir::app::words
