// voussoir-report: the report of a run, or the comparison of two. Reads from its standard input, one to a line,
// the results file, the folder to write into, "film" or "no film", and the other results file, if two are
// compared; writes the names of the files that it made.
#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/report/comparison.h"
#include "app/report/make_report.h"
#include "importers/process/own_limits.h"
#include "importers/process/program_start.h"
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

int main(int argc, char**)
{
    voussoir::importers::process::begin_helper();
    if (argc > 1) {
        std::fputs("voussoir-report is started by voussoir: a request on the standard input\n", stderr);
        return 2;
    }
    // The results may be anybody's.
    voussoir::importers::process::limit_self(RLIMIT_CORE, 0);
    voussoir::importers::process::limit_own_memory(rlim_t{8} << 30);
    try {
        report();
        return 0;
    } catch (const voussoir::InputError& error) {
        voussoir::importers::process::complain("voussoir-report", error.what());
        return 2;
    } catch (const nlohmann::json::exception&) {
        voussoir::importers::process::complain("voussoir-report",
                                               "the summary in the results is damaged: run the case again");
        return 2;
    } catch (const std::exception& error) {
        voussoir::importers::process::complain("voussoir-report", error.what());
        return 1;
    }
}
