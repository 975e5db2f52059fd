// voussoir-peers SCENE ENGINE TIME_STEP ITERATIONS: one scene in one engine; prints error and cost as JSON.
// scripts/peers asks.
#include <cstdio>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/peers/trials.h"

int main(int argc, char** argv)
{
    if (argc != 5) {
        std::fputs("voussoir-peers SCENE ENGINE TIME_STEP ITERATIONS: started by scripts/peers\n", stderr);
        return 2;
    }
    try {
        const voussoir::peers::Setting setting{argv[2], std::stod(argv[3]), std::stoi(argv[4])};
        const voussoir::peers::Finding finding = voussoir::peers::run_trial(argv[1], setting);
        std::cout << nlohmann::json{{"error", finding.error},
                                    {"cpu_time", finding.cpu_time},
                                    {"step_time", finding.step_time},
                                    {"failure", finding.failure}}
                  << '\n';
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voussoir-peers: %s\n", error.what());
        return 2;
    }
}
