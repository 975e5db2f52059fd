// The displacement that a sampled ground motion means, by sums of our own in extended precision: the reference of
// the tests that move foundations. Nothing here marches from sample to sample as GroundMotion does.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "records/record.h"

namespace voussoir::verification
{

/// Displacement at any time of a motion whose samples are joined by straight lines (acceleration, velocity) or by
/// cubics whose slopes are central differences (displacement).
///
/// With M0(T) and M1(T) the integrals of f(s) and s f(s) from 0 to T, the second integral of f is T M0 - M1.
class ExactIntegral
{
 public:
    /// @param samples [m/s2, m/s or m]; @param time_step [s]
    ExactIntegral(records::Quantity quantity, const std::vector<double>& samples, double time_step)
        : quantity_(quantity), samples_(samples.begin(), samples.end()), step_(time_step)
    {
        zeroth_.push_back(0);
        first_.push_back(0);
        for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
            zeroth_.push_back(zeroth_[i] + zeroth_moment(i, step_));
            first_.push_back(first_[i] + first_moment(i, step_));
        }
    }

    /// [m] at time [s] >= 0; after the last sample the motion goes on at its last velocity, or stays if it was
    /// given as displacement, which the tests that use this do not outlast.
    double displacement(double time) const
    {
        const auto last = samples_.size() - 1;
        const long double end = static_cast<long double>(last) * step_;
        const long double t = std::min<long double>(time, end);
        const std::size_t i = std::min(static_cast<std::size_t>(t / step_), last - 1);
        const long double since = t - static_cast<long double>(i) * step_;
        if (quantity_ == records::Quantity::displacement) return static_cast<double>(cubic(i, since / step_));
        const long double zeroth = zeroth_[i] + zeroth_moment(i, since);
        const long double rest = time - t;  // after the end
        if (quantity_ == records::Quantity::velocity) return static_cast<double>(zeroth + rest * samples_.back());
        const long double first = first_[i] + first_moment(i, since);
        return static_cast<double>(time * zeroth - first);
    }

    /// Largest |displacement| at the samples' times [m].
    double peak_displacement() const
    {
        double largest = 0;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const auto time = static_cast<double>(static_cast<long double>(i) * step_);
            largest = std::max(largest, std::abs(displacement(time)));
        }
        return largest;
    }

    /// [m/s] after the last sample of an acceleration.
    double residual_velocity() const { return static_cast<double>(zeroth_.back()); }

 private:
    long double slope(std::size_t i) const { return (samples_[i + 1] - samples_[i]) / step_; }

    /// Integral of f from sample i to u after it.
    long double zeroth_moment(std::size_t i, long double u) const
    {
        return u * samples_[i] + u * u / 2 * slope(i);
    }
    /// Integral of s f(s) over the same.
    long double first_moment(std::size_t i, long double u) const
    {
        const long double start = static_cast<long double>(i) * step_;
        return start * zeroth_moment(i, u) + u * u / 2 * samples_[i] + u * u * u / 3 * slope(i);
    }

    /// Central difference times the step; zero at the start, from rest.
    long double tangent(std::size_t i) const
    {
        if (i == 0) return 0;
        const std::size_t last = samples_.size() - 1;
        if (i == last) return (3 * samples_[i] - 4 * samples_[i - 1] + samples_[i - 2]) / 2;
        return (samples_[i + 1] - samples_[i - 1]) / 2;
    }
    /// Hermite's basis, u from 0 to 1 between samples i and i + 1.
    long double cubic(std::size_t i, long double u) const
    {
        const long double v = 1 - u;
        return (1 + 2 * u) * v * v * samples_[i] + u * v * v * tangent(i) + u * u * (3 - 2 * u) * samples_[i + 1] -
               u * u * v * tangent(i + 1);
    }

    records::Quantity quantity_;
    std::vector<long double> samples_;
    long double step_;
    std::vector<long double> zeroth_, first_;  // from 0 to each sample
};

}  // namespace voussoir::verification
