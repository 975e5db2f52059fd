#include "app/results/run_end.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/results/results_reader.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

RunEnd run_end_of(const std::filesystem::path& results_file)
{
    const ResultsReader reader(results_file);
    const Hdf5File file = Hdf5File::open(results_file);
    RunEnd end;
    if (!reader.times.empty()) end.reached = reader.times.back();
    try {
        for (const auto& stage : nlohmann::json::parse(file.read_text("/case/settings")))
            end.planned += stage.value("duration_s", 0.0);
        if (!file.has("/summary")) return end;
        const auto summary = nlohmann::json::parse(file.read_text("/summary"));
        end.outcome = summary.at("outcome").get<std::string>();
        end.message = summary.at("message").get<std::string>();
    } catch (const nlohmann::json::exception&) {
        throw InputError(results_file.string(), "a summary or settings that cannot be read",
                         "the file is damaged: run the case again");
    }
    return end;
}

std::string early_end_in_words(const RunEnd& end)
{
    const std::string when =
        end.planned > 0 ? fmt::format("at {:.3g} of {:g} s", end.reached, end.planned) : "in a static stage";
    if (end.outcome.empty()) return "the run has not ended: killed, or still running, " + when;
    if (end.outcome == "collapsed") return "the structure collapsed " + when;
    if (end.outcome == "gave_up") return "the run gave up " + when;
    if (end.outcome == "undecided") return "it is undecided whether the structure stands, " + when;
    if (end.outcome == "interrupted") return "the run was interrupted " + when;
    return "";
}

}  // namespace voussoir::app::results
