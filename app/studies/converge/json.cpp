#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/settings.h"
#include "app/studies/converge/conclusion.h"
#include "app/studies/converge/report.h"
#include "app/studies/converge/verdict.h"
#include "app/version/version.h"

namespace voussoir::app::studies::converge
{
namespace
{

using Json = nlohmann::ordered_json;

/// JSON knows no infinity: what is not known is null.
Json or_null(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json or_null(const std::optional<double>& value)
{
    return value ? or_null(*value) : Json(nullptr);
}

Json to_json(const Series& series, const SeriesRow& row)
{
    return {{"integrator", results::name_of(row.setting.integrator)},
            {"time_step_s", row.time_step},
            {"time_step_factor", row.setting.step_factor},
            {"stiffness_factor", row.setting.stiffness_factor},
            {"value", or_null(row.value)},
            {"error", or_null(row.error)},
            {"error_with_uncertainty", row.error ? or_null(*row.error + series.uncertainty) : Json(nullptr)},
            {"change_to_next", or_null(row.difference)},
            {"cpu_time_s", row.cost.cpu()},
            {"cpu_time_static_s", row.cost.cpu_static},
            {"steps", row.cost.steps},
            {"step_cuts", row.cost.step_cuts},
            {"iterations", row.cost.iterations},
            {"collapse_time_s", row.collapse ? Json(row.collapse->time) : Json(nullptr)},
            {"failure", row.failure}};
}

/// The place in `rows` of the cheapest setting for each tolerance, null when none meets it.
Json cheapest_rows(const Series& series)
{
    Json list = Json::array();
    for (const double tolerance : tolerances) {
        const SeriesRow* row = cheapest(series, tolerance);
        list.push_back({{"tolerance", tolerance}, {"row", row ? Json(row - series.rows.data()) : Json(nullptr)}});
    }
    return list;
}

Json to_json(const Series& series)
{
    const bool of_stiffness = series.varied == Varied::stiffness;
    Json rows = Json::array();
    for (const SeriesRow& row : series.rows) rows.push_back(to_json(series, row));
    return {{"varies", of_stiffness ? "contact_stiffness" : "time_step"},
            {"rows", rows},
            {"order", or_null(series.order)},
            {"no_order", series.no_order},
            {"reference", !series.reference ? Json(nullptr) : Json(series.order ? "extrapolated" : "finest")},
            {"reference_value", or_null(series.reference)},
            {"reference_uncertainty", or_null(series.uncertainty)},
            {"reference_vanishes", series.vanishes},
            {"scale", series.scale},
            {"change_per_doubling", of_stiffness ? or_null(change_per_doubling(series)) : Json(nullptr)},
            {"cheapest", cheapest_rows(series)},
            {"notes", series.notes}};
}

Json to_json(const Conclusion& conclusion)
{
    Json known = Json::array();
    for (const KnownQuantity& each : conclusion.known)
        known.push_back({{"quantity", each.name},
                         {"value", or_null(each.value)},
                         {"within", or_null(each.within)},
                         {"why_not_known", each.why_not}});
    Json json = {{"tolerance", conclusion.tolerance}, {"meets", conclusion.meets}, {"setting", nullptr}};
    if (conclusion.row)
        json["setting"] = {{"integrator", results::name_of(conclusion.row->setting.integrator)},
                           {"time_step_s", conclusion.row->time_step},
                           {"time_step_factor", conclusion.row->setting.step_factor},
                           {"stiffness_factor", conclusion.row->setting.stiffness_factor},
                           {"cpu_time_s", conclusion.row->cost.cpu()}};
    json["known"] = known;
    json["case_lines"] = conclusion.case_lines;
    json["set"] = conclusion.set_options;
    json["joint_lines"] = conclusion.joint_lines;
    json["remarks"] = conclusion.remarks;
    return json;
}

}  // namespace

std::string converge_json(const ConvergeStudy& study)
{
    Json quantities = Json::array();
    for (const QuantityStudy& quantity : study.quantities) {
        Json series = Json::array();
        for (const Series& each : quantity.series) series.push_back(to_json(each));
        quantities.push_back(
            {{"quantity", quantity.name}, {"unit", quantity.unit}, {"added", quantity.added}, {"series", series}});
    }
    const Json json = {{"case", study.case_file},
                       {"title", study.title},
                       {"overrides", study.overrides},
                       {"collapse", study.collapse_rule},
                       {"threads", study.threads},
                       {"notes", study.notes},
                       {"conclusion", to_json(conclude(study))},
                       {"engine", Json::parse(version::engine_json())},
                       {"quantities", quantities}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace voussoir::app::studies::converge
