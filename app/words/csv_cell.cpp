#include "app/words/csv_cell.h"

#include "libdda/text/numbers.h"

namespace voussoir::app::words
{

std::string csv_cell(std::string_view text)
{
    constexpr std::string_view begins_formula = "=+-@\t\r\n";
    const bool is_formula =
        !text.empty() && begins_formula.find(text.front()) != std::string_view::npos && !text::parse_finite(text);
    std::string safe = is_formula ? "'" : "";
    safe += text;
    if (safe.find_first_of(",\"\n\r") == std::string::npos) return safe;
    std::string quoted = "\"";
    for (const char c : safe) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace voussoir::app::words
