// voussoir-plot: work-precision diagrams. Reads the folder (a line) and the JSON of `voussoir verify` from its
// standard input, writes FOLDER/NAME.png for every benchmark with a sweep, and the names to its standard output.
#include <cstdio>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/verify/plot.h"

namespace
{

using nlohmann::json;
using voussoir::PlotData;

std::optional<double> number(const json& value)
{
    return value.is_null() ? std::nullopt : std::optional<double>(value.get<double>());
}

PlotData read(const json& benchmark)
{
    PlotData data{benchmark.at("title"),
                  benchmark.at("source"),
                  {},
                  benchmark.at("tolerance"),
                  number(benchmark.at("paper_error_value")),
                  benchmark.at("paper_error")};
    for (const json& row : benchmark.at("rows"))
        data.rows.push_back({row.at("method"), row.at("time_step_s"), row.at("cpu_time_s"),
                             number(row.at("stiffness_factor")), number(row.at("error"))});
    return data;
}

}  // namespace

int main()
{
    try {
        std::string folder;
        std::getline(std::cin, folder);
        const json benchmarks = json::parse(std::cin);
        for (const json& benchmark : benchmarks) {
            if (benchmark.at("rows").size() < 2) continue;
            const std::string name = benchmark.at("benchmark");
            draw_figure(work_precision(read(benchmark)), std::filesystem::path(folder) / (name + ".png"));
            std::cout << name << '\n';
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voussoir-plot: %s\n", error.what());
        return 2;
    }
}
