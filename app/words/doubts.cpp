#include "app/words/doubts.h"

#include <utility>

#include "app/words/diagnosis_words.h"
#include "app/words/trust_words.h"

namespace voussoir::app::words
{

std::vector<std::string> doubts_of(const RunReport& report, const std::optional<Trust>& trust, const Model& model,
                                   const std::vector<Stage>& stages)
{
    std::vector<Stage> ran = stages;  // shorter steps than the last ones are what may help
    for (const ShorterSteps& shorter : report.shorter_steps)
        ran[shorter.stage].control.time_step = shorter.time_step;
    std::vector<std::string> doubts = warnings_of(report, model, ran);
    if (!trust) return doubts;
    for (std::string& warning : warnings_of(*trust, ran)) doubts.push_back(std::move(warning));
    return doubts;
}

}  // namespace voussoir::app::words
