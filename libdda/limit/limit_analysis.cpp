#include "libdda/limit/limit_analysis.h"

#include <cmath>
#include <random>
#include <utility>

#include "libdda/limit/statics.h"

namespace voussoir::limit
{
namespace
{

LimitState state_of(const Statics& statics)
{
    LimitState state;
    state.found = true;
    state.factor = statics.factor();
    state.forces = statics.forces();
    state.beyond_friction = statics.beyond_friction();
    return state;
}

/// Normal forces of a random state of equilibrium under a factor; none when it is not found.
std::vector<double> random_normal_forces(const LimitProblem& problem, double factor, std::mt19937_64& random)
{
    std::vector<double> weights(problem.contacts.size());
    for (double& weight : weights) weight = static_cast<double>(random() >> 11) * 0x1p-53;
    Statics statics(problem, Friction::cone);
    statics.seek_least_pressure(factor, weights);
    if (!statics.solve()) return {};
    return statics.normal_forces();
}

/// Iterates from the normal forces `first`. @returns what it converges to, if it does
LimitState slide_without_opening(const LimitProblem& problem, const std::vector<double>& first)
{
    constexpr int most_programs = 300, enough = 5;
    constexpr double same = 1e-6, admissible = 3e-3;  // of the factor; of the dead load, beyond friction
    constexpr double slack = 1e-7;                    // of the dead load: the first forces must not be at the edge
    Statics statics(problem, Friction::cohesion);
    std::vector<double> normal = first;
    double last = 0;
    int quiet = 0, iterations = 0;
    while (quiet < enough) {
        if (++iterations > most_programs) return {};
        for (std::size_t i = 0; i < normal.size(); ++i)
            statics.set_cohesion(i, problem.contacts[i].friction * normal[i] + slack);
        const bool solved = statics.solve();
        const std::vector<double> next = solved ? statics.normal_forces() : first;  // these bear the dead load
        for (std::size_t i = 0; i < normal.size(); ++i) normal[i] = (normal[i] + next[i]) / 2;
        const bool settled = solved && std::abs(statics.factor() - last) <= same * last;
        quiet = settled && statics.beyond_friction() <= admissible ? quiet + 1 : 0;
        last = solved ? statics.factor() : 0;
    }
    LimitState state = state_of(statics);
    state.programs = statics.programs();
    return state;
}

LimitProblem without_strength(LimitProblem problem)
{
    for (LimitContact& contact : problem.contacts) contact.cohesion = contact.tension = 0;
    return problem;
}

}  // namespace

LimitState associated_limit(const LimitProblem& problem)
{
    Statics statics(problem, Friction::cone);
    if (!statics.solve()) return {};
    LimitState state = state_of(statics);
    state.programs = statics.programs();
    return state;
}

LimitState non_associated_limit(const LimitProblem& bonded, int starts)
{
    constexpr double share = 0.8;
    const LimitProblem problem = without_strength(bonded);
    Statics dilating(problem, Friction::cone);
    if (!dilating.solve()) return {};
    std::mt19937_64 random(1);
    LimitState lowest;
    int programs = dilating.programs();
    for (int start = 0; start <= starts; ++start) {
        const std::vector<double> first = start == 0
                                              ? dilating.normal_forces()
                                              : random_normal_forces(problem, share * dilating.factor(), random);
        if (first.empty()) continue;
        LimitState state = slide_without_opening(problem, first);
        programs += state.programs + (start > 0);
        if (state.found && (!lowest.found || state.factor < lowest.factor)) lowest = std::move(state);
    }
    lowest.programs = programs;
    return lowest;
}

}  // namespace voussoir::limit
