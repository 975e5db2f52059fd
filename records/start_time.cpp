#include "records/start_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "libdda/errors.h"
#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"

namespace voussoir::records
{

namespace
{

using std::chrono::duration;

constexpr double worth_telling = 1e-3;  // s left between components

/// The number in the first `digits` digits of `text`, which is shortened by them; -1 when they are not there.
int take_digits(std::string_view& text, std::size_t digits)
{
    int value = 0;
    if (text.size() < digits) return -1;
    for (const char c : text.substr(0, digits)) {
        if (c < '0' || c > '9') return -1;
        value = 10 * value + (c - '0');
    }
    text.remove_prefix(digits);
    return value;
}

void skip_one_of(std::string_view& text, std::string_view separators)
{
    if (!text.empty() && separators.find(text.front()) != std::string_view::npos) text.remove_prefix(1);
}

double seconds_between(Instant early, Instant late)
{
    // Not their difference, which overflows for instants as far apart as damaged headers put them.
    return 1e-6 * (static_cast<double>(late.time_since_epoch().count()) -
                   static_cast<double>(early.time_since_epoch().count()));
}

/// To the microsecond, as instants are.
std::string in_seconds(double time)
{
    return text::to_text(std::round(1e6 * time) / 1e6) + " s";
}

std::string list_of_unknown(const std::vector<Channel>& channels)
{
    std::string names;
    for (const Channel& channel : channels)
        if (!channel.start) names += (names.empty() ? "\"" : ", \"") + channel.component + "\"";
    return names;
}

bool differ_in_length(const std::vector<Channel>& channels)
{
    return std::any_of(channels.begin(), channels.end(), [&](const Channel& channel) {
        return channel.samples.size() != channels.front().samples.size();
    });
}

/// Takes away what lies before `begin`. @returns seconds between `begin` and the first sample kept
double cut_before(Instant begin, Channel& channel)
{
    const double early = seconds_between(*channel.start, begin);
    const double steps = std::round(early / channel.time_step);
    if (!(steps < static_cast<double>(channel.samples.size()) - 1))
        throw InputError(
            "component \"" + channel.component + "\"",
            "begins at " + to_text(*channel.start) + " and ends before another begins, at " + to_text(begin),
            "give components of one record");
    const double cut = steps * channel.time_step;
    channel.samples.erase(channel.samples.begin(),
                          channel.samples.begin() + static_cast<std::ptrdiff_t>(std::max(0.0, steps)));
    *channel.start += std::chrono::round<std::chrono::microseconds>(duration<double>(cut));
    return early - cut;
}

}  // namespace

std::optional<Instant> parse_instant(std::string_view text)
{
    using namespace std::chrono;
    text = text::trim(text);
    const int y = take_digits(text, 4);
    skip_one_of(text, "/-");
    const int m = take_digits(text, 2);
    skip_one_of(text, "/-");
    const int d = take_digits(text, 2);
    skip_one_of(text, " _T");
    const int hour = take_digits(text, 2);
    skip_one_of(text, ":");
    const int minute = take_digits(text, 2);
    skip_one_of(text, ":");
    double second = 0;
    const bool has_second = text::parse_fortran_number(text, second);
    if (y < 0 || m < 0 || d < 0 || hour < 0 || hour > 23 || minute < 0 || minute > 59) return std::nullopt;
    if (!has_second || !(second >= 0 && second < 61)) return std::nullopt;
    const year_month_day date{year(y), month(static_cast<unsigned>(m)), day(static_cast<unsigned>(d))};
    if (!date.ok()) return std::nullopt;
    return sys_days(date) + hours(hour) + minutes(minute) + round<microseconds>(duration<double>(second));
}

std::string to_text(Instant instant)
{
    using namespace std::chrono;
    // Not floor<days>, whose way back to microseconds overflows for the first instant that there is.
    const microseconds since = instant.time_since_epoch(), remainder = since % days(1);
    const microseconds of_day = remainder.count() < 0 ? remainder + days(1) : remainder;
    const year_month_day date{sys_days(days(since / days(1)) - days(remainder.count() < 0 ? 1 : 0))};
    const hh_mm_ss<microseconds> time(of_day);
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                  static_cast<int>(time.seconds().count()));
    return text.data();
}

std::vector<std::string> bring_into_step(std::vector<Channel>& channels)
{
    if (channels.size() < 2) return {};
    const std::string unknown = list_of_unknown(channels);
    const bool any_known =
        std::any_of(channels.begin(), channels.end(), [](const Channel& c) { return c.start.has_value(); });
    if (!unknown.empty()) {
        if (!any_known && !differ_in_length(channels)) return {};  // as a network writes the files of one record
        return {"component(s) " + unknown +
                " have no start time: all are assumed to begin together, at their first samples"};
    }
    const auto earlier = [](const Channel& a, const Channel& b) { return *a.start < *b.start; };
    const Instant begin = *std::max_element(channels.begin(), channels.end(), earlier)->start;
    std::vector<std::string> sentences;
    for (Channel& channel : channels) {
        const double before = seconds_between(*channel.start, begin);
        const double left = cut_before(begin, channel);
        std::string sentence;
        if (before - left > 0)
            sentence = in_seconds(before - left) + " cut, to start with the last component at " + to_text(begin);
        if (std::abs(left) > worth_telling)
            sentence += (sentence.empty() ? "" : ", and ") + in_seconds(std::abs(left)) + " " +
                        (left > 0 ? "early" : "late") + " of it, less than a time step";
        if (!sentence.empty()) sentences.push_back("component \"" + channel.component + "\": " + sentence);
    }
    return sentences;
}

}  // namespace voussoir::records
