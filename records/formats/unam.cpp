// "Archivo estandar de aceleracion" (ASA) of the Instituto de Ingenieria, UNAM, and other networks of Mexico: a
// header of lines "CLAVE : valor", whose values for the channels are separated by slashes, then a column of
// samples for each channel:
//
//   ORIENTACION C1-C6 (rumbo;orientacion)  : /V/N90E/N00E
//   INTERVALO DE MUESTREO, C1-C6 (s)       : /0.01/0.01/0.01
//   NUM. TOTAL DE MUESTRAS, C1-C6          : /2455/2455/2455      files hold one more: told, not refused
//   UNIDADES DE LOS DATOS                  : Gal (cm/s/s)
//
// Written from the headers of files of the Mexican strong-motion data base (version 2.0).

#include <algorithm>
#include <cmath>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "UNAM (ASA)";
constexpr std::size_t longest_header = 300;  // lines; 109 in the files seen
constexpr std::size_t title_search = 30;     // lines

bool begins_data(std::string_view line)
{
    return letters_and_digits(line) == "datosdeaceleracion";
}

KeyedHeader read_header(const SourceFile& file)
{
    KeyedHeader header = read_keyed_header(file, 0, longest_header, begins_data);
    while (header.end < file.lines.size() && !is_row_of_numbers(file.lines[header.end])) ++header.end;
    return header;
}

bool recognises(const SourceFile& file)
{
    if (!is_text(file)) return false;
    const std::size_t last = std::min(file.lines.size(), title_search);
    return std::any_of(file.lines.begin(), file.lines.begin() + static_cast<std::ptrdiff_t>(last), [](auto line) {
        return letters_and_digits(line).find("archivoestandardeaceleracion") != std::string::npos;
    });
}

/// Values of channels 1 to 6 and 7 to 12: "/V/N90E/N00E" -> V, N90E, N00E.
std::vector<std::string> values_of(const KeyedHeader& header, const std::string& key)
{
    std::vector<std::string> values;
    for (const char* channels : {"C1-C6", "C7-C12"}) {
        const std::string text = text_of(header.find_beginning(key + channels));
        std::string_view rest = text;
        while (!rest.empty()) {
            if (rest.front() == '/') rest.remove_prefix(1);
            const std::string_view value = rest.substr(0, rest.find('/'));
            if (!text::trim(value).empty()) values.emplace_back(text::trim(value));
            rest.remove_prefix(value.size());
        }
    }
    return values;
}

/// The value of one channel as a number; a single value stands for all. 0 when there is none.
double value_for(const std::vector<std::string>& values, std::size_t channel)
{
    double number = 0;
    if (values.empty() || channel >= values.size()) return 0;
    return text::parse_fortran_number(values[channel], number) ? number : 0;
}

/// "N90E", "S00W" -> azimuth; "V" -> vertical. What follows a semicolon is not a bearing.
void orient(Channel& channel, std::string_view name)
{
    const std::string bearing = text::lower_case(text::trim(name.substr(0, name.find(';'))));
    double angle = 0;
    const std::size_t used =
        bearing.empty() ? 0 : text::parse_leading_number(std::string_view(bearing).substr(1), angle);
    const std::string_view side = used > 0 ? text::trim(std::string_view(bearing).substr(1 + used)) : "";
    const bool is_bearing = (bearing[0] == 'n' || bearing[0] == 's') && (side == "e" || side == "w");
    if (used == 0 || !is_bearing || !(angle >= 0 && angle <= 90)) return orient_by_short_name(channel, bearing);
    const double east = side == "e" ? angle : -angle;
    channel.azimuth = std::fmod(360 + (bearing[0] == 'n' ? east : 180 - east), 360);
}

