#include "libdda/limit/limit_factor.h"

#include <utility>

namespace voussoir::limit
{

namespace
{

LimitProblem loaded(const LimitProblem& problem, double factor)
{
    LimitProblem loaded = problem;
    for (LimitBlock& block : loaded.blocks) block.dead += factor * block.live;
    return loaded;
}

/// The factor at which the loads do no more work on a mechanism than it takes.
double factor_without_work(const LimitProblem& problem, const Balance& mechanism)
{
    double dead = 0, live = 0;
    for (std::size_t b = 0; b < problem.blocks.size(); ++b) {
        dead += problem.blocks[b].dead.dot(mechanism.velocities[b].centroid);
        live += problem.blocks[b].live.dot(mechanism.velocities[b].centroid);
    }
    return (mechanism.dissipation - dead) / live;
}

}  // namespace

CollapseLoad collapse_load(const LimitProblem& problem, const std::function<void()>& before_each)
{
    constexpr double first = 1, most = 1e6;
    constexpr int most_mechanisms = 60;
    const auto balance_under = [&](double factor) {
        before_each();
        return balance_of(loaded(problem, factor));
    };
    const Standing before = balance_under(0).standing;
    if (before == Standing::unknown) return {};
    if (before == Standing::mechanism) return {UnderLoad::falls_before, 0, {}};
    double factor = first;
    Balance balance = balance_under(factor);
    while (balance.standing == Standing::balanced) {
        factor *= 4;
        if (factor > most) return {UnderLoad::bears_all, 0, {}};
        balance = balance_under(factor);
    }
    if (balance.standing == Standing::unknown) return {};
    std::vector<BlockVelocity> mechanism = balance.velocities;
    for (int i = 0; i < most_mechanisms && balance.standing == Standing::mechanism; ++i) {
        mechanism = balance.velocities;
        const double lower = factor_without_work(problem, balance);
        if (!(lower > 0 && lower < factor)) break;
        factor = lower;
        balance = balance_under(factor);
    }
    return {UnderLoad::limited, factor, std::move(mechanism)};
}

std::optional<double> limit_factor(const LimitProblem& problem)
{
    const CollapseLoad load = collapse_load(problem);
    if (load.outcome != UnderLoad::limited) return std::nullopt;
    return load.factor;
}

std::optional<SlidingBracket> sliding_bracket(const LimitProblem& problem, double associated,
                                              const std::function<void()>& before_each)
{
    constexpr double width = 0.002;
    const auto stands = [&](double share) {
        before_each();
        return standing_without_dilatancy(loaded(problem, share * associated)) == Standing::balanced;
    };
    double stands_at = 1 - width, slides_at = 1;
    if (!stands(stands_at)) {
        if (!stands(0)) return std::nullopt;
        slides_at = stands_at;
        stands_at = 0;
    }
    while (slides_at - stands_at > 1.001 * width) {
        const double middle = (stands_at + slides_at) / 2;
        (stands(middle) ? stands_at : slides_at) = middle;
    }
    return SlidingBracket{stands_at * associated, slides_at * associated};
}

}  // namespace voussoir::limit
