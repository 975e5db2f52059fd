// How long a command took.
#pragma once

#include <chrono>
#include <string>

namespace voussoir::app::commands
{

/// Wall time since it was made, and CPU time of the whole process and of the helpers that have ended.
class Stopwatch
{
 public:
    double wall_time() const;  // s
    static double cpu_time();  // s

 private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "45 s", "3 min 20 s", "2 h 5 min".
std::string duration_in_words(double seconds);

}  // namespace voussoir::app::commands
