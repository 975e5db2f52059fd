#include "app/studies/verify/verify_json.h"

#include <nlohmann/json.hpp>

#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{
namespace
{

using nlohmann::json;

json number_or_null(const std::optional<double>& value)
{
    return value ? json(*value) : json(nullptr);
}

json error_of(const VerifyResult& result)
{
    return result.failure.empty() ? json(result.error) : json(nullptr);
}

json to_json(const VerifyRow& row)
{
    const VerifyResult& result = row.result;
    return {{"method", method_name(row.setting)},
            {"time_step_s", row.setting.time_step},
            {"stiffness_factor", number_or_null(row.setting.stiffness_factor)},
            {"error", error_of(result)},
            {"paper_measure", number_or_null(result.paper_measure)},
            {"cpu_time_s", result.cpu_time},
            {"simulated_time_s", result.simulated_time},
            {"steps", result.steps},
            {"step_cuts", result.step_cuts},
            {"iterations", result.iterations},
            {"failure", result.failure}};
}

json to_json(const Companion& companion)
{
    json row = to_json(companion.row);
    row["distance"] = number_or_null(companion.distance);
    return row;
}

json to_json(const VerifyOutcome& outcome)
{
    const Benchmark& benchmark = outcome.benchmark;
    json rows = json::array(), orders = json::object(), companions = json::array();
    for (const Companion& companion : outcome.companions) companions.push_back(to_json(companion));
    for (const VerifyRow& row : outcome.rows) rows.push_back(to_json(row));
    for (const ObservedOrder& order : outcome.orders) orders[order.method] = order.order;
    return {{"benchmark", benchmark.name},
            {"title", benchmark.title},
            {"source", benchmark.source},
            {"quantity", benchmark.quantity},
            {"choices", benchmark.choices},
            {"rows", rows},
            {"companions", companions},
            {"observed_orders", orders},
            {"time_step_s", outcome.row.setting.time_step},
            {"error", error_of(outcome.row.result)},
            {"failure", outcome.row.result.failure},
            {"tolerance", benchmark.tolerance},
            {"paper_error", benchmark.paper_error},
            {"paper_error_value", number_or_null(benchmark.paper_level)},
            {"paper_measure", number_or_null(outcome.row.result.paper_measure)},
            {"cpu_s_per_simulated_s", cpu_share(outcome.row.result)},
            {"note", outcome.row.result.note},
            {"pass", outcome.pass}};
}

}  // namespace

std::string verify_json(const std::vector<VerifyOutcome>& outcomes)
{
    json list = json::array();
    for (const VerifyOutcome& outcome : outcomes) list.push_back(to_json(outcome));
    return list.dump(2);
}

}  // namespace voussoir::app::studies::verify
