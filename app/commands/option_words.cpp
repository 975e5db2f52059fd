#include "app/commands/option_words.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "libdda/errors.h"

namespace voussoir::app::commands
{

double read_positive(const std::string& option, const std::string& text, const words::Dimension& dimension)
{
    const words::ParsedQuantity quantity = words::parse_quantity(text);
    if (!quantity.problem.empty() || !quantity.has(dimension) || !(quantity.value > 0))
        throw InputError(option, "\"" + text + "\" is not " + std::string(dimension.name) + " above 0",
                         "write one, as " + std::string(dimension.example));
    return quantity.value;
}

std::string shell_word(const std::string& word)
{
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 ||
               std::string_view("_-./=,:+%@").find(static_cast<char>(c)) != std::string::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string folder_option(const std::filesystem::path& folder)
{
    return " -o " + shell_word((folder / "").parent_path().filename().string());
}

}  // namespace voussoir::app::commands
