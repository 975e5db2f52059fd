#include "app/commands/resume.h"

#include <fmt/core.h>

#include <cstdio>

#include "libdda/errors.h"

namespace voussoir
{

namespace fs = std::filesystem;

namespace
{

bool is_there(const fs::path& path)
{
    std::error_code none;
    return fs::exists(path, none);
}

}  // namespace

void refuse_without_restart(const fs::path& folder)
{
    if (is_there(restart_file_in(folder))) return;
    throw InputError(folder.string(), "nothing to resume", "start the run without --resume");
}

Restart restart_of(const Case& the_case, const fs::path& folder)
{
    refuse_without_restart(folder);
    Restart restart = load_restart(restart_file_in(folder));
    const std::string changed = differences(restart.computed_from, fingerprint_of(the_case));
    if (!changed.empty())
        throw InputError(folder.string(), "not the run of this case; changed since: " + changed,
                         "resume with the original input, or start again without --resume");
    check_fits(restart, the_case, restart_file_in(folder));
    return restart;
}

void tell_what_is_replaced(const fs::path& folder, bool quiet)
{
    if (is_there(restart_file_in(folder))) {
        bool ended = false;
        std::string moment;
        try {
            const Restart restart = load_restart(restart_file_in(folder));
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

std::string place_of(const Case& the_case, const Restart& restart)
{
    const State& state = restart.state;
    const auto stage = static_cast<std::size_t>(state.stage);
    return fmt::format("stage '{}', t = {:g} s, step {}",
                       stage < the_case.stages.size() ? the_case.stages[stage].name : "", state.time, state.step);
}

}  // namespace voussoir
