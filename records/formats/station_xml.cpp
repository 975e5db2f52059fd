#include "records/formats/station_xml.h"

#include <array>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"

namespace voussoir::records::formats
{

namespace
{

/// Names may carry a prefix of their name space: "fsx:Network".
bool has_name(const pugi::xml_node& node, std::string_view name)
{
    const std::string_view full = node.name();
    return full.substr(full.find(':') == std::string_view::npos ? 0 : full.find(':') + 1) == name;
}

pugi::xml_node child(const pugi::xml_node& node, std::string_view name)
{
    return node.find_child([&](const pugi::xml_node& inner) { return has_name(inner, name); });
}

std::string text_in(const pugi::xml_node& node, std::string_view name)
{
    return std::string(text::trim(child(node, name).text().get()));
}

std::optional<double> number_in(const pugi::xml_node& node, std::string_view name)
{
    double number = 0;
    return text::parse_fortran_number(text_in(node, name), number) ? std::optional<double>(number) : std::nullopt;
}

bool has_code(const pugi::xml_node& node, const char* attribute, const std::string& code)
{
    std::string_view found = text::trim(node.attribute(attribute).value());
    if (found == "--") found = "";  // no location
    return found == code;
}

/// Times are compared as texts, to the second: "2015-04-23T00:00:00".
bool covers(const pugi::xml_node& channel, const std::string& start)
{
    constexpr std::size_t to_the_second = 19;
    if (start.empty()) return true;
    const std::string first = std::string(channel.attribute("startDate").value()).substr(0, to_the_second);
    const std::string last = std::string(channel.attribute("endDate").value()).substr(0, to_the_second);
    return (first.empty() || first <= start) && (last.empty() || start < last);
}

/// The epochs of the channel; `known` gathers what the file has instead.
std::vector<pugi::xml_node> find_epochs(const pugi::xml_node& root, const ChannelCode& code,
                                        const std::string& start, bool& has_channel)
{
    std::vector<pugi::xml_node> epochs;
    for (const pugi::xml_node& network : root.children()) {
        if (!has_name(network, "Network") || !has_code(network, "code", code.network)) continue;
        for (const pugi::xml_node& station : network.children()) {
            if (!has_name(station, "Station") || !has_code(station, "code", code.station)) continue;
            for (const pugi::xml_node& channel : station.children()) {
                if (!has_name(channel, "Channel") || !has_code(channel, "code", code.channel) ||
                    !has_code(channel, "locationCode", code.location))
                    continue;
                has_channel = true;
                if (covers(channel, start)) epochs.push_back(channel);
            }
        }
    }
    return epochs;
}

struct Sensitivity {
    double counts = 0;  // per SI unit of motion
    double frequency = 0;
    Quantity quantity = Quantity::acceleration;
};

/// "M/S**2", "nm/s**2", "um/s": units of motion with any of the prefixes that occur.
std::optional<Unit> find_motion_unit(const std::string& name)
{
    struct Prefix {
        const char* name;
        double factor;
    };
    constexpr std::array<Prefix, 4> prefixes{{{"n", 1e-9}, {"u", 1e-6}, {"\xC2\xB5", 1e-6}, {"\xCE\xBC", 1e-6}}};
    if (std::optional<Unit> unit = find_unit(name)) return unit;
    for (const Prefix& prefix : prefixes) {
        if (!text::lower_case(name).starts_with(prefix.name)) continue;
        std::optional<Unit> unit = find_unit(std::string_view(name).substr(std::string_view(prefix.name).size()));
        if (unit) unit->factor *= prefix.factor;
        return unit;
    }
    return std::nullopt;
}

Sensitivity read_sensitivity(const pugi::xml_node& channel, const std::string& place)
{
    const pugi::xml_node node = child(child(channel, "Response"), "InstrumentSensitivity");
    const std::optional<double> value = number_in(node, "Value");
    if (!value || !std::isfinite(*value) || *value == 0)
        throw InputError(place, "no InstrumentSensitivity with a value that is a number other than 0",
                         "a StationXML of level \"response\" or \"channel\"");
    const std::string input = text_in(child(node, "InputUnits"), "Name");
    const std::string output = text_in(child(node, "OutputUnits"), "Name");
    const std::optional<Unit> unit = find_motion_unit(input);
    if (!unit)
        throw InputError(place, "a sensitivity to \"" + input + "\"", "to acceleration, velocity or displacement");
    if (text::lower_case(output).find("count") == std::string::npos)
        throw InputError(place, "a sensitivity in \"" + output + "\"", "in counts");
    return {*value / unit->factor, number_in(node, "Frequency").value_or(0), unit->quantity};
}

const char* si_unit(Quantity quantity)
{
    if (quantity == Quantity::velocity) return "m/s";
    return quantity == Quantity::displacement ? "m" : "m/s2";
}

/// Ten digits: the factor between units of the file and SI is no reason for 428053.99999999994.
std::string to_short_text(double value)
{
    std::array<char, 40> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 10);
    return error == std::errc() ? std::string(buffer.data(), end) : text::to_text(value);
}

/// Dip: -90 is up, 90 is down.
void orient(const pugi::xml_node& node, Channel& channel, std::vector<std::string>& remarks)
{
    constexpr double nearly = 5;  // deg
    const std::optional<double> azimuth = number_in(node, "Azimuth"), dip = number_in(node, "Dip");
    if (!dip) return;
    channel.azimuth.reset();
    channel.is_vertical = *dip <= -90 + nearly;
    if (std::abs(*dip) <= nearly && azimuth) channel.azimuth = *azimuth;
    if (*dip >= 90 - nearly) remarks.push_back("Component " + channel.component + " is positive downwards.");
}

}  // namespace

