#include "app/report/base_shear.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/sections.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

bool any_bar_at_supports(const RunRecord& record)
{
    const std::vector<bool> support = foundation_marks(record.results.model);
    return std::any_of(record.bars.begin(), record.bars.end(), [&](const BarCourse& bar) {
        return support[static_cast<std::size_t>(bar.block_a)] != support[static_cast<std::size_t>(bar.block_b)];
    });
}

}  // namespace

double weight_of(const RunRecord& record)
{
    const Json stages = Json::parse(record.settings);
    if (stages.empty()) return 0;
    const std::vector<bool> support = foundation_marks(record.results.model);
    double mass = 0;
    for (std::size_t b = 0; b < support.size(); ++b)
        if (!support[b]) mass += record.mass[b];
    double square = 0;
    for (const Json& component : stages.back().at("gravity_m_s2"))
        square += component.get<double>() * component.get<double>();
    return mass * std::sqrt(square);
}

std::optional<Peak> base_shear_of(const RunRecord& record)
{
    const double weight = weight_of(record);
    if (!(weight > 0) || record.results.model.foundations.empty()) return std::nullopt;
    Peak peak;
    for (std::size_t i = 0; i < record.course.times.size(); ++i)
        peak.see(record.course.base_force[i].head<2>().norm() / weight, record.course.times[i]);
    return peak;
}

std::vector<std::string> base_shear_row(const RunRecord& record)
{
    const std::optional<Peak> shear = base_shear_of(record);
    if (!shear || !(shear->value > 0)) return {};
    return {"largest base shear",
            fmt::format("{:.3g} of the weight, {} kN, at t = {:.3g} s", shear->value,
                        figure(shear->value * weight_of(record) / 1e3), shear->time),
            any_bar_at_supports(record) ? "joints of the supports; what bars carry there comes on top"
                                        : "joints of the supports"};
}

}  // namespace voussoir::app::report
