#include "app/version/version.h"

#include <nlohmann/json.hpp>

namespace voussoir::app::version
{

namespace
{

using Json = nlohmann::ordered_json;

std::string commit_in_words(const EngineVersion& engine)
{
    if (engine.commit.empty()) return "commit not known";
    const std::string commit = "commit " + engine.commit;
    if (engine.dirty == Dirty::no) return commit;
    return commit + (engine.dirty == Dirty::yes ? " with changes" : ", changes not known");
}

}  // namespace

std::string in_words(const EngineVersion& engine)
{
    const Compilation& compiled = engine.compilation;
    return engine.version + ", " + commit_in_words(engine) + ", sources " + engine.sources + ", " +
           compiled.instruction_set + ", " + compiled.compiler + ", Eigen " + compiled.eigen;
}

std::string engine_json(const std::string& behaviour)
{
    const EngineVersion engine = engine_version();
    Json json;
    json["version"] = engine.version;
    json["commit"] = engine.commit.empty() ? Json(nullptr) : Json(engine.commit);
    json["dirty"] = engine.dirty == Dirty::unknown ? Json(nullptr) : Json(engine.dirty == Dirty::yes);
    json["sources"] = engine.sources;
    json["instruction_set"] = engine.compilation.instruction_set;
    json["compiler"] = engine.compilation.compiler;
    json["eigen"] = engine.compilation.eigen;
    if (!behaviour.empty()) json["behaviour"] = behaviour;
    return json.dump();
}

std::string engine_paragraph(const std::string& behaviour)
{
    return "\n## Engine\n\nvoussoir " + in_words(engine_version()) + "; behaviour " + behaviour +
           ". The page is up to date as long as `tests/libdda/golden_hashes.json` has this behaviour.\n";
}

}  // namespace voussoir::app::version
