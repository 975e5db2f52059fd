#include "records/measures/response_peaks.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace voussoir::records::measures
{
namespace
{

constexpr std::size_t lane_count = 8;     // oscillators that walk together
constexpr std::size_t block_length = 32;  // samples that are walked again when a peak may lie in them
constexpr std::size_t block_count = 32;   // blocks between two looks at the bounds
constexpr double rounding = 1 + 1e-9;     // bounds are summed in another order than what they bound

using Lanes = Eigen::Array<double, static_cast<int>(lane_count), 1>;

/// What `advanced` and `largest_sag` take of each oscillator, lane by lane.
struct LaneConstants {
    Lanes w, stiffness, twice_damping, per_frequency;
    Lanes kept, impulse, impulse_rate, step, ramp;
    Lanes sag_factor, swing;
};

/// States, and bounds since they were last looked at.
struct LaneStates {
    Lanes u = Lanes::Zero(), v = Lanes::Zero();
    Lanes end_u = Lanes::Zero(), end_a = Lanes::Zero(), sag = Lanes::Zero();
};

LaneConstants constants_of(std::span<const Oscillator> oscillators, double length)
{
    LaneConstants c;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const auto l = static_cast<Eigen::Index>(lane);
        const Oscillator& oscillator = oscillators[std::min(lane, oscillators.size() - 1)];
        const Influence over = influence(oscillator, length);
        const double w = oscillator.frequency;
        c.w[l] = w;
        c.stiffness[l] = w * w;
        c.twice_damping[l] = 2 * oscillator.damping * w;
        c.per_frequency[l] = 1 / w;
        c.kept[l] = over.impulse_rate + 2 * oscillator.damping * w * over.impulse;
        c.impulse[l] = over.impulse;
        c.impulse_rate[l] = over.impulse_rate;
        c.step[l] = over.step;
        c.ramp[l] = over.ramp;
        c.sag_factor[l] = length * length / 8;
        c.swing[l] = watched_absolute_acceleration(oscillator).swing;
    }
    return c;
}

/// One stretch of all lanes: `advanced` in its order of operations, and what bounds the peaks within.
void walk_stretch(const LaneConstants& c, double acceleration, double jerk, LaneStates& s)
{
    const Lanes second = -acceleration - c.twice_damping * s.v - c.stiffness * s.u;
    const Lanes third_over_w = (jerk + c.twice_damping * second) * c.per_frequency + c.w * s.v;
    s.sag = s.sag.max(second.abs() + third_over_w.abs());  // no less than the root of the sum of the squares
    const Lanes u = s.u * c.kept + s.v * c.impulse - acceleration * c.step - jerk * c.ramp;
    s.v = -s.u * c.w * c.w * c.impulse + s.v * c.impulse_rate - acceleration * c.impulse - jerk * c.step;
    s.u = u;
    s.end_u = s.end_u.max(s.u.abs());
    s.end_a = s.end_a.max((c.stiffness * s.u + c.twice_damping * s.v).abs());
}

/// Raises the peaks by what lies within a stretch.
void take(const Oscillator& oscillator, const Stretch& stretch, ResponsePeaks& peaks)
{
    const double sag = largest_sag(oscillator, stretch);
    const auto raise = [&](const Watched& watched, double& largest) {
        const double ends =
            std::max(std::abs(value(watched, stretch.start)), std::abs(value(watched, stretch.end)));
        if (ends + watched.swing * sag > largest)
            largest = std::max(largest, peak_within(oscillator, stretch, watched));
    };
    raise(watched_displacement(), peaks.displacement);
    raise(watched_absolute_acceleration(oscillator), peaks.absolute_acceleration);
}

/// Oscillators that divide a sampling interval alike, at most as many as there are lanes.
class Group
{
 public:
    Group(std::span<const Oscillator> oscillators, const std::vector<double>& samples, double time_step)
        : oscillators_(oscillators),
          samples_(samples),
          time_step_(time_step),
          division_(stretches_of(oscillators.front(), time_step)),
          length_(time_step / division_),
          constants_(constants_of(oscillators, length_))
    {
    }

    void find_peaks(std::span<ResponsePeaks> peaks)
    {
        const std::size_t intervals = samples_.size() - 1;
        for (std::size_t next = 0; next < intervals;) {
            std::size_t count = 0;
            for (; count < block_count && next < intervals; ++count) {
                Block& block = blocks_[count];
                block = {next, std::min(next + block_length, intervals), states_, {}};
                walk_lanes(block.first, block.end);
                block.after = states_;
                next = block.end;
            }
            for (std::size_t lane = 0; lane < oscillators_.size(); ++lane)
                look_at(std::span(blocks_).first(count), lane, peaks[lane]);
        }
        for (std::size_t lane = 0; lane < oscillators_.size(); ++lane)
            walk_again(lane, states_, intervals, intervals + 1, peaks[lane]);
    }

 private:
    /// Some samples, the states before them and, with the bounds within them, after them.
    struct Block {
        std::size_t first, end;
        LaneStates before, after;
    };

    /// The ends of stretches are peaks themselves; with them known, few stretches can have a larger one within.
    void look_at(std::span<const Block> blocks, std::size_t lane, ResponsePeaks& peaks) const
    {
        const auto l = static_cast<Eigen::Index>(lane);
        for (const Block& block : blocks) {
            peaks.displacement = std::max(peaks.displacement, block.after.end_u[l]);
            peaks.absolute_acceleration = std::max(peaks.absolute_acceleration, block.after.end_a[l]);
        }
        for (const Block& block : blocks)
            if (may_pass(block.after, l, peaks)) walk_again(lane, block.before, block.first, block.end, peaks);
    }

    void walk_lanes(std::size_t first, std::size_t end)
    {
        LaneStates s = states_;
        s.end_u = s.u.abs();
        s.end_a = (constants_.stiffness * s.u + constants_.twice_damping * s.v).abs();
        s.sag.setZero();
        for (std::size_t i = first; i < end; ++i) {
            const double jerk = (samples_[i + 1] - samples_[i]) * (1 / time_step_);
            for (int part = 0; part < division_; ++part)
                walk_stretch(constants_, samples_[i] + jerk * part * length_, jerk, s);
        }
        states_ = s;
    }

    bool may_pass(const LaneStates& states, Eigen::Index lane, const ResponsePeaks& peaks) const
    {
        const double sag = constants_.sag_factor[lane] * states.sag[lane];
        return !(rounding * (states.end_u[lane] + sag) <= peaks.displacement &&
                 rounding * (states.end_a[lane] + constants_.swing[lane] * sag) <= peaks.absolute_acceleration);
    }

    /// One oscillator from sample `first` to sample `end`, or, beyond the last sample, until it has swung out.
    void walk_again(std::size_t lane, const LaneStates& from, std::size_t first, std::size_t end,
                    ResponsePeaks& peaks) const
    {
        const auto l = static_cast<Eigen::Index>(lane);
        const Oscillator& oscillator = oscillators_[lane];
        ResponseWalk walk(oscillator, samples_, time_step_, first, {from.u[l], from.v[l]});
        for (Stretch stretch{}; walk.sample() < end && walk.next(stretch);) take(oscillator, stretch, peaks);
    }

    std::span<const Oscillator> oscillators_;
    const std::vector<double>& samples_;
    double time_step_;
    int division_;   // stretches between two samples
    double length_;  // s, of one
    LaneConstants constants_;
    LaneStates states_;
    std::array<Block, block_count> blocks_;
};

}  // namespace

std::vector<ResponsePeaks> peaks_of_responses(std::span<const Oscillator> oscillators,
                                              const std::vector<double>& samples, double time_step,
                                              const std::function<void(double)>& tell)
{
    std::vector<ResponsePeaks> peaks(oscillators.size());
    for (std::size_t first = 0; first < oscillators.size();) {
        const int division = stretches_of(oscillators[first], time_step);
        std::size_t count = 1;
        while (count < lane_count && first + count < oscillators.size() &&
               stretches_of(oscillators[first + count], time_step) == division)
            ++count;
        Group(oscillators.subspan(first, count), samples, time_step)
            .find_peaks(std::span(peaks).subspan(first, count));
        first += count;
        if (tell) tell(static_cast<double>(first) / static_cast<double>(oscillators.size()));
    }
    return peaks;
}

}  // namespace voussoir::records::measures
