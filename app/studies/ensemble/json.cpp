#include <cmath>
#include <nlohmann/json.hpp>

#include "app/studies/ensemble/report.h"
#include "app/version/version.h"

namespace voussoir::app::studies::ensemble
{

namespace
{

using Json = nlohmann::ordered_json;

/// JSON knows no infinity: what is not known, or beyond all bounds, is null.
Json or_null(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json or_null(const std::vector<double>& values)
{
    Json list = Json::array();
    for (const double value : values) list.push_back(or_null(value));
    return list;
}

Json to_json(const EnsembleStudy& study, const MemberRun& run)
{
    return {{"member", study.variation.values[run.member]},
            {"setting", run.setting},
            {"steps", run.steps},
            {"step_cuts", run.step_cuts},
            {"iterations", run.iterations},
            {"cpu_time_s", run.cpu},
            {"cpu_time_dynamic_s", run.cpu_dynamic},
            {"simulated_time_s", run.simulated},
            {"joints", run.joints},
            {"energy_put_in_J", run.energy.input},
            {"energy_residual", run.energy.residual},
            {"algorithmic_fraction", run.energy.algorithmic},
            {"friction_fraction", run.energy.friction},
            {"damping_fraction", run.energy.damping},
            {"algorithmic_share", run.energy.algorithmic},  // former names, for one release
            {"friction_share", run.energy.friction},
            {"damping_share", run.energy.damping},
            {"collapse_time_s", run.collapse ? Json(run.collapse->time) : Json(nullptr)},
            {"collapse_block", run.collapse ? Json(run.collapse->block) : Json(nullptr)},
            {"failure", run.failure},
            {"warnings", run.warnings}};
}

Json to_json(const MeasureStudy& study)
{
    Json values = Json::array();
    for (const std::vector<double>& each : study.values) values.push_back(or_null(each));
    return {{"measure", study.measure.name},
            {"unit", study.measure.unit},
            {"values", values},
            {"medians", or_null(study.medians)},
            {"spreads", or_null(study.ranges)},
            {"difference", or_null(study.difference)},
            {"allowed", or_null(study.allowed)},
            {"agrees", study.agrees}};
}

}  // namespace

std::string ensemble_json(const EnsembleStudy& study)
{
    Json settings = Json::array(), runs = Json::array(), measures = Json::array();
    for (const converge::ConvergeSetting& each : study.settings)
        settings.push_back(
            {{"time_step_s", each.step_factor * study.time_step}, {"stiffness_factor", each.stiffness_factor}});
    for (const auto& row : study.runs)
        for (const MemberRun& run : row) runs.push_back(to_json(study, run));
    for (const MeasureStudy& each : study.measures) measures.push_back(to_json(each));
    const Json json = {{"case", study.case_file},
                       {"title", study.title},
                       {"engine", Json::parse(version::engine_json())},
                       {"overrides", study.overrides},
                       {"warnings", study.warnings},
                       {"varied", study.variation.key},
                       {"members", study.variation.values},
                       {"open_limit_m", study.choices.limit},
                       {"tolerance", study.choices.tolerance},
                       {"jobs", study.choices.jobs},
                       {"settings", settings},
                       {"agrees", study.agrees()},
                       {"verdict", verdict_of(study)},
                       {"measures", measures},
                       {"runs", runs}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace voussoir::app::studies::ensemble
