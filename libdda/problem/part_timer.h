// Books the time that a part of the computation takes.
#pragma once

#include <array>
#include <chrono>

#include "libdda/model/report.h"

namespace voussoir::step
{

/// Adds the seconds of its own life to those of a part.
class PartTimer
{
 public:
    /// @param seconds of a StepReport or a RunReport, which lives longer than the timer
    PartTimer(std::array<double, static_cast<int>(Part::count)>& seconds, Part part)
        : seconds_(seconds[static_cast<int>(part)])
    {
    }
    PartTimer(const PartTimer&) = delete;
    PartTimer& operator=(const PartTimer&) = delete;
    ~PartTimer() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace voussoir::step
