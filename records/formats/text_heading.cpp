#include "records/formats/text_heading.h"

#include <algorithm>
#include <initializer_list>

#include "libdda/errors.h"
#include "libdda/text/words.h"

namespace voussoir::records::formats
{

namespace
{

/// The words of the lines above the first row, in lower case.
std::vector<std::string> heading_words(const SourceFile& file, std::size_t first_row)
{
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < first_row; ++i) {
        for (const char c : text::lower_case(file.lines[i]) + " ") {
            if (c >= 'a' && c <= 'z')
                words.back() += c;
            else if (!words.back().empty())
                words.emplace_back();
        }
    }
    return words;
}

/// The last line above the first row that holds anything, without the sign of a comment.
std::string_view last_heading(const SourceFile& file, std::size_t first_row)
{
    while (first_row-- > 0) {
        std::string_view line = text::trim(file.lines[first_row]);
        while (!line.empty() && std::string_view("#%!/ \t").find(line.front()) != std::string_view::npos)
            line.remove_prefix(1);
        if (!line.empty()) return line;
    }
    return "";
}

}  // namespace

void refuse_spectra(const SourceFile& file, std::size_t first_row)
{
    const std::vector<std::string> words = heading_words(file, first_row);
    const auto have = [&](std::initializer_list<std::string_view> any) {
        return std::find_first_of(words.begin(), words.end(), any.begin(), any.end()) != words.end();
    };
    const bool of_period = have({"period", "periods", "per", "t"});
    const bool of_frequency = have({"freq", "frequency"});
    const bool of_response = have({"sa", "psa", "sv", "psv", "sd", "prv", "paa", "spectral"});
    const bool of_damping = have({"damping", "damped"});
    const bool named = have({"spectrum", "spectra"});
    const bool names_response = named && have({"response", "pseudo", "fourier"});
    const int signs = int{of_period} + int{of_frequency} + int{of_response} + int{of_damping} + int{named};
    const bool is_damping_of_instrument = signs == 2 && of_frequency && of_damping;
    const bool of_time = have({"time", "times", "accelerogram", "accelerograph", "instrument", "natural", "npts"});
    if (!names_response && (signs < 2 || is_damping_of_instrument || of_time)) return;
    throw InputError(file.name, "response spectra, not a time history",
                     "use the record from which the spectra were computed");
}

std::size_t named_time_column(const SourceFile& file, std::size_t first_row, std::size_t width)
{
    const std::string_view heading = last_heading(file, first_row);
    const char separator = heading.find(';') != std::string_view::npos   ? ';'
                           : heading.find(',') != std::string_view::npos ? ','
                                                                         : '\t';
    const auto cells = static_cast<std::size_t>(std::count(heading.begin(), heading.end(), separator)) + 1;
    // An index often has no name: trimmed away with its tab.
    std::size_t column = cells + 1 == width && separator == '\t' ? 1 : 0;
    if (cells < 2 || cells + column != width) return 0;
    std::string_view rest = heading;
    for (; column < width; ++column) {
        const std::string name = text::lower_case(text::trim(rest.substr(0, rest.find(separator))));
        if (name.starts_with("time") || name == "t" || name.starts_with("t (") || name.starts_with("t["))
            return column;
        rest.remove_prefix(std::min(rest.find(separator), rest.size() - 1) + 1);
    }
    return 0;
}

void remark_on_heading(const SourceFile& file, std::size_t first_row, const Unit& unit,
                       std::vector<std::string>& remarks)
{
    const std::string_view heading = last_heading(file, first_row);
    if (!unit.name.empty() || heading.empty()) return;
    remarks.push_back("The heading is \"" + std::string(heading.substr(0, 60)) +
                      "\", but no unit is taken from the words of a table: give the unit.");
}

}  // namespace voussoir::records::formats
