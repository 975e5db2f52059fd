#include "app/studies/verify/runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{
namespace
{

// The same scene in other unknowns must agree to a tenth of the benchmark's tolerance, and need not agree to more
// than the force tolerance of a step.
constexpr double least_agreement = 1e-5;
// Errors below what a step leaves unbalanced are not the time step's: they have no order.
constexpr double no_order_below = 1e-5;

/// Whatever goes wrong becomes a row that says so.
VerifyResult run_once(const Benchmark& benchmark, const scenes::SceneSetting& setting)
{
    VerifyResult result;
    try {
        result = benchmark.run(setting);
    } catch (const std::exception& error) {
        result.failure = error.what();
    }
    if (result.failure.empty() && !std::isfinite(result.error)) result.failure = "the error is not a number";
    return result;
}

VerifyResult median_of_three(const Benchmark& benchmark, const scenes::SceneSetting& setting)
{
    VerifyResult result = run_once(benchmark, setting);
    if (!result.failure.empty()) return result;
    std::array<double, 3> times{result.cpu_time, run_once(benchmark, setting).cpu_time,
                                run_once(benchmark, setting).cpu_time};
    std::sort(times.begin(), times.end());
    result.cpu_time = times[1];
    return result;
}

/// max |a - b| / max |b|; infinite when they are not of one kind, not a number when one of them is none.
double distance_of(const std::vector<double>& a, const std::vector<double>& b)
{
    if (a.size() != b.size()) return INFINITY;
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double apart = std::abs(a[i] - b[i]);
        if (!(apart <= worst)) worst = apart;
        largest = std::max(largest, std::abs(b[i]));
    }
    return worst == 0 ? 0 : worst / largest;
}

/// Compares with the default row or the first companion that has the same kind of block, rigid or deformable;
/// nothing when the benchmark has no answer to compare, only statements that hold or do not.
std::optional<double> distance_from_first(const VerifyRow& row, const VerifyOutcome& outcome)
{
    if (row.result.answer.empty()) return std::nullopt;
    const auto same = [&](const VerifyRow& other) {
        return is_deformable(other.setting.kinematics) == is_deformable(row.setting.kinematics);
    };
    if (same(outcome.row)) return distance_of(row.result.answer, outcome.row.result.answer);
    for (const Companion& other : outcome.companions)
        if (same(other.row)) return distance_of(row.result.answer, other.row.result.answer);
    return std::nullopt;
}

void run_companions(const Benchmark& benchmark, VerifyOutcome& outcome)
{
    for (const Kinematics kinematics : benchmark.also) {
        scenes::SceneSetting setting = benchmark.setting;
        setting.kinematics = kinematics;
        VerifyRow row{setting, run_once(benchmark, setting)};
        const std::optional<double> distance = distance_from_first(row, outcome);
        outcome.companions.push_back({std::move(row), distance});
    }
}

bool within(const VerifyResult& result, const Benchmark& benchmark)
{
    return result.failure.empty() && result.error <= benchmark.tolerance;
}

bool passes(const VerifyOutcome& outcome)
{
    const Benchmark& benchmark = outcome.benchmark;
    const double agreement = std::max(least_agreement, 0.1 * benchmark.tolerance);
    return within(outcome.row.result, benchmark) &&
           std::all_of(outcome.companions.begin(), outcome.companions.end(), [&](const Companion& companion) {
               return within(companion.row.result, benchmark) && companion.distance.value_or(0) <= agreement;
           });
}

/// Least squares over (log h, log error).
double slope(const std::vector<const VerifyRow*>& rows)
{
    double x_mean = 0, y_mean = 0, above = 0, below = 0;
    const auto n = static_cast<double>(rows.size());
    for (const VerifyRow* row : rows) {
        x_mean += std::log(row->setting.time_step) / n;
        y_mean += std::log(row->result.error) / n;
    }
    for (const VerifyRow* row : rows) {
        const double x = std::log(row->setting.time_step) - x_mean;
        above += x * (std::log(row->result.error) - y_mean);
        below += x * x;
    }
    return above / below;
}

std::vector<ObservedOrder> observed_orders(const std::vector<VerifyRow>& rows)
{
    std::vector<ObservedOrder> orders;
    for (const VerifyRow& first : rows) {
        const std::string method = method_name(first.setting);
        const auto same = [&](const ObservedOrder& order) { return order.method == method; };
        if (first.setting.stiffness_factor || std::any_of(orders.begin(), orders.end(), same)) continue;
        std::vector<const VerifyRow*> of_method;
        for (const VerifyRow& row : rows) {
            const bool sound = row.result.failure.empty() && row.result.error > no_order_below;
            if (sound && !row.setting.stiffness_factor && method_name(row.setting) == method)
                of_method.push_back(&row);
        }
        if (of_method.size() >= 3) orders.push_back({method, slope(of_method)});
    }
    return orders;
}

}  // namespace

VerifyOutcome run_benchmark(const Benchmark& benchmark, bool sweep)
{
    VerifyOutcome outcome;
    outcome.benchmark = benchmark;
    outcome.row = {benchmark.setting,
                   sweep ? median_of_three(benchmark, benchmark.setting) : run_once(benchmark, benchmark.setting)};
    run_companions(benchmark, outcome);
    outcome.pass = passes(outcome);
    if (!sweep || benchmark.sweep.empty()) {
        outcome.rows = {outcome.row};
        return outcome;
    }
    for (const scenes::SceneSetting& setting : benchmark.sweep)
        outcome.rows.push_back({setting, median_of_three(benchmark, setting)});
    outcome.orders = observed_orders(outcome.rows);
    return outcome;
}

double cpu_share(const VerifyResult& result)
{
    return result.simulated_time > 0 ? result.cpu_time / result.simulated_time : 0;
}

}  // namespace voussoir::app::studies::verify
