#include "records/formats/samples.h"

#include <algorithm>
#include <cmath>

#include "libdda/text/numbers.h"
#include "records/formats/format.h"

namespace voussoir::records::formats
{

namespace
{

constexpr double largest_sample = 1e30;  // no unit makes a motion of more: a null value or damage

}  // namespace

void check_block(const SourceFile& file, const NumberBlock& block, const Announced& announced,
                 std::vector<std::string>& remarks, FaultList& faults)
{
    for (std::size_t i = 0; i < block.numbers.size(); ++i) {
        if (std::abs(block.numbers[i]) < largest_sample) continue;  // not so for nan
        faults.add(file.at(line_of(block, i)), "sample " + text::to_text(block.numbers[i]),
                   "must be finite and smaller than " + text::to_text(largest_sample));
    }
    const std::size_t found = block.numbers.size() / announced.values_each;
    const double count = announced.count;
    const bool is_cut = count >= 2 && count < 1e18 && static_cast<double>(found) < count;
    if (found >= 2 && static_cast<double>(found) == count + 1) {
        remarks.push_back(announced.place + ": the header announces " + text::to_text(count) +
                          " samples but there is one more, which is kept");
    } else if (is_cut && block.end < file.lines.size()) {
        faults.add(file.at(block.end),
                   "\"" + first_not_number(file.lines[block.end], 0) + "\" after " + std::to_string(found) +
                       " of the " + std::to_string(static_cast<long long>(count)) +
                       " samples the header announces",
                   "the file is cut short or damaged: download it again");
    } else {
        check_count(count, found, announced.place, faults);
    }
}

void refuse_time_step(const SourceFile& file, const ReadOptions& options, FaultList& faults)
{
    if (!options.time_step) return;
    faults.add(file.name, "a time step was asked for", "the file holds the time of every sample: omit it");
}

void compare_peak(const Channel& channel, double stated, double rounding, const std::string& place,
                  std::vector<std::string>& remarks)
{
    const double found = peak(channel);
    if (std::abs(found - std::abs(stated)) <= rounding + 1e-3 * found) return;
    remarks.push_back(place + ": the header gives a peak of " + text::to_text(stated) + " but the samples have " +
                      text::to_text(found) + ", both in SI units; the samples are used");
}

namespace
{

/// Spreads runs of equal times evenly up to the next one. @returns how many times were moved
std::size_t spread_equal_times(std::vector<double>& times)
{
    std::size_t moved = 0;
    for (std::size_t i = 0; i < times.size();) {
        std::size_t next = i + 1;
        while (next < times.size() && times[next] == times[i]) ++next;
        const std::size_t run = next - i;
        const double start = times[i];
        // At the end there is no next time: go on with the step before.
        const double span = next < times.size() ? times[next] - start
                                                : static_cast<double>(run) * (i > 0 ? start - times[i - 1] : 1);
        for (std::size_t j = 1; j < run; ++j) {
            times[i + j] = start + span * static_cast<double>(j) / static_cast<double>(run);
        }
        moved += run - 1;
        i = next;
    }
    return moved;
}

}  // namespace

TimedSamples split_pairs(const SourceFile& file, const NumberBlock& block, std::vector<std::string>& remarks,
                         FaultList& faults)
{
    TimedSamples samples;
    if (block.numbers.size() % 2 != 0) {
        faults.add(file.at(line_of(block, block.numbers.size() - 1)), "a time without a value",
                   "the samples are pairs of time and value: the file is cut short or damaged");
    }
    for (std::size_t i = 0; i + 1 < block.numbers.size(); i += 2) {
        const double time = block.numbers[i];
        if (!samples.times.empty() && time < samples.times.back()) {
            faults.add(file.at(line_of(block, i)),
                       "time " + text::to_text(time) + " s after " + text::to_text(samples.times.back()) + " s",
                       "times must increase");
        }
        samples.times.push_back(time);
        samples.values.push_back(block.numbers[i + 1]);
    }
    if (samples.times.size() < 2 || !faults.empty()) return samples;
    if (samples.times.front() == samples.times.back()) {
        faults.add(file.at(block.first), "every time is " + text::to_text(samples.times.front()) + " s",
                   "times must increase");
        return samples;
    }
    const std::size_t moved = spread_equal_times(samples.times);
    if (moved > 0) {
        remarks.push_back(std::to_string(moved) +
                          " times are printed like the one before them and were spread evenly up to the next one");
    }
    return samples;
}

void keep_accelerations(Record& record)
{
    const auto is_acceleration = [](const Channel& channel) { return channel.quantity == Quantity::acceleration; };
    std::vector<Channel>& channels = record.channels;
    const auto count = static_cast<std::size_t>(std::count_if(channels.begin(), channels.end(), is_acceleration));
    if (count == 0 || count == channels.size()) return;
    record.remarks.push_back(
        "the file also holds " + std::to_string(channels.size() - count) +
        " series of velocity or displacement, which were not read: they follow from the acceleration");
    std::erase_if(channels, [&](const Channel& channel) { return !is_acceleration(channel); });
}

}  // namespace voussoir::records::formats
