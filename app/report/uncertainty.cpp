#include "app/report/uncertainty.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "app/words/figures_in_words.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

constexpr const char* not_known = "not known";

/// "0.12 mm (3.4 %) with half the time step, ..."; empty where neither of the runs beside was made.
std::string in_words(const Json& quantity)
{
    std::string text;
    for (const auto& [key, what] : {std::pair{"half_step", "half the time step"},
                                    std::pair{"twice_stiffness", "twice the contact stiffness"}}) {
        if (!quantity.contains(key)) continue;
        const Json& relative = quantity.at(key).at("relative");
        const std::string share =
            relative.is_number() ? fmt::format(" ({})", words::percent_in_words(relative.get<double>())) : "";
        text += fmt::format("{}± {}{} with {}", text.empty() ? "" : ", ",
                            words::length_in_words(quantity.at(key).at("difference").get<double>()), share, what);
    }
    return text;
}

std::string uncertainty_of(const Json& summary, const std::string& name)
{
    if (!summary.contains("error_estimate") || !summary.at("error_estimate").contains("quantities"))
        return not_known;
    for (const Json& quantity : summary.at("error_estimate").at("quantities")) {
        if (quantity.at("name") != name || quantity.at("unit") != "m") continue;
        const std::string text = in_words(quantity);
        return text.empty() ? not_known : text;
    }
    return not_known;
}

}  // namespace

void add_uncertainty(const std::string& summary, Table& table)
{
    const Json all = Json::parse(summary);
    table.columns.emplace_back("uncertainty");
    for (std::vector<std::string>& row : table.rows) row.push_back(uncertainty_of(all, row.front()));
}

}  // namespace voussoir::app::report
