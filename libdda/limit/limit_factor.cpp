#include "libdda/limit/limit_factor.h"

#include "libdda/limit/balance.h"

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

std::optional<double> limit_factor(const LimitProblem& problem)
{
    constexpr double first = 1, most = 1e6;
    constexpr int most_mechanisms = 60;
    if (balance_of(problem).standing != Standing::balanced) return std::nullopt;
    double factor = first;
    Balance balance = balance_of(loaded(problem, factor));
    while (balance.standing == Standing::balanced) {
        factor *= 4;
        if (factor > most) return std::nullopt;
        balance = balance_of(loaded(problem, factor));
    }
    if (balance.standing == Standing::unknown) return std::nullopt;
    for (int i = 0; i < most_mechanisms && balance.standing == Standing::mechanism; ++i) {
        const double lower = factor_without_work(problem, balance);
        if (!(lower > 0 && lower < factor)) break;
        factor = lower;
        balance = balance_of(loaded(problem, factor));
    }
    return factor;
}

}  // namespace voussoir::limit
