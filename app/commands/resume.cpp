#include "app/commands/resume.h"

#include <fmt/core.h>

#include <cstdio>

#include "libdda/errors.h"

namespace voussoir::app::commands
{

namespace fs = std::filesystem;

namespace
{

bool is_there(const fs::path& path)
{
    std::error_code none;
    return fs::exists(path, none);
}

[[noreturn]] void refuse_other_engine(const fs::path& folder, const version::EngineVersion& before,
                                      const version::EngineVersion& now)
{
    throw InputError(
        folder.string(),
        "begun by another engine (" + version::in_words(before) + "; this is " + version::in_words(now) + ")",
        "resume with that engine, add --other-engine to continue with this one, or start again without --resume");
}

std::string mixed_engines(const version::EngineVersion& before, const version::EngineVersion& now, double time)
{
    return fmt::format(
        "two engines made this run: {}, up to t = {:g} s; {} from there on (--other-engine): "
        "neither of them alone gives identical results",
        version::in_words(before), time, version::in_words(now));
}

}  // namespace

void refuse_without_restart(const fs::path& folder)
{
    if (is_there(results::restart_file_in(folder))) return;
    throw InputError(folder.string(), "nothing to resume", "start the run without --resume");
}

results::Restart restart_of(const Case& the_case, const fs::path& folder, bool other_engine)
{
    refuse_without_restart(folder);
    results::Restart restart = results::load_restart(results::restart_file_in(folder));
    const results::Fingerprint now = results::fingerprint_of(the_case);
    const version::EngineVersion& before = restart.computed_from.engine;
    const bool is_other = before != now.engine;
    // What another engine makes of the same files may differ, which is no change of the files.
    if (is_other && !other_engine && results::same_input(restart.computed_from, now))
        refuse_other_engine(folder, before, now.engine);
    const std::string changed = results::differences(restart.computed_from, now);
    if (!changed.empty())
        throw InputError(folder.string(), "not the run of this case; changed since: " + changed,
                         "resume with the original input, or start again without --resume");
    results::check_fits(restart, the_case, results::restart_file_in(folder));
    if (is_other) restart.remarks.push_back(mixed_engines(before, now.engine, restart.state.time));
    return restart;
}

void tell_what_is_replaced(const fs::path& folder, bool quiet)
{
    if (is_there(results::restart_file_in(folder))) {
        bool ended = false;
        std::string moment;
        try {
            const results::Restart restart = results::load_restart(results::restart_file_in(folder));
            ended = restart.ended;
            moment = fmt::format(", which had reached t = {:g} s", restart.state.time);
        } catch (const InputError&) {
            moment = ", which can no longer be read";
        }
        if (!ended) {
            fmt::print(stderr, "{}: replacing an interrupted run{}; --resume would have continued it\n",
                       folder.string(), moment);
            return;
        }
    }
    if (!quiet && is_there(folder / "results.h5")) fmt::print("{}: replacing earlier results\n", folder.string());
}

std::string place_of(const Case& the_case, const results::Restart& restart)
{
    const State& state = restart.state;
    const auto stage = static_cast<std::size_t>(state.stage);
    return fmt::format("stage '{}', t = {:g} s, step {}",
                       stage < the_case.stages.size() ? the_case.stages[stage].name : "", state.time, state.step);
}

}  // namespace voussoir::app::commands
