// The files of a set of channels: tables, AT2, pictures.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <set>

#include "app/commands/outputs.h"
#include "app/commands/record_set.h"
#include "app/plots/plots.h"
#include "app/words/csv_cell.h"
#include "records/measures/fourier.h"
#include "records/write_at2.h"

namespace voussoir::app::commands
{
namespace
{

namespace fs = std::filesystem;

/// Letters, digits, '-', '_' and '.' of a component; its number when it has none.
std::string file_part(const std::string& component, std::size_t number)
{
    std::string part;
    for (const char c : component)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.') part += c;
    return part.empty() ? std::to_string(number + 1) : part;
}

std::string heading(const records::Channel& channel, std::size_t number)
{
    const char* const units[] = {"m/s2", "m/s", "m"};
    std::string name = channel.component.empty() ? std::to_string(number + 1) : channel.component;
    for (char& c : name)
        if (c == ',' || c == '"') c = ' ';
    return words::csv_cell(fmt::format(
        "{} [{}]", name, records::has_unit(channel) ? units[static_cast<int>(channel.quantity)] : "?"));
}

double time_of(const records::Channel& channel, std::size_t i)
{
    return channel.times.empty() ? static_cast<double>(i) * channel.time_step : channel.times[i];
}

bool share_times(const records::Channel& a, const records::Channel& b)
{
    return a.samples.size() == b.samples.size() && a.time_step == b.time_step && a.times == b.times;
}

/// A column of time and one for each of the channels, which share their times.
std::string series_csv(const std::vector<const records::Channel*>& channels)
{
    std::string text = "time [s]";
    for (std::size_t k = 0; k < channels.size(); ++k) text += "," + heading(*channels[k], k);
    text += "\n";
    for (std::size_t i = 0; i < channels[0]->samples.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{:.9g}", time_of(*channels[0], i));
        for (const records::Channel* channel : channels)
            fmt::format_to(std::back_inserter(text), ",{:.9g}", channel->samples[i]);
        text += "\n";
    }
    return text;
}

std::string spectra_csv(const RecordSet& set, const std::vector<double>& periods)
{
    std::string text = "period [s]";
    for (std::size_t k = 0; k < set.channels.size(); ++k)
        if (set.channels[k].spectrum) text += "," + heading(set.channels[k].channel, k);
    if (set.rotd) text += ",RotD50 [m/s2],RotD100 [m/s2]";
    text += "\n";
    for (std::size_t i = 0; i < periods.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{:.9g}", periods[i]);
        for (const MeasuredChannel& measured : set.channels)
            if (measured.spectrum)
                fmt::format_to(std::back_inserter(text), ",{:.9g}", measured.spectrum->pseudo_acceleration[i]);
        if (set.rotd)
            fmt::format_to(std::back_inserter(text), ",{:.9g},{:.9g}", set.rotd->rotd50[i], set.rotd->rotd100[i]);
        text += "\n";
    }
    return text;
}

/// A long series as its envelope: the lowest and highest value of each of so many stretches, in their order.
plots::Curve thinned(const std::string& name, const std::vector<double>& x, const std::vector<double>& y)
{
    constexpr std::size_t stretches = 1500;
    plots::Curve curve{name, {}, {}};
    const std::size_t length = std::max<std::size_t>(1, x.size() / stretches);
    for (std::size_t first = 0; first < x.size(); first += length) {
        const auto begin = y.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = y.begin() + static_cast<std::ptrdiff_t>(std::min(first + length, y.size()));
        const auto [low, high] = std::minmax_element(begin, end);
        for (const auto& at : {std::min(low, high), std::max(low, high)}) {
            curve.x.push_back(x[static_cast<std::size_t>(at - y.begin())]);
            curve.y.push_back(*at);
            if (low == high) break;
        }
    }
    return curve;
}

/// Of each channel the part of its files' names; two that would be alike, whatever the case of their letters, take
/// a number, so that neither is written over.
std::vector<std::string> file_parts(const RecordSet& set)
{
    std::vector<std::string> parts;
    std::set<std::string> taken;
    const auto is_free = [&](std::string name) {
        for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return taken.insert(name).second;
    };
    for (std::size_t k = 0; k < set.channels.size(); ++k) {
        const std::string part = file_part(set.channels[k].channel.component, k);
        std::string name = part;
        for (int number = 2; !is_free(name); ++number) name = fmt::format("{}_{}", part, number);
        parts.push_back(std::move(name));
    }
    return parts;
}

/// A name for each channel in headings and diagrams: curves of one name would be of one colour.
std::vector<std::string> curve_names(const RecordSet& set)
{
    std::vector<std::string> names;
    for (std::size_t k = 0; k < set.channels.size(); ++k) {
        const std::string& component = set.channels[k].channel.component;
        const std::string plain = component.empty() ? fmt::format("channel {}", k + 1) : component;
        std::string name = plain;
        for (int number = 2; std::find(names.begin(), names.end(), name) != names.end(); ++number)
            name = fmt::format("{} ({})", plain, number);
        names.push_back(std::move(name));
    }
    return names;
}

/// The station, or the first file without its folder and how many more.
std::string title_of(const RecordSet& set)
{
    const std::string first = set.file.substr(0, set.file.find(" + "));
    const std::string name = fs::path(first).filename().string();
    return set.station.empty() ? name : set.station + ": " + name;
}

/// Every acceleration by itself, then all velocities and all displacements.
plots::Figure series_figure(const RecordSet& set)
{
    const std::vector<std::string> names = curve_names(set);
    plots::Figure figure{set.stem + "_series", title_of(set), set.format, {}, true, {}};
    plots::Diagram velocities{"time [s]", "velocity [m/s]", {}, {}, false, false, false};
    plots::Diagram displacements{"time [s]", "displacement [m]", {}, {}, false, false, false};
    for (std::size_t k = 0; k < set.channels.size(); ++k) {
        const records::Channel& channel = set.channels[k].channel;
        if (!records::has_unit(channel)) continue;
        const GroundMotion motion = records::to_ground_motion(channel, set.file);
        std::vector<double> times, a, v, d;
        const double start = channel.times.empty() ? 0 : channel.times.front();
        for (std::size_t i = 0; i < channel.samples.size(); ++i) {
            times.push_back(time_of(channel, i));
            const double since = times.back() - start;
            a.push_back(channel.quantity == records::Quantity::acceleration ? channel.samples[i]
                                                                            : motion.acceleration(since));
            v.push_back(motion.velocity(since));
            d.push_back(motion.displacement(since));
        }
        const std::string& name = names[k];
        figure.diagrams.push_back(
            {"time [s]", name + " [m/s2]", {thinned(name, times, a)}, {}, false, false, false});
        velocities.curves.push_back(thinned(name, times, v));
        displacements.curves.push_back(thinned(name, times, d));
    }
    if (figure.diagrams.empty()) return figure;
    figure.diagrams.push_back(std::move(velocities));
    figure.diagrams.push_back(std::move(displacements));
    return figure;
}

/// Fourier amplitudes in bands of equal width on a logarithmic scale, root mean square of each.
plots::Curve fourier_curve(const std::string& name, const records::Channel& channel)
{
    constexpr int bands = 120;
    constexpr double lowest = 0.1;  // Hz
    const records::measures::FourierSpectrum spectrum = records::measures::fourier_amplitude(channel);
    const double highest = spectrum.frequencies.back();
    plots::Curve curve{name, {}, {}};
    std::size_t k = 0;
    for (int band = 0; band < bands; ++band) {
        const double to = lowest * std::pow(highest / lowest, (band + 1.0) / bands);
        double sum = 0, frequency = 0;
        int count = 0;
        for (; k < spectrum.frequencies.size() && spectrum.frequencies[k] <= to; ++k) {
            if (spectrum.frequencies[k] < lowest) continue;
            sum += spectrum.amplitudes[k] * spectrum.amplitudes[k];
            frequency += spectrum.frequencies[k];
            ++count;
        }
        if (count == 0 || !(sum > 0)) continue;
        curve.x.push_back(frequency / count);
        curve.y.push_back(std::sqrt(sum / count));
    }
    return curve;
}

plots::Figure spectra_figure(const RecordSet& set)
{
    const std::vector<std::string> names = curve_names(set);
    plots::Figure figure{set.stem + "_spectra",
                         title_of(set),
                         "5 % of critical damping; Fourier amplitudes smoothed in bands",
                         {},
                         false,
                         {}};
    plots::Diagram response{"period [s]", "pseudo-acceleration [m/s2]", {}, {}, true, false, false};
    plots::Diagram fourier{"frequency [Hz]", "Fourier amplitude [m/s]", {}, {}, true, true, false};
    for (std::size_t k = 0; k < set.channels.size(); ++k) {
        const MeasuredChannel& measured = set.channels[k];
        if (!measured.spectrum || !(measured.peak_acceleration > 0)) continue;
        const std::string& name = names[k];
        response.curves.push_back({name, measured.spectrum->periods, measured.spectrum->pseudo_acceleration});
        fourier.curves.push_back(fourier_curve(name, measured.channel));
    }
    if (response.curves.empty()) return figure;
    if (set.rotd) response.curves.push_back({"RotD50", set.rotd->periods, set.rotd->rotd50});
    if (set.rotd) response.curves.push_back({"RotD100", set.rotd->periods, set.rotd->rotd100});
    figure.diagrams = {std::move(response), std::move(fourier)};
    return figure;
}

void write_tables(const RecordSet& set, const fs::path& folder, std::vector<std::string>& written)
{
    const auto write = [&](const std::string& name, const std::string& text) {
        write_own_file(folder / name, text);
        written.push_back((folder / name).string());
    };
    std::vector<const records::Channel*> channels;
    for (const MeasuredChannel& measured : set.channels) channels.push_back(&measured.channel);
    const std::vector<std::string> parts = file_parts(set);
    const bool alike = std::all_of(channels.begin(), channels.end(), [&](const records::Channel* channel) {
        return share_times(*channel, *channels[0]);
    });
    if (alike) write(set.stem + ".csv", series_csv(channels));
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const std::string part = set.stem + "_" + parts[k];
        if (!alike) write(part + ".csv", series_csv({channels[k]}));
        if (!records::has_unit(*channels[k]) || channels[k]->quantity != records::Quantity::acceleration) continue;
        write(part + ".at2",
              records::format_at2(
                  "voussoir, from " + fs::path(set.file).filename().string() + " (" + set.format + ")",
                  set.station + ", " + channels[k]->component, records::resampled_evenly(*channels[k])));
    }
    for (const MeasuredChannel& measured : set.channels)
        if (measured.spectrum)
            return write(set.stem + "_spectra.csv", spectra_csv(set, measured.spectrum->periods));
}

}  // namespace

std::vector<std::string> write_files(const RecordSet& set, const fs::path& folder)
{
    std::vector<std::string> written;
    write_tables(set, folder, written);
    std::vector<plots::Figure> figures{series_figure(set), spectra_figure(set)};
    std::erase_if(figures, [](const plots::Figure& figure) { return figure.diagrams.empty(); });
    if (figures.empty()) return written;
    if (!plots::can_draw_figures()) {
        written.emplace_back("no pictures: this program was built without rendering");
        return written;
    }
    for (const std::string& name : plots::draw_figures(figures, folder))
        written.push_back((folder / (name + ".png")).string());
    return written;
}

}  // namespace voussoir::app::commands
