// What must hold of every record that a reader accepts, whatever the file: asked by the fuzzer and by the test of
// damaged files.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "libdda/errors.h"
#include "records/record.h"

namespace voussoir
{

inline void require(bool holds, const std::string& what)
{
    if (!holds) throw std::logic_error("an accepted record " + what);
}

inline void check_accepted_channel(const records::Channel& channel)
{
    require(channel.samples.size() >= 2, "has a channel of fewer than 2 samples");
    for (const double sample : channel.samples) require(std::isfinite(sample), "has a sample that is not finite");
    if (channel.times.empty()) {
        require(std::isfinite(channel.time_step) && channel.time_step > 0, "has no time step");
    } else {
        require(channel.times.size() == channel.samples.size(), "has another number of times than of samples");
        for (std::size_t i = 1; i < channel.times.size(); ++i)
            require(channel.times[i] > channel.times[i - 1], "goes back in time");
    }
    require(std::isfinite(records::peak(channel)), "has no peak");
    const records::Channel even = records::resampled_evenly(channel);
    require(even.times.empty() && even.time_step > 0, "stays uneven");
    require(even.samples.size() <= 11 * channel.samples.size(), "swells when resampled");
    for (const double sample : even.samples) require(std::isfinite(sample), "is not finite when resampled");
    try {
        const GroundMotion motion = records::to_ground_motion(channel, "a record");
        require(std::isfinite(motion.displacement(motion.duration() / 3)), "moves the ground to infinity");
    } catch (const InputError&) {  // without a unit, or so large that its integral overflows: refused in words
    }
}

/// @throws std::logic_error that says what does not hold
inline void check_accepted(const records::Record& record)
{
    require(!record.channels.empty(), "has no channel");
    require(!record.format.empty(), "has no format");
    for (const records::Channel& channel : record.channels) check_accepted_channel(channel);
}

}  // namespace voussoir
