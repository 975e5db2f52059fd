// Windows in time and by Arias intensity.

#include <algorithm>
#include <chrono>
#include <cmath>

#include "records/measures/measures.h"
#include "records/processing/steps.h"

namespace voussoir::records::processing
{

namespace
{

/// Keeps samples `first` to `last`, as many of them as the channel has.
/// @throws InputError when fewer than two are left
void keep(Channel& channel, std::size_t first, std::size_t last, const std::string& place)
{
    last = std::min(last, channel.samples.size() - 1);
    if (first >= last)
        throw InputError(place,
                         "fewer than 2 samples of component \"" + channel.component +
                             "\" in the window, which has " + figure(duration_of(channel)) + " s in all",
                         "a window within the record and longer than its time step");
    const auto begin = channel.samples.begin();
    channel.samples = {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last) + 1};
    if (channel.start)
        *channel.start += std::chrono::round<std::chrono::microseconds>(
            std::chrono::duration<double>(static_cast<double>(first) * channel.time_step));
}

std::size_t nearest_sample(double time, const Channel& channel)
{
    const double steps = std::round(std::clamp(time, 0.0, duration_of(channel)) / channel.time_step);
    return static_cast<std::size_t>(steps);
}

/// Cuts all channels at samples of the first and says from when to when, and which of them end before that.
std::string cut(double start, double end, const std::string& place, ProcessedRecord& record)
{
    const Channel& first = record.channels.front();
    const double kept_from = static_cast<double>(nearest_sample(start, first)) * first.time_step;
    double kept_to = 0;
    for (Channel& channel : record.channels) {
        keep(channel, nearest_sample(kept_from, channel), nearest_sample(end, channel), place);
        kept_to = std::max(kept_to, kept_from + duration_of(channel));
    }
    record.start += kept_from;
    std::string early;
    for (const Channel& channel : record.channels) {
        const double ends = kept_from + duration_of(channel);
        if (ends < kept_to - channel.time_step / 2)
            early += "component \"" + channel.component + "\" ends at " + figure(ends) + " s; ";
    }
    return "window " + figure(kept_from) + " to " + figure(kept_to) + " s: " + early;
}

double longest_duration(const std::vector<Channel>& channels)
{
    double longest = 0;
    for (const Channel& channel : channels) longest = std::max(longest, duration_of(channel));
    return longest;
}

std::vector<std::vector<double>> cumulated_arias(const std::vector<Channel>& channels)
{
    std::vector<std::vector<double>> cumulated;
    cumulated.reserve(channels.size());
    for (const Channel& channel : channels)
        cumulated.push_back(measures::arias_up_to(channel.samples, channel.time_step));
    return cumulated;
}

/// The sum of the channels' Arias intensities up to a time, exact between samples too. @param cumulated
/// arias_up_to of each
double joint_arias_at(const std::vector<Channel>& channels, const std::vector<std::vector<double>>& cumulated,
                      double time)
{
    double sum = 0;
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const std::vector<double>& a = channels[k].samples;
        const double step = channels[k].time_step;
        const auto i = std::min(static_cast<std::size_t>(time / step), a.size() - 1);
        sum += cumulated[k][i];
        if (i + 1 == a.size()) continue;
        const double since = time - static_cast<double>(i) * step;
        const double here = std::lerp(a[i], a[i + 1], since / step);
        sum += measures::arias_up_to({a[i], here}, std::max(since, 1e-12 * step)).back();
    }
    return sum;
}

/// Share of the joint Arias intensity between two times; 1 of what has none, or is no acceleration.
double arias_between(const std::vector<Channel>& channels, double start, double end)
{
    const bool has_arias = std::all_of(channels.begin(), channels.end(), [](const Channel& channel) {
        return channel.quantity == Quantity::acceleration;
    });
    if (!has_arias) return 1;
    const std::vector<std::vector<double>> cumulated = cumulated_arias(channels);
    const double available = longest_duration(channels);
    const double whole = joint_arias_at(channels, cumulated, available);
    if (!(whole > 0)) return 1;
    const auto up_to = [&](double time) {
        return joint_arias_at(channels, cumulated, std::clamp(time, 0.0, available));
    };
    return (up_to(end) - up_to(start)) / whole;
}

}  // namespace

void apply(const TimeWindow& step, const std::string& place, ProcessedRecord& record)
{
    const double available = longest_duration(record.channels);
    const double half_step = record.channels.front().time_step / 2;
    if (std::isfinite(step.end) && step.end > available + half_step)
        throw InputError(place, "end [s] = " + figure(step.end),
                         "at most the record's " + figure(available) + " s");
    record.arias_share *= arias_between(record.channels, step.start, step.end);
    const std::string sentence = cut(step.start, step.end, place, record);
    record.sentences.push_back(sentence + "of " + figure(available) + " s");
}

void apply(const AriasWindow& step, const std::string& place, ProcessedRecord& record)
{
    require_accelerations(record.channels, place, "a window by Arias intensity");
    const std::vector<std::vector<double>> cumulated = cumulated_arias(record.channels);
    const double available = longest_duration(record.channels);
    const auto arias_at = [&](double time) { return joint_arias_at(record.channels, cumulated, time); };
    const double whole = arias_at(available);
    if (!(whole > 0))
        throw InputError(place, "a record without any acceleration", "a record with some acceleration");
    const auto time_of = [&](double share) {
        double early = 0, late = available;
        for (int i = 0; i < 60; ++i) {
            const double middle = (early + late) / 2;
            (arias_at(middle) < share * whole ? early : late) = middle;
        }
        return late;
    };
    const double from = step.from > 0 ? time_of(step.from) : 0, to = step.to < 1 ? time_of(step.to) : available;
    const double start = std::max(0.0, from - step.lead);
    const bool is_cut_short = to - start > step.longest;
    const double end = is_cut_short ? start + step.longest : to;
    const double held = arias_at(end) - arias_at(start);
    record.arias_share *= held / whole;
    std::string sentence = cut(start, end, place, record);
    sentence += figure(100 * step.from) + " % to " + figure(100 * step.to) +
                " % of the joint Arias intensity of " + std::to_string(record.channels.size()) + " component(s)";
    if (step.lead > 0) sentence += ", with " + figure(from - start) + " s before";
    if (is_cut_short) sentence += ", cut to the longest duration of " + figure(step.longest) + " s";
    record.sentences.push_back(sentence + "; it holds " + figure(100 * held / whole) + " % of it");
}

}  // namespace voussoir::records::processing
