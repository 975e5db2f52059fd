// PEER's AT2 (acceleration), VT2 and DT2: four header lines, then the samples, five or eight on a line.
//
//   PEER NGA STRONG MOTION DATABASE RECORD
//   Loma Prieta, 10/18/1989, Gilroy - Gavilan Coll., 67        <- component after the last comma
//   ACCELERATION TIME SERIES IN UNITS OF G                     <- unit
//   NPTS=   7999, DT=   .0050 SEC,                             <- or, older:  4096    0.0100    NPTS, DT
//
// Further lines may stand above (spectrally matched records have seven header lines) or below the count.
//
// Written from the headers of PEER NGA-West2 flat files and of the older PEER Strong Motion Database.
// Source: [PeerSamples].

#include <algorithm>
#include <optional>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"

namespace voussoir::records::formats
{

namespace
{

constexpr std::size_t header_search = 12;  // lines; the count stands on the fourth in every file seen

/// 0-based line that announces NPTS and DT.
std::optional<std::size_t> find_count_line(const SourceFile& file)
{
    for (std::size_t i = 1; i < file.lines.size() && i < header_search; ++i) {
        const std::string line = text::lower_case(file.lines[i]);
        if (line.find("npts") != std::string::npos && line.find("dt") != std::string::npos) return i;
    }
    return std::nullopt;
}

bool recognises(const SourceFile& file)
{
    return is_text(file) && find_count_line(file).has_value();
}

struct Announced {
    double count = 0;
    double time_step = 0;  // s
};

/// The number after "KEY=", "KEY:" or "KEY", and in `rest` what follows it up to the next comma.
bool number_after(const std::string& line, std::string_view key, double& value, std::string_view& rest)
{
    const std::size_t at = line.find(key);
    if (at == std::string::npos) return false;
    rest = text::trim(std::string_view(line).substr(at + key.size()));
    if (!rest.empty() && (rest.front() == '=' || rest.front() == ':')) rest = text::trim(rest.substr(1));
    const std::size_t used = text::parse_leading_number(rest, value);
    rest = text::trim(rest.substr(used));
    rest = text::trim(rest.substr(0, rest.find_first_of(",;)")));
    return used > 0;
}

/// All numbers among the words of a line: "4096  0.0100  (NPTS, DT)".
std::vector<double> numbers_among_words(std::string line)
{
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
    std::vector<double> numbers;
    std::string_view rest = text::trim(line);
    while (!rest.empty()) {
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
        double number = 0;
        if (text::parse_fortran_number(word, number)) numbers.push_back(number);
        rest = text::trim(rest.substr(word.size()));
    }
    return numbers;
}

/// "NPTS= 4000, DT= .01000 SEC", "4096 0.0100 NPTS, DT" or "(NPTS, DT) 4096 .01".
std::optional<Announced> parse_count_line(std::string_view text)
{
    const std::string line = text::lower_case(text);
    Announced announced;
    std::string_view rest;
    if (number_after(line, "npts", announced.count, rest) && number_after(line, "dt", announced.time_step, rest)) {
        const bool in_seconds = rest.empty() || rest == "s" || rest.starts_with("sec");
        return in_seconds ? std::optional<Announced>(announced) : std::nullopt;
    }
    const std::vector<double> numbers = numbers_among_words(line);
    const bool in_other_units = line.find("msec") != std::string::npos;
    if (line.find('=') != std::string::npos || numbers.size() != 2 || in_other_units) return std::nullopt;
    const bool step_first = line.find("dt") < line.find("npts");
    return step_first ? Announced{numbers[1], numbers[0]} : Announced{numbers[0], numbers[1]};
}

/// A unit at the start of a text: "CM/SEC. FILTER POINTS: ...", "(g)", "G's, scaled". Empty when there is none.
std::string leading_unit(std::string_view text)
{
    text = text::trim(text);
    if (text.starts_with('(')) text = text.substr(1, text.find(')') - 1);
    text = text::trim(text.substr(0, text.find_first_of(".,;:)")));
    for (std::string_view candidate : {text, text.substr(0, text.find_first_of(" \t"))}) {
        const std::string lower = text::lower_case(candidate);
        if (lower == "g's" || lower == "gs") return "g";
        if (find_unit(candidate)) return std::string(candidate);
    }
    return "";
}

/// "ACCELERATION TIME HISTORY IN UNITS OF G" -> "G"; "The units are (g)" -> "g"; "TIME HISTORY (G'S)" -> "g".
std::string parse_unit(std::string_view header_line)
{
    const std::string line = text::lower_case(header_line);
    for (const std::string_view words : {"units of", "units are", "units", "unit", " in ", "("}) {
        std::size_t at = line.find(words);
        if (at == std::string::npos) continue;
        at = line.find_first_not_of("=: \t", at + words.size());
        const std::string unit = at == std::string::npos ? "" : leading_unit(header_line.substr(at));
        if (!unit.empty()) return unit;
    }
    return "";
}

struct FoundUnit {
    std::string text;      // empty: none
    std::size_t line = 0;  // 0-based; where one was expected when there is none
};

/// Nearest above the count; else on the line of the count itself.
FoundUnit find_unit_line(const SourceFile& file, std::size_t count_line)
{
    for (std::size_t i = count_line; i-- > 0;) {
        std::string unit = parse_unit(file.lines[i]);
        if (!unit.empty()) return {std::move(unit), i};
    }
    return {parse_unit(file.lines[count_line]), count_line - 1};
}

/// Adds a fault for "VELOCITY TIME SERIES IN UNITS OF G".
void check_quantity(const SourceFile& file, const FoundUnit& found, const Unit& unit, FaultList& faults)
{
    const std::string line = text::lower_case(file.lines[found.line]);
    for (const Quantity quantity : {Quantity::acceleration, Quantity::velocity, Quantity::displacement}) {
        if (unit.name.empty() || quantity == unit.quantity || !line.starts_with(to_text(quantity))) continue;
        faults.add(file.at(found.line), std::string(to_text(quantity)) + " in " + unit.name,
                   "kind and unit of the samples must agree");
    }
}

/// Lines of words may stand between the count and the samples.
std::size_t first_row(const SourceFile& file, std::size_t count_line)
{
    std::size_t row = count_line + 1;
    double number = 0;
    while (row < file.lines.size() && text::parse_leading_number(text::trim(file.lines[row]), number) == 0 &&
           row < count_line + header_search)
        ++row;
    return row;
}

/// What the title says: "Loma Prieta, 10/18/1989, Gilroy - Gavilan Coll., 67".
struct Title {
    std::string event, station, component;
};

/// It stands above the unit.
Title parse_title(const SourceFile& file, std::size_t unit_line)
{
    Title title;
    std::size_t i = unit_line;
    while (i > 1 && text::trim(file.lines[i - 1]).empty()) --i;
    if (i == 0) return title;
    const std::string_view line = file.lines[i - 1];
    const std::size_t comma = line.rfind(',');
    if (comma == std::string_view::npos) return title;
    title.component = std::string(text::trim(line.substr(comma + 1)));
    const std::string_view before = line.substr(0, comma);
    const std::size_t middle = before.rfind(',');
    const bool is_peer = text::lower_case(file.lines.front()).find("strong") != std::string::npos;
    if (!is_peer || middle == std::string_view::npos) return title;
    title.event = std::string(text::trim(before.substr(0, middle)));
    title.station = std::string(text::trim(before.substr(middle + 1)));
    return title;
}

/// "67", "180 (USGS STATION 117)", "UP", "DWN", "-V", "VERT".
void orient(Channel& channel, std::vector<std::string>& remarks)
{
    const std::string_view name = channel.component;
    double azimuth = 0;
    const std::size_t used = text::parse_leading_number(name, azimuth);
    const std::string_view rest = text::trim(name.substr(used));
    const bool is_azimuth = used > 0 && name.front() != '-' && azimuth >= 0 && azimuth <= 360 &&
                            (rest.empty() || rest.starts_with('(') || text::lower_case(rest).starts_with("deg"));
    const std::string word = text::lower_case(name.substr(0, name.find_first_of(" \t(")));
    if (is_azimuth)
        channel.azimuth = azimuth == 360 ? 0 : azimuth;
    else if (word == "dwn" || word == "down" || word == "dn")
        remarks.push_back("Component " + channel.component + " is positive downwards.");
    else
        orient_by_short_name(channel, word);
}

const char* format_of(Quantity quantity)
{
    if (quantity == Quantity::velocity) return "PEER VT2";
    return quantity == Quantity::displacement ? "PEER DT2" : "PEER AT2";
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const std::size_t count_line = *find_count_line(file);
    const std::optional<Announced> announced = parse_count_line(file.lines[count_line]);
    if (!announced) {
        faults.add(file.at(count_line), "\"" + std::string(text::trim(file.lines[count_line])) + "\"",
                   "write the count and the step as \"NPTS= 4000, DT= .01 SEC\"");
    }
    const FoundUnit found = find_unit_line(file, count_line);
    const Unit unit = resolve_unit(found.text, options, file.at(found.line), faults);
    check_quantity(file, found, unit, faults);
    std::vector<double> samples = read_fortran_samples(file, first_row(file, count_line), faults);
    double time_step = 1;
    if (announced) {
        time_step = resolve_time_step(announced->time_step, options, file.at(count_line), faults);
        check_count(announced->count, samples.size(), file.at(count_line), faults);
    }
    refuse_column(file, options, faults);
    faults.throw_if_any(file.name);
    const Title title = parse_title(file, found.line);
    Record record{file.name, format_of(unit.quantity), {}, title.station, title.event};
    record.channels.push_back(make_channel(title.component, unit, time_step, std::move(samples)));
    orient(record.channels.back(), record.remarks);
    return record;
}

}  // namespace

const Format peer_at2{"PEER AT2", recognises, read};

}  // namespace voussoir::records::formats
