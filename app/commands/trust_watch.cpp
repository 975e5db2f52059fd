#include "app/commands/trust_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/commands/say.h"
#include "app/words/trust_words.h"

namespace voussoir::app::commands
{
namespace
{

// A step costs a block 40 microseconds or more, in which a sparse factorisation does 2e4 operations; the search
// may take a hundredth of the steps, and of a short run some ten milliseconds.
constexpr double work_of_a_block_in_a_step = 2e4;
constexpr double share_of_the_run = 0.01;
constexpr double always_allowed = 5e6;

}  // namespace

double most_work_of_modes(const Case& the_case)
{
    if (the_case.output.trust == TrustFigures::always) return std::numeric_limits<double>::max();
    double steps = 0;
    for (const Stage& stage : the_case.stages)
        if (stage.type == StageType::dynamic) steps += std::ceil(stage.duration / stage.control.time_step);
    const double blocks = static_cast<double>(the_case.model.blocks.size());
    return std::max(always_allowed, share_of_the_run * steps * blocks * work_of_a_block_in_a_step);
}

std::optional<Trust> print_trust(const Case& the_case, const std::optional<TrustStart>& noted,
                                 const EnergyLedger& energy)
{
    if (!noted) return std::nullopt;
    Trust trust = trust_in(*noted, the_case.stages, energy);
    say(fmt::format("  {}", words::vibrations_in_words(trust)));
    const std::string shares = words::shares_in_words(trust.shares);
    if (!shares.empty()) say(fmt::format("  {}", shares));
    return trust;
}

bool TrustWatch::is_due(const State& state) const
{
    const std::vector<Stage>& stages = case_.stages;
    const auto stage = static_cast<std::size_t>(state.stage);
    if (case_.output.trust == TrustFigures::never || stage >= stages.size()) return false;
    const bool rests = stages[stage].type == StageType::static_equilibrium;
    if (state.step == 0) return !rests;
    if (!rests || state.time > 0) return false;
    return stage + 1 == stages.size() || stages[stage + 1].type == StageType::dynamic;
}

const TrustStart* TrustWatch::frame(const State& state, const RunReport& report)
{
    if (!is_due(state)) return nullptr;
    ModesSearch search;
    search.most_work = most_work_of_modes(case_);
    start_ = {state.step > 0, natural_modes(case_.model, state, search), report.energy};
    return &*start_;
}

}  // namespace voussoir::app::commands
