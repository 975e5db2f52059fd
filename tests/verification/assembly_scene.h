// A mesh on held stones, from its certificate to a second of shaking, by the program itself.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/program_start.h"

namespace voussoir::verification
{

inline constexpr const char* rest = "  - {name: self-weight, type: static}\n";
inline constexpr const char* shaking =
    "  - {name: shaking, type: dynamic, duration: 1 s, motion: {x: {ramped_sine: {acceleration: 0.2 g, "
    "frequency: 3 Hz, ramp: 0.3 s, duration: 1 s}}}}\n";
inline constexpr const char* fall = "  - {name: fall, type: dynamic, duration: 4 s, collapse: {stop_after: 1}}\n";

/// A mesh and how it is held.
struct Scene {
    std::filesystem::path mesh;
    std::string keys;      // of its entry
    std::string supports;  // which stones are held: a rule of a group
    std::string head;      // of the case

    std::string text(const std::string& stages) const
    {
        const std::string entry = "{mesh: " + nlohmann::json(mesh.string()).dump() +
                                  (keys.empty() ? "" : ", " + keys) + ", groups: {support: " + supports + "}}";
        return head +
               "materials: {stone: {density: 2200 kg/m3, young: 10 GPa, poisson: 0.2}}\n"
               "joints: {dry: {friction: 37 deg}}\n"
               "blocks:\n  - " +
               entry + "\nfoundation: {blocks: support}\nstages:\n" + stages;
    }
};

/// What the program made of a case.
struct Outcome {
    int exit_code = -1;
    std::string said;
    nlohmann::json summary;  // none when it did not run
    std::string word() const { return summary.value("outcome", "none"); }
    int unconverged() const { return summary.value("unconverged_steps", -1); }
};

inline Outcome started(const TemporaryFolder& folder, const std::string& command, const std::string& text)
{
    const std::string file = folder.write("case.yaml", text), out = folder / "out";
    std::vector<std::string> words{command, file};
    if (command == "run") words.insert(words.end(), {"-q", "-o", out, "--threads", "1"});
    const app::Ended ended = app::voussoir(folder, words);
    Outcome outcome{ended.exit_code, ended.errors, {}};
    if (command != "run") return outcome;
    outcome.summary = nlohmann::json::parse(app::contents(folder / "out/summary.json"), nullptr, false);
    if (outcome.summary.is_discarded()) outcome.summary = nlohmann::json::object();
    return outcome;
}

/// @returns what is written in the table
inline std::string expect_rest_and_shaking(const TemporaryFolder& folder, const Scene& scene)
{
    const Outcome checked = started(folder, "check", scene.text(std::string(rest) + shaking));
    EXPECT_EQ(checked.exit_code, 0) << checked.said;
    if (checked.exit_code != 0) return "refused";
    const Outcome ran = started(folder, "run", scene.text(std::string(rest) + shaking));
    EXPECT_EQ(ran.exit_code, 0) << ran.said;
    EXPECT_EQ(ran.word(), "completed") << ran.said;
    EXPECT_EQ(ran.unconverged(), 0);
    return "rests, shaken: " + ran.word();
}

}  // namespace voussoir::verification