std::string to_text(const ChannelCode& code)
{
    return code.network + "." + code.station + "." + code.location + "." + code.channel;
}

void apply_response(const std::filesystem::path& station_xml, const ChannelCode& code, const std::string& start,
                    Channel& channel, std::vector<std::string>& remarks)
{
    SourceFile file;
    load_source_file(station_xml, file);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(file.bytes.data(), file.bytes.size());
    if (!parsed)
        throw InputError(file.name + ", byte " + std::to_string(parsed.offset), parsed.description(),
                         "a StationXML file");
    const pugi::xml_node root = child(document, "FDSNStationXML");
    if (!root) throw InputError(file.name, "no element FDSNStationXML", "a StationXML file");
    bool has_channel = false;
    const std::vector<pugi::xml_node> epochs = find_epochs(root, code, start, has_channel);
    const std::string at_time = start.empty() ? "" : " at " + start;
    if (!has_channel)
        throw InputError(file.name, "no channel " + to_text(code), "the StationXML of the record's station");
    if (epochs.size() != 1)
        throw InputError(file.name,
                         std::to_string(epochs.size()) + " epochs of channel " + to_text(code) + at_time,
                         "exactly one covers the record's start");
    const Sensitivity sensitivity = read_sensitivity(epochs.front(), file.name + ", channel " + to_text(code));
    for (double& sample : channel.samples) sample /= sensitivity.counts;
    channel.quantity = sensitivity.quantity;
    const std::string per = to_short_text(sensitivity.counts) + " per " + si_unit(sensitivity.quantity);
    channel.unit_in_file = "counts / " + per;
    orient(epochs.front(), channel, remarks);
    remarks.push_back("Channel " + to_text(code) + ": the flat sensitivity of " + per + " (at " +
                      text::to_text(sensitivity.frequency) + " Hz) was applied, no poles and zeros.");
}

Unit resolve_unit_of_counts(const ReadOptions& options, const std::string& place, FaultList& faults)
{
    if (options.unit && !options.response.empty())
        faults.add(place, "both a unit and a response were given", "omit one of them");
    return resolve_unit("", options, place, faults);
}

}  // namespace voussoir::records::formats
