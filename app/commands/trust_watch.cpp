#include "app/commands/trust_watch.h"

#include <fmt/format.h>

#include "app/commands/say.h"
#include "app/reader/automatic_steps.h"
#include "app/words/trust_words.h"

namespace voussoir::app::commands
{

std::optional<Trust> print_trust(const Case& the_case, const std::optional<TrustStart>& noted,
                                 const RunReport& report)
{
    if (!noted) return std::nullopt;
    Trust trust = trust_in(*noted, as_begun(the_case.stages, report.shorter_steps), report.energy);
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
    search.most_work = reader::most_work_of_modes(case_);
    start_ = {state.step > 0, natural_modes(case_.model, state, search), report.energy};
    return &*start_;
}

}  // namespace voussoir::app::commands
