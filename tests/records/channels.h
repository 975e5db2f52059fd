// Channels made in one line of a test.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "records/record.h"
#include "records/synthetic/noise.h"

namespace voussoir::records
{

inline Channel of_samples(std::vector<double> samples, double time_step, const std::string& component = "x")
{
    Channel channel;
    channel.component = component;
    channel.time_step = time_step;
    channel.samples = std::move(samples);
    channel.unit_in_file = "m/s2";
    return channel;
}

inline Channel sampled(const std::function<double(double)>& acceleration, double time_step, std::size_t count)
{
    std::vector<double> samples(count);
    for (std::size_t i = 0; i < count; ++i) samples[i] = acceleration(static_cast<double>(i) * time_step);
    return of_samples(std::move(samples), time_step);
}

/// Normal numbers that rise and fall like an earthquake.
inline Channel noise(std::size_t count, double time_step, std::uint64_t seed, const std::string& component = "x")
{
    synthetic::SplitMix64 random(seed);
    std::vector<double> samples(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(count - 1);
        samples[i] = 10 * x * (1 - x) * (1 - x) * random.normal();
    }
    return of_samples(std::move(samples), time_step, component);
}

}  // namespace voussoir::records
