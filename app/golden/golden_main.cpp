// voussoir-golden: prints, as JSON, the engine, the hashes of what the golden scenes end in and what else they
// depend on. scripts/golden_hashes compares them with those on record.
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/golden/hashes.h"
#include "app/version/version.h"
#include "importers/process/program_start.h"

namespace
{

using namespace voussoir;
using Json = nlohmann::ordered_json;

std::string digits(std::uint64_t hash)
{
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

void print_hashes()
{
    const std::vector<app::golden::SceneHashes> hashes = app::golden::hashes();
    Json json;
    json["engine"] = Json::parse(app::version::engine_json());
    for (const auto& [name, value] : app::golden::machine()) json["machine"][name] = value;
    json["behaviour"] = app::golden::behaviour(hashes);
    for (const app::golden::SceneHashes& each : hashes)
        json["hashes"][each.name] = {{"state", digits(each.state)}, {"report", digits(each.report)}};
    std::printf("%s\n", json.dump(1).c_str());
}

}  // namespace

int main(int argument_count, char**)
{
    voussoir::importers::process::begin_program();
    if (argument_count > 1) {
        std::fprintf(stderr, "voussoir-golden: takes no arguments\n");
        return 2;
    }
    try {
        print_hashes();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "voussoir-golden: %s\n", error.what());
        return 1;
    }
}
