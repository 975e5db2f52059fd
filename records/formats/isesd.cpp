// ISESD, the European Strong-Motion Data base on the Internet and its CD-ROMs (000123xa.cor): lines "key: value",
// then one section after another, each named by a line with an arrow:
//
//   orientation of transducer:    NS
//   sampling period:               0.010000s
//   number of samples:             3043
//   units:                        m/s*s, m/s, m & s
//   -> corrected acceleration time histories
//   -0.12059E-05 -0.38627E-05 ...
//   -> corrected velocity time histories
//   ...
//   STOP
//
// Velocity and displacement are the acceleration's integrals: only the acceleration is taken where there is one.
//
// Source: [Ambraseys2004].

#include <algorithm>
#include <cmath>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "ISESD";
constexpr std::size_t longest_header = 200;  // lines; some 30 in the files described

bool begins_section(std::string_view line)
{
    return text::trim(line).starts_with("->");
}

bool ends_data(std::string_view line)
{
    return text::lower_case(text::trim(line)).starts_with("stop");
}

KeyedHeader read_header(const SourceFile& file)
{
    return read_keyed_header(file, 0, longest_header, begins_section);
}

bool recognises(const SourceFile& file)
{
    if (!is_text(file)) return false;
    const KeyedHeader header = read_header(file);
    return header.end < file.lines.size() && begins_section(file.lines[header.end]) &&
           header.find("units") != nullptr &&
           (header.find("waveform code") != nullptr || header.find("sampling period") != nullptr);
}

struct Section {
    std::size_t title = 0;  // 0-based line
    std::size_t end = 0;    // 0-based line after the last sample
    Quantity quantity = Quantity::acceleration;
};

/// Adds a fault for a section of anything but a history in time.
std::vector<Section> find_sections(const SourceFile& file, std::size_t first, FaultList& faults)
{
    std::vector<Section> sections;
    for (std::size_t i = first; i < file.lines.size() && !ends_data(file.lines[i]); ++i) {
        if (!sections.empty()) sections.back().end = i + 1;
        if (!begins_section(file.lines[i])) continue;
        if (!sections.empty()) sections.back().end = i;
        const std::string title = text::lower_case(file.lines[i]);
        const auto names = [&](const char* word) { return title.find(word) != std::string::npos; };
        if (names("spectr") || names("freq") || names("period") || !names("time")) {
            faults.add(file.at(i), "\"" + std::string(text::trim(file.lines[i])) + "\": not a time history",
                       "use the record's acceleration (.cor)");
            return {};
        }
        const Quantity quantity = names("displ") ? Quantity::displacement
                                  : names("vel") ? Quantity::velocity
                                                 : Quantity::acceleration;
        sections.push_back({i, i + 1, quantity});
    }
    return sections;
}

/// The unit of a quantity in "m/s*s, m/s, m & s"; empty when the list has none.
std::string unit_for(Quantity quantity, std::string list)
{
    const auto is_separator = [](char c) { return c == ',' || c == '&' || c == ';'; };
    std::replace_if(list.begin(), list.end(), is_separator, '\n');
    std::string_view rest = list;
    while (!rest.empty()) {
        std::string word(text::trim(rest.substr(0, rest.find('\n'))));
        rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1);
        const std::size_t squared = word.find("/s*s");
        if (squared != std::string::npos) word.replace(squared, 4, "/s2");
        const std::optional<Unit> unit = find_unit(word);
        if (unit && unit->quantity == quantity) return word;
    }
    return "";
}

std::vector<double> read_section(const SourceFile& file, const Section& section, FaultList& faults)
{
    std::vector<double> samples, on_line;
    for (std::size_t i = section.title + 1; i < section.end; ++i) {
        if (text::trim(file.lines[i]).empty()) continue;
        const bool is_row = text::parse_fortran(file.lines[i], on_line);
        if (!is_row) {
            add_row_fault(file, i, "a section holds samples only", faults);
        } else if (!std::all_of(on_line.begin(), on_line.end(), [](double x) { return std::isfinite(x); })) {
            faults.add(file.at(i), "a sample that is not a number", "every sample must be finite");
        } else {
            samples.insert(samples.end(), on_line.begin(), on_line.end());
        }
    }
    return samples;
}

/// Only the acceleration, where there is one.
void keep_acceleration(std::vector<Section>& sections, std::vector<std::string>& remarks)
{
    const auto is_acceleration = [](const Section& s) { return s.quantity == Quantity::acceleration; };
    const std::size_t all = sections.size();
    if (std::none_of(sections.begin(), sections.end(), is_acceleration)) return;
    std::erase_if(sections, [&](const Section& s) { return !is_acceleration(s); });
    if (sections.size() < all)
        remarks.push_back("The file's velocity and displacement, integrals of its acceleration, are left out.");
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const KeyedHeader header = read_header(file);
    Record record{file.name,
                  format_name,
                  {},
                  text_of(header.find_beginning("station")),
                  text_of(header.find_beginning("earthquake"))};
    const HeaderLine* units = header.find("units");
    const HeaderLine* count = header.find("number of samples");
    const HeaderLine* step = header.find("sampling period");
    std::vector<Section> sections = find_sections(file, header.end, faults);
    keep_acceleration(sections, record.remarks);
    refuse_column(file, options, faults);
    faults.throw_if_any(file.name);
    const double time_step = resolve_time_step(number_of(step), options, place_of(file, step), faults);
    for (const Section& section : sections) {
        const Unit unit =
            resolve_unit(unit_for(section.quantity, text_of(units)), options, place_of(file, units), faults);
        std::vector<double> samples = read_section(file, section, faults);
        check_count(required_number(file, count, "number of samples", faults), samples.size(),
                    place_of(file, count), faults);
        record.channels.push_back(
            make_channel(text_of(header.find_beginning("orientation")), unit, time_step, std::move(samples)));
        record.channels.back().quantity = section.quantity;
        orient_by_short_name(record.channels.back(), record.channels.back().component);
    }
    faults.throw_if_any(file.name);
    return record;
}

}  // namespace

const Format isesd{format_name, recognises, read};

}  // namespace voussoir::records::formats
