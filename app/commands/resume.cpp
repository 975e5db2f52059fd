#include "app/commands/resume.h"

#include <fmt/format.h>

#include "app/commands/say.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{

namespace fs = std::filesystem;

namespace
{

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

bool is_there(const fs::path& path)
{
    std::error_code none;
    return fs::exists(fs::symlink_status(path, none));
}

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
        try {
            const results::RestartHead head = results::read_restart_head(results::restart_file_in(folder));
            if (!head.ended)
                return complain(
                    fmt::format("{}: replacing an interrupted run, which had reached t = {:g} s; --resume would "
                                "have continued it",
                                folder.string(), head.time));
        } catch (const InputError&) {
            return complain(
                fmt::format("{}: replacing a restart.bin that this version cannot read", folder.string()));
        }
    }
    if (!quiet && is_there(folder / "results.h5"))
        say(fmt::format("{}: replacing earlier results", folder.string()));
}

std::string place_of(const Case& the_case, const results::Restart& restart)
{
    const State& state = restart.state;
    const auto stage = static_cast<std::size_t>(state.stage);
    return fmt::format("stage '{}', t = {:g} s, step {}",
                       stage < the_case.stages.size() ? the_case.stages[stage].name : "", state.time, state.step);
}

}  // namespace voussoir::app::commands
