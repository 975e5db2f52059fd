#include "app/studies/stability/cell_wire.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace voussoir::app::studies::stability
{
namespace
{

using nlohmann::json;

/// JSON has no NaN and no infinity.
json number_or_null(double value)
{
    return std::isfinite(value) ? json(value) : json(nullptr);
}

double number_or_nan(const json& value)
{
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

json to_json(const CellResult& result)
{
    const StabilityCell& cell = result.cell;
    const CellRun& run = result.run;
    json parameters = json::object();
    for (const CellParameter& parameter : cell.parameters) parameters[parameter.name] = in_words(parameter);
    return {{"name", cell.name},
            {"scene", cell.scene},
            {"parameters", parameters},
            {"time_step_s", cell.time_step},
            {"outcome", name_of(result.outcome)},
            {"reference", cell.reference},
            {"error", has_error(result.outcome) ? number_or_null(run.error) : json(nullptr)},
            {"tolerance", cell.tolerance},
            {"diagnosis", result.diagnosis},
            {"warning", run.warning},
            {"note", run.note},
            {"steps", run.steps},
            {"step_cuts", run.step_cuts},
            {"iterations", run.iterations},
            {"cpu_time_s", run.cpu_time},
            {"budget_s", cell.budget},
            {"energy_residual", number_or_null(run.energy_residual)},
            {"max_penetration_m", number_or_null(run.max_penetration)}};
}

/// Messages may hold anything: what is no UTF-8 in them is replaced.
std::string text_of(const json& value, int indent)
{
    return value.dump(indent, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const CellRequest& request)
{
    return text_of({{"name", request.name}, {"budget", request.budget}, {"memory", request.memory}}, -1);
}

CellRequest cell_request_from_json(const std::string& text)
{
    const json value = json::parse(text);
    return {value.at("name").get<std::string>(), value.at("budget").get<double>(),
            value.at("memory").get<std::size_t>()};
}

std::string to_json(const CellRun& run)
{
    return text_of({{"error", number_or_null(run.error)},
                    {"refusal", run.refusal},
                    {"diagnosis", run.diagnosis},
                    {"warning", run.warning},
                    {"note", run.note},
                    {"steps", run.steps},
                    {"step_cuts", run.step_cuts},
                    {"iterations", run.iterations},
                    {"cpu_time", run.cpu_time},
                    {"energy_residual", number_or_null(run.energy_residual)},
                    {"max_penetration", number_or_null(run.max_penetration)}},
                   -1);
}

CellRun cell_run_from_json(const std::string& text)
{
    const json value = json::parse(text);
    CellRun run;
    run.error = number_or_nan(value.at("error"));
    run.refusal = value.at("refusal").get<std::string>();
    run.diagnosis = value.at("diagnosis").get<std::string>();
    run.warning = value.at("warning").get<std::string>();
    run.note = value.at("note").get<std::string>();
    run.steps = value.at("steps").get<std::int64_t>();
    run.step_cuts = value.at("step_cuts").get<std::int64_t>();
    run.iterations = value.at("iterations").get<std::int64_t>();
    run.cpu_time = value.at("cpu_time").get<double>();
    run.energy_residual = number_or_nan(value.at("energy_residual"));
    run.max_penetration = number_or_nan(value.at("max_penetration"));
    return run;
}

std::string stability_json(const std::vector<CellResult>& results, const std::string& engine)
{
    json cells = json::array();
    for (const CellResult& result : results) cells.push_back(to_json(result));
    return text_of({{"cells", cells}, {"engine", json::parse(engine)}}, 2);
}

}  // namespace voussoir::app::studies::stability
