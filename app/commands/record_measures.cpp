// Measures of a set of channels, in words and as JSON.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/commands/record_set.h"
#include "app/commands/say.h"

namespace voussoir::app::commands
{
namespace
{

using nlohmann::json;

constexpr double shortest_period = 0.02, longest_period = 10;  // s
constexpr std::size_t period_count = 100;

/// Says how far a long record is, on the standard error: after a second, then about every second.
class Telling
{
 public:
    explicit Telling(std::string what) : what_(std::move(what)) {}
    /// @param begin, end the shares of the whole that this part of it is
    std::function<void(double)> part(double begin, double end)
    {
        return [this, begin, end](double share) { tell(begin + (end - begin) * share); };
    }

 private:
    void tell(double share)
    {
        const auto now = std::chrono::steady_clock::now();
        if (share >= 1 || now - told_ < std::chrono::seconds(1)) return;
        told_ = now;
        complain(fmt::format("{}: measuring, {:.0f} %", what_, 100 * share));
    }

    std::string what_;
    std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

bool begin_together(const records::Channel& a, const records::Channel& b)
{
    if (!a.start || !b.start) return true;  // as far as anyone knows
    return std::chrono::abs(*a.start - *b.start) < std::chrono::duration<double>(a.time_step / 2);
}

/// Two horizontal channels at right angles, of one beginning and one length, for RotD; nothing when there are none
/// or more.
std::optional<std::pair<const records::Channel*, const records::Channel*>> horizontal_pair(const RecordSet& set)
{
    std::vector<const records::Channel*> horizontal;
    for (const MeasuredChannel& measured : set.channels)
        if (measured.channel.azimuth && measured.measures) horizontal.push_back(&measured.channel);
    if (horizontal.size() != 2) return std::nullopt;
    const double apart = std::remainder(*horizontal[1]->azimuth - *horizontal[0]->azimuth, 180);
    const bool alike = horizontal[0]->samples.size() == horizontal[1]->samples.size() &&
                       horizontal[0]->time_step == horizontal[1]->time_step && horizontal[0]->time_step > 0 &&
                       begin_together(*horizontal[0], *horizontal[1]);
    if (!alike || std::abs(std::abs(apart) - 90) > 1e-6) return std::nullopt;
    return std::pair(horizontal[0], horizontal[1]);
}

json json_of_measures(const records::measures::Measures& m)
{
    return {{"pgv_m_s", m.peak_velocity},
            {"pgd_m", m.peak_displacement},
            {"arias_intensity_m_s", m.arias_intensity},
            {"cav_m_s", m.cumulative_velocity},
            {"significant_duration_5_75_s", m.duration_5_75},
            {"significant_duration_5_95_s", m.duration_5_95},
            {"bracketed_duration_s", m.bracketed_duration},
            {"predominant_period_s", m.predominant_period},
            {"mean_period_s", m.mean_period}};
}

json json_of_channel(const MeasuredChannel& measured)
{
    const records::Channel& channel = measured.channel;
    const bool is_even = channel.times.empty(), is_known = records::has_unit(channel);
    const double duration = is_even ? static_cast<double>(channel.samples.size() - 1) * channel.time_step
                                    : channel.times.back() - channel.times.front();
    json entry = {{"component", channel.component},
                  {"quantity", is_known ? json(records::to_text(channel.quantity)) : json()},
                  {"npts", channel.samples.size()},
                  {"dt_s", is_even ? json(channel.time_step) : json()},
                  {"duration_s", duration},
                  {"units_in_file", is_known ? json(channel.unit_in_file) : json()},
                  {"azimuth_deg", channel.azimuth ? json(*channel.azimuth) : json()},
                  {"vertical", channel.is_vertical},
                  {"peak", is_known ? json(records::peak(channel)) : json()},
                  {"peak_as_stored", is_known ? json() : json(records::peak(channel))},
                  {"pga_m_s2", is_known ? json(measured.peak_acceleration) : json()}};
    if (!is_known) return entry;
    entry["residual_velocity_m_s"] = measured.residual_velocity;
    entry["residual_displacement_m"] = measured.residual_displacement;
    if (measured.measures) entry.update(json_of_measures(*measured.measures));
    if (measured.spectrum)
        entry["spectrum"] = {{"damping", measured.spectrum->damping},
                             {"periods_s", measured.spectrum->periods},
                             {"pseudo_acceleration_m_s2", measured.spectrum->pseudo_acceleration}};
    return entry;
}

std::string name_of(const records::Channel& channel)
{
    std::string name = channel.component.empty() ? "(no name)" : channel.component;
    if (channel.is_vertical) name += " (vertical)";
    if (channel.azimuth) name += fmt::format(" ({:g} deg)", *channel.azimuth);
    return name;
}

std::string sampling_of(const records::Channel& channel)
{
    if (!channel.times.empty())
        return fmt::format("{} uneven samples over {:g} s", channel.samples.size(),
                           channel.times.back() - channel.times.front());
    return fmt::format("{} samples at {:g} s = {:g} s", channel.samples.size(), channel.time_step,
                       static_cast<double>(channel.samples.size() - 1) * channel.time_step);
}

void print_channel(const MeasuredChannel& measured)
{
    const records::Channel& channel = measured.channel;
    if (!records::has_unit(channel)) {
        say(fmt::format("  {}: unit unknown, {}, largest value {:.6g}", name_of(channel), sampling_of(channel),
                        records::peak(channel)));
        return;
    }
    say(fmt::format("  {}: {} in {}, {}", name_of(channel), records::to_text(channel.quantity),
                    channel.unit_in_file, sampling_of(channel)));
    say(fmt::format("    peak acceleration {:.4g} m/s2; residual {:.3g} m/s and {:.3g} m",
                    measured.peak_acceleration, measured.residual_velocity, measured.residual_displacement));
    if (!measured.measures) return;
    const records::measures::Measures& m = *measured.measures;
    say(fmt::format("    PGV {:.4g} m/s, PGD {:.4g} m, Arias intensity {:.4g} m/s, CAV {:.4g} m/s",
                    m.peak_velocity, m.peak_displacement, m.arias_intensity, m.cumulative_velocity));
    say(fmt::format(
        "    duration: significant 5-75 % {:.4g} s, 5-95 % {:.4g} s ({:.5g} to {:.5g} s), above 0.05 g "
        "{:.4g} s",
        m.duration_5_75, m.duration_5_95, m.time_5, m.time_95, m.bracketed_duration));
    say(fmt::format("    period: predominant {:.3g} s, mean {:.3g} s", m.predominant_period, m.mean_period));
}

/// A table of the spectra at round periods.
void print_spectra(const RecordSet& set)
{
    std::string head = "    period s";
    for (const MeasuredChannel& measured : set.channels)
        if (measured.spectrum) head += fmt::format("  {:>10.10}", measured.channel.component);
    if (head.size() == 12) return;
    if (set.rotd) head += "      RotD50     RotD100";
    say("  5 % pseudo-acceleration [m/s2]");
    say(head);
    for (std::size_t i = 0; i < period_count; i += 11) {
        std::string row;
        for (const MeasuredChannel& measured : set.channels)
            if (measured.spectrum) {
                if (row.empty()) row = fmt::format("    {:8.3f}", measured.spectrum->periods[i]);
                row += fmt::format("  {:10.4g}", measured.spectrum->pseudo_acceleration[i]);
            }
        if (set.rotd) row += fmt::format("  {:10.4g}  {:10.4g}", set.rotd->rotd50[i], set.rotd->rotd100[i]);
        say(row);
    }
}

}  // namespace

void measure(std::vector<records::Channel> channels, RecordSet& set)
{
    const std::vector<double> periods =
        records::measures::logarithmic_periods(shortest_period, longest_period, period_count);
    for (records::Channel& channel : channels) {
        MeasuredChannel measured;
        if (records::has_unit(channel)) {
            const GroundMotion motion = records::to_ground_motion(channel, set.file);
            measured.residual_velocity = motion.residual_velocity();
            measured.residual_displacement = motion.residual_displacement();
            const bool is_acceleration = channel.quantity == records::Quantity::acceleration;
            measured.peak_acceleration = is_acceleration ? records::peak(channel) : motion.peak_acceleration();
            if (is_acceleration) {
                Telling telling(fmt::format("{} {}", set.file, name_of(channel)));
                constexpr double predominant = 0.75;  // of the work: three of four periods
                measured.measures =
                    records::measures::measures_of(channel, {.tell = telling.part(0, predominant)});
                measured.spectrum =
                    records::measures::response_spectrum(channel, periods, 0.05, telling.part(predominant, 1));
            }
        }
        measured.channel = std::move(channel);
        set.channels.push_back(std::move(measured));
    }
    if (const auto pair = horizontal_pair(set))
        set.rotd = records::measures::rotd(*pair->first, *pair->second, periods);
}

void print(const RecordSet& set)
{
    say_part(fmt::format("{}: {}", set.file, set.format));
    if (!set.station.empty()) say_part(fmt::format(", station {}", set.station));
    if (!set.event.empty()) say_part(fmt::format(", {}", set.event));
    say("");
    for (const std::string& remark : set.remarks) say(fmt::format("  remark: {}", remark));
    for (const std::string& sentence : set.processing) say(fmt::format("  done: {}", sentence));
    for (const MeasuredChannel& measured : set.channels) print_channel(measured);
    print_spectra(set);
}

std::string json_of(const std::vector<RecordSet>& sets)
{
    json list = json::array();
    for (const RecordSet& set : sets) {
        json channels = json::array();
        for (const MeasuredChannel& measured : set.channels) channels.push_back(json_of_channel(measured));
        json entry = {{"file", set.file},
                      {"format", set.format},
                      {"station", set.station},
                      {"event", set.event},
                      {"channels", channels},
                      {"remarks", set.remarks},
                      {"processing", set.processing},
                      {"reason", set.reason}};
        if (set.rotd)
            entry["rotd"] = {{"damping", set.rotd->damping},
                             {"periods_s", set.rotd->periods},
                             {"rotd50_m_s2", set.rotd->rotd50},
                             {"rotd100_m_s2", set.rotd->rotd100}};
        list.push_back(std::move(entry));
    }
    // Headers are in any encoding: what is no UTF-8 in them is replaced.
    return list.dump(2, ' ', false, json::error_handler_t::replace);
}

}  // namespace voussoir::app::commands
