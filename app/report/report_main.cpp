// voussoir-report: the report of a run, or the comparison of two. Reads from its standard input, one to a line,
// the results file, the folder to write into, "film" or "no film", and the other results file, if two are
// compared; writes the names of the files that it made.
#include <fmt/format.h>
#include <sys/prctl.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/report/comparison.h"
#include "app/report/make_report.h"
#include "importers/process/own_limits.h"
#include "libdda/errors.h"

namespace
{

void report()
{
    std::string results, folder, film, other;
    std::getline(std::cin, results);
    std::getline(std::cin, folder);
    std::getline(std::cin, film);
    std::getline(std::cin, other);
    const auto told = [](int done, int all) {
        fmt::print("frame {} of {}\n", done, all);
        std::fflush(stdout);
    };
    namespace report = voussoir::app::report;
    const auto made = other.empty() ? report::make_report(results, folder, film == "film", told)
                                    : report::make_comparison(results, other, folder, film == "film", told);
    for (const std::filesystem::path& file : made) fmt::print("made {}\n", file.string());
}

}  // namespace

int main()
{
    // The results may be anybody's.
    voussoir::importers::process::limit_self(RLIMIT_CORE, 0);
    voussoir::importers::process::limit_own_memory(rlim_t{8} << 30);
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // who asked wants nothing any more when it is gone
    try {
        report();
        return 0;
    } catch (const voussoir::InputError& error) {
        std::fprintf(stderr, "voussoir-report: %s\n", error.what());
        return 2;
    } catch (const nlohmann::json::exception&) {
        std::fprintf(stderr, "voussoir-report: the summary in the results is damaged: run the case again\n");
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voussoir-report: %s\n", error.what());
        return 1;
    }
}
