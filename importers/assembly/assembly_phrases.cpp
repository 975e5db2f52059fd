#include "importers/assembly/assembly_phrases.h"

#include <fmt/format.h>

#include <cmath>

#include "importers/assembly/assembly_words.h"

namespace voussoir::importers::assembly
{

std::string plural(std::size_t count, const std::string& word)
{
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

const char* verb(std::size_t count, const char* of_one, const char* of_more)
{
    return count == 1 ? of_one : of_more;
}

std::string names_of(const Assembly& assembly, const std::vector<int>& stones)
{
    constexpr std::size_t names_given = 4;
    std::string words;
    for (std::size_t i = 0; i < std::min(stones.size(), names_given); ++i)
        words += (i == 0 ? "" : ", ") + assembly.stones[stones[i]].name;
    if (stones.size() > names_given) words += fmt::format(" and {} more", stones.size() - names_given);
    return words;
}

std::string pair_words(const Assembly& assembly, int a, int b)
{
    return assembly.stones[a].name + " and " + assembly.stones[b].name;
}

std::string close_joints_words(double widest, const AssemblyOrigin& origin)
{
    const std::string width = length_words(closing_width(widest));
    if (origin.from_case) return "close_joints: " + width + " in the mesh entry of the case";
    std::string option = width;
    option.erase(std::remove(option.begin(), option.end(), ' '), option.end());
    return "--close-joints " + option;
}

std::string length_words(double metres)
{
    const double size = std::abs(metres);
    if (size == 0) return "0 mm";
    if (size < 1e-5) return fmt::format("{:.3g} um", metres * 1e6);
    if (size < 0.9995) return fmt::format("{:.3g} mm", metres * 1e3);
    return size < 100 ? fmt::format("{:.3g} m", metres) : fmt::format("{:.0f} m", metres);
}

double closing_width(double widest)
{
    const double digit = std::pow(10.0, std::floor(std::log10(widest)) - 1);
    return std::ceil(widest / digit * (1 + 1e-12)) * digit;
}

}  // namespace voussoir::importers::assembly
