// PEER's AT2 (acceleration), VT2 and DT2: four header lines, then the samples, five or eight on a line.
//
//   PEER NGA STRONG MOTION DATABASE RECORD
//   Loma Prieta, 10/18/1989, Gilroy - Gavilan Coll., 67        <- component after the last comma
//   ACCELERATION TIME SERIES IN UNITS OF G                     <- unit
//   NPTS=   7999, DT=   .0050 SEC,                             <- or, older:  4096    0.0100    NPTS, DT
//
// Source: PEER NGA-West2 flat files and the older PEER Strong Motion Database, read from their own headers.

#include <optional>

#include "records/formats/format.h"
#include "records/numbers.h"

namespace voussoir
{

namespace
{

constexpr std::size_t header_search = 12;  // lines; the count stands on the fourth in every file seen

/// 0-based line that announces NPTS and DT.
std::optional<std::size_t> find_count_line(const SourceFile& file)
{
    for (std::size_t i = 1; i < file.lines.size() && i < header_search; ++i) {
        const std::string line = lower_case(file.lines[i]);
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

/// The number after "KEY=", and what follows it up to the next comma in `rest`.
bool number_after(const std::string& line, std::string_view key, double& value, std::string_view& rest)
{
    const std::size_t at = line.find(key);
    if (at == std::string::npos) return false;
    rest = trim(std::string_view(line).substr(at + key.size()));
    if (rest.empty() || rest.front() != '=') return false;
    rest = trim(rest.substr(1));
    const std::size_t used = parse_leading_number(rest, value);
    rest = trim(rest.substr(used));
    rest = trim(rest.substr(0, rest.find(',')));
    return used > 0;
}

/// "NPTS= 4000, DT= .01000 SEC" or "4096 0.0100 NPTS, DT".
std::optional<Announced> parse_count_line(std::string_view text)
{
    const std::string line = lower_case(text);
    Announced announced;
    std::string_view rest;
    if (number_after(line, "npts", announced.count, rest)) {
        const bool has_step = number_after(line, "dt", announced.time_step, rest);
        const bool in_seconds = rest.empty() || rest == "s" || rest.substr(0, 3) == "sec";
        if (has_step && in_seconds) return announced;
        return std::nullopt;
    }
    std::vector<double> numbers;
    if (parse_separated(std::string_view(line).substr(0, line.find("npts")), numbers) && numbers.size() == 2) {
        return Announced{numbers[0], numbers[1]};
    }
    return std::nullopt;
}

/// "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: ..." -> "G"; "The units are (g)" -> "g".
std::string parse_unit(std::string_view header_line)
{
    const std::string line = lower_case(header_line);
    for (const std::string_view words : {"units of", "units are", "units:"}) {
        const std::size_t at = line.find(words);
        if (at == std::string::npos) continue;
        std::string_view unit = trim(header_line.substr(at + words.size()));
        unit = trim(unit.substr(0, unit.find_first_of(".,;")));
        if (unit.size() > 2 && unit.front() == '(' && unit.back() == ')') unit = unit.substr(1, unit.size() - 2);
        return std::string(trim(unit));
    }
    return "";
}

std::string parse_component(std::string_view title)
{
    const std::size_t comma = title.rfind(',');
    return comma == std::string_view::npos ? "" : std::string(trim(title.substr(comma + 1)));
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const std::size_t count_line = *find_count_line(file);
    const std::size_t unit_line = count_line - 1;
    const std::optional<Announced> announced = parse_count_line(file.lines[count_line]);
    if (!announced) {
        faults.add(file.at(count_line), "\"" + std::string(trim(file.lines[count_line])) + "\"",
                   "write the count and the step as \"NPTS= 4000, DT= .01 SEC\"");
    }
    const Unit unit = resolve_unit(parse_unit(file.lines[unit_line]), options, file.at(unit_line), faults);
    std::vector<double> samples = read_fortran_samples(file, count_line + 1, faults);
    double time_step = 1;
    if (announced) {
        time_step = resolve_time_step(announced->time_step, options, file.at(count_line), faults);
        check_count(announced->count, samples.size(), file.at(count_line), faults);
    }
    if (options.column)
        faults.add(file.name, "a column was asked for", "PEER AT2 holds one component: leave it out");
    faults.throw_if_any(file.name);
    const std::string component = count_line >= 2 ? parse_component(file.lines[count_line - 2]) : "";
    return {file.name, "PEER AT2", {make_channel(component, unit, time_step, std::move(samples))}};
}

}  // namespace

const Format peer_at2{"PEER AT2", recognises, read};

}  // namespace voussoir