/// The lines after "CALIDAD DEL ACELEROGRAMA", up to the ruler, as one.
std::string quality_of(const SourceFile& file, const KeyedHeader& header)
{
    const HeaderLine* title = header.find("CALIDAD DEL ACELEROGRAMA");
    std::string quality = text_of(title);
    for (std::size_t i = title == nullptr ? header.end : title->line + 1; i < header.end; ++i) {
        const std::string_view line = text::trim(file.lines[i]);
        if (line.starts_with("===")) break;
        if (!line.empty()) quality += (quality.empty() ? "" : " ") + std::string(line);
    }
    return quality;
}

void add_remarks(Record& record, const SourceFile& file, const KeyedHeader& header)
{
    const std::optional<double> decimation = number_of(header.find("FACTOR DE DECIMACION"));
    if (decimation && *decimation != 1)
        record.remarks.push_back("The header names a decimation factor of " + text::to_text(*decimation) +
                                 "; the time step is the header's sampling interval as it stands.");
    const std::string quality = quality_of(file, header);
    if (!quality.empty()) record.remarks.push_back("The network on this record's quality: \"" + quality + "\".");
}

/// The directions of the channels; of those without a column of samples nothing is left but a remark.
std::vector<std::string> names_of_columns(const SourceFile& file, const KeyedHeader& header,
                                          std::vector<std::string>& remarks)
{
    std::vector<std::string> names = values_of(header, "ORIENTACION ");
    std::vector<double> first_row;
    const bool has_row = header.end < file.lines.size() && text::parse_fortran(file.lines[header.end], first_row);
    if (has_row && first_row.size() < names.size()) {
        remarks.push_back("The header names " + std::to_string(names.size()) + " channels but the file holds " +
                          std::to_string(first_row.size()) + ": the first of them are taken.");
        names.resize(first_row.size());
    }
    return names;
}

/// One channel a column; counts and steps are announced for each.
void add_channels(Record& record, const SourceFile& file, const KeyedHeader& header, const ReadOptions& options,
                  FaultList& faults)
{
    const std::vector<std::string> names = names_of_columns(file, header, record.remarks);
    const std::vector<std::string> steps = values_of(header, "INTERVALO DE MUESTREO ");
    const std::vector<std::string> counts = values_of(header, "NUM. TOTAL DE MUESTRAS ");
    const HeaderLine* units = header.find("UNIDADES DE LOS DATOS");
    const HeaderLine* step_line = header.find_beginning("INTERVALO DE MUESTREO");
    const HeaderLine* count_line = header.find_beginning("NUM. TOTAL DE MUESTRAS");
    if (names.empty())
        faults.add(place_of(file, header.find_beginning("ORIENTACION")), "no channels in ORIENTACION C1-C6",
                   "one direction for each column");
    const std::string unit_words = text_of(units);
    const Unit unit =
        resolve_unit(unit_words.substr(0, unit_words.find('(')), options, place_of(file, units), faults);
    faults.throw_if_any(file.name);
    std::vector<std::vector<double>> columns = read_columns(file, header.end, names.size(), faults);
    faults.throw_if_any(file.name);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double time_step =
            resolve_time_step(value_for(steps, i), options, place_of(file, step_line), faults);
        std::vector<std::string> remarks;
        check_count_with_surplus(value_for(counts, i), columns[i].size(), 1, place_of(file, count_line), faults,
                                 remarks);
        if (i == 0) record.remarks.insert(record.remarks.end(), remarks.begin(), remarks.end());
        record.channels.push_back(make_channel(names[i], unit, time_step, std::move(columns[i])));
        orient(record.channels.back(), names[i]);
    }
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const KeyedHeader header = read_header(file);
    Record record{file.name,
                  format_name,
                  {},
                  text_of(header.find("CLAVE DE LA ESTACION")),
                  text_of(header.find_beginning("FECHA DEL SISMO"))};
    refuse_column(file, options, faults);
    add_channels(record, file, header, options, faults);
    faults.throw_if_any(file.name);
    add_remarks(record, file, header);
    return record;
}

}  // namespace

const Format unam{format_name, recognises, read};

}  // namespace voussoir::records::formats
