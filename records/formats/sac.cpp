// SAC (Seismic Analysis Code): one component a file, evenly sampled or with a time for each sample.
//
// Its header says whether the samples are an acceleration, but not in which unit, and is often wrong even there:
// samples are without a unit unless the user gives one or a response.
//
// Source: [SacManual].

#include <chrono>
#include <cmath>

#include "libdda/text/numbers.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"
#include "records/formats/sac_header.h"
#include "records/formats/station_xml.h"
#include "records/start_time.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "SAC";

bool recognises(const SourceFile& file)
{
    return is_sac(file);
}

void check_type(const SourceFile& file, const SacHeader& header)
{
    const std::int64_t type = header.integers[sac::file_type];
    const bool is_series = type == 1 || type == 4 || type == static_cast<std::int64_t>(sac::undefined);
    if (is_series) return;
    const bool is_spectrum = type == 2 || type == 3;
    throw InputError(file.name, is_spectrum ? "a spectrum, not a time history" : "not a time history",
                     "a SAC file of type ITIME or IXY (iftype 1 or 4), not " + std::to_string(type));
}

/// Nothing when the header has no date.
std::optional<Instant> start_of(const SacHeader& header)
{
    using namespace std::chrono;
    const auto number = [&](sac::Integer at) { return header.integers[at]; };
    const bool is_date =
        number(sac::year) > 1800 && number(sac::year) < 3000 && number(sac::day) >= 1 && number(sac::day) <= 366;
    if (!is_date) return std::nullopt;
    const sys_days new_year = year(static_cast<int>(number(sac::year))) / January / 1;
    const auto clock = [&](sac::Integer at, int limit) {
        return number(at) >= 0 && number(at) < limit ? number(at) : 0;
    };
    const float begin = header.reals[sac::begin];
    const bool has_begin = std::abs(begin) < 1e8F && begin != static_cast<float>(sac::undefined);
    return new_year + days(number(sac::day) - 1) + hours(clock(sac::hour, 24)) + minutes(clock(sac::minute, 60)) +
           seconds(clock(sac::second, 61)) + milliseconds(clock(sac::millisecond, 1000)) +
           round<microseconds>(duration<double>(has_begin ? begin : 0));
}

/// Inclination is from up: 0 up, 90 horizontal, 180 down.
void orient(Channel& channel, const SacHeader& header, std::vector<std::string>& remarks)
{
    constexpr float nearly = 5;  // deg
    const float azimuth = header.reals[sac::azimuth], inclination = header.reals[sac::inclination];
    const bool is_given = azimuth != static_cast<float>(sac::undefined) &&
                          inclination != static_cast<float>(sac::undefined) && std::isfinite(azimuth);
    if (!is_given) return orient_by_short_name(channel, channel.component);
    channel.is_vertical = std::abs(inclination) <= nearly;
    if (std::abs(inclination - 90) <= nearly) channel.azimuth = std::fmod(azimuth + 720, 360);
    if (std::abs(inclination - 180) <= nearly)
        remarks.push_back("Component " + channel.component + " is positive downwards.");
}

void remark_on_quantity(const SacHeader& header, const Channel& channel, std::vector<std::string>& remarks)
{
    const std::int64_t dependent = header.integers[sac::dependent];
    const char* says = dependent == 6   ? "displacement"
                       : dependent == 7 ? "velocity"
                       : dependent == 8 ? "acceleration"
                                        : nullptr;
    if (says != nullptr && !has_unit(channel))
        remarks.push_back("The header calls the samples " + std::string(says) +
                          " but states no unit: give the unit.");
}

/// The times of unevenly spaced samples stand after them.
std::vector<double> times_of(const SourceFile& file, const SacHeader& header, std::size_t count, FaultList& faults)
{
    std::vector<double> times(header.numbers.begin() + static_cast<std::ptrdiff_t>(count), header.numbers.end());
    for (std::size_t i = 0; i < times.size(); ++i) {
        const bool increases = std::isfinite(times[i]) && (i == 0 || times[i] > times[i - 1]);
        if (increases) continue;
        faults.add(file.name, "time " + text::to_text(times[i]) + " s of sample " + std::to_string(i + 1),
                   "times must increase");
        break;
    }
    return times;
}

Channel read_channel(const SourceFile& file, const SacHeader& header, const ReadOptions& options,
                     FaultList& faults)
{
    const bool is_uneven = header.integers[sac::is_even] == 0;
    const std::size_t held = header.numbers.size() / (is_uneven ? 2 : 1);
    check_count(static_cast<double>(header.integers[sac::count]), held, file.name, faults);
    if (is_uneven && header.numbers.size() % 2 != 0)
        faults.add(file.name, "unevenly spaced samples without a time for each", "download the file again");
    const double time_step = is_uneven ? 0 : resolve_time_step(header.delta, options, file.name, faults);
    faults.throw_if_any(file.name);
    std::vector<double> samples(header.numbers.begin(),
                                header.numbers.begin() + static_cast<std::ptrdiff_t>(held));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!std::isfinite(samples[i]))
            faults.add(file.name, "sample " + std::to_string(i + 1) + " is " + text::to_text(samples[i]),
                       "must be finite");
    }
    const Unit unit = resolve_unit_of_counts(options, file.name, faults);
    Channel channel = make_channel(sac_word(header, sac::component), unit, time_step, std::move(samples));
    if (is_uneven) channel.times = times_of(file, header, held, faults);
    return channel;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const SacHeader header = read_sac_header(file);
    check_type(file, header);
    refuse_column(file, options, faults);
    Channel channel = read_channel(file, header, options, faults);
    faults.throw_if_any(file.name);
    const ChannelCode code{sac_word(header, sac::network), sac_word(header, sac::station),
                           sac_word(header, sac::location), channel.component};
    Record record{file.name, format_name, {}, code.network + (code.network.empty() ? "" : ".") + code.station};
    if (!channel.times.empty())
        record.remarks.push_back("The samples are unevenly spaced in time; for a motion they are resampled.");
    channel.start = start_of(header);
    orient(channel, header, record.remarks);
    if (!options.response.empty())
        apply_response(options.response, code, channel.start ? records::to_text(*channel.start) : "", channel,
                       record.remarks);
    remark_on_quantity(header, channel, record.remarks);
    record.channels.push_back(std::move(channel));
    return record;
}

}  // namespace

const Format sac_format{format_name, recognises, read, true};

}  // namespace voussoir::records::formats
