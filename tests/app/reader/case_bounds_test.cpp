// Cases that ask for more than any computer has: refused in a sentence, at once and in little memory.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{

namespace
{

const std::string scene =
    "materials: {m: {density: 2000 kg/m3, young: 1 GPa, poisson: 0.2}}\n"
    "joints: {j: {friction: 30 deg}}\n";
const std::string floor_and_stone =
    "blocks:\n"
    "  - {box: {name: floor, lower: [-1, -1, -1], upper: [1, 1, 0]}, group: foundation}\n"
    "  - {box: {name: stone, lower: [0, 0, 0], upper: [0.5, 0.5, 0.5]}}\n"
    "foundation: {blocks: foundation}\n";
const std::string shake = "stages: [{name: s, type: dynamic, duration: 1 s}]\n";

/// What is said about a case, which must not take long.
std::string said_soon(const std::string& text)
{
    const auto start = std::chrono::steady_clock::now();
    const std::string said = faults_of(text);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(took.count(), 60) << said.substr(0, 300);
    return said;
}

testing::AssertionResult mentions(const std::string& said, const std::string& words)
{
    if (said.find(words) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << said.substr(0, 500);
}

}  // namespace

TEST(CaseBounds, WallsOfAMillionMillionStones)
{
    const auto wall = [](const std::string& keys) { return scene + "blocks: [{wall: {" + keys + "}}]\n" + shake; };
    EXPECT_TRUE(mentions(said_soon(wall("length: 1 km, height: 1 km, thickness: 1, block: [1 mm, 1 mm]")),
                         "more than 200000 blocks"));
    EXPECT_TRUE(mentions(said_soon(wall("length: 120, height: 120, thickness: 1, block: [0.3, 0.3], leaves: 99")),
                         "more than 200000 blocks"));
    EXPECT_TRUE(mentions(said_soon(wall("length: 1e300, height: 1e300, thickness: 1, block: [1e-300, 1e-300]")),
                         "more than 200000 blocks"));
    std::string walls = scene + "blocks:\n";
    for (int i = 0; i < 100; ++i)
        walls += "  - {wall: {name: w" + std::to_string(i) + ", origin: [0, " + std::to_string(2 * i) +
                 ", 0], length: 100, height: 50, thickness: 1, block: [0.25, 0.5]}}\n";
    EXPECT_TRUE(mentions(said_soon(walls + shake), "more than 200000 blocks")) << "each alone is allowed";
    const std::string house =
        "length: 90, width: 90, height: 90, wall_thickness: 1, lintel: {height: 0.3, bearing: 0.3}";
    EXPECT_TRUE(mentions(said_soon(scene + "blocks: [{house: {" + house + ", block: [0.3, 0.3]}}]\n" + shake),
                         "more than 200000 blocks"))
        << "each of its walls alone is allowed";
}

TEST(CaseBounds, AGroupForEveryBlock)
{
    std::string text = scene + "blocks:\n";
    for (int i = 0; i < 20'000; ++i)
        text += "- {box: {name: b" + std::to_string(i) + ", lower: [" + std::to_string(2 * i) +
                ", 0, 0], upper: [" + std::to_string(2 * i + 1) + ", 1, 1]}, group: g" + std::to_string(i) + "}\n";
    EXPECT_TRUE(mentions(said_soon(text + shake), "more than 1000 groups"));
}

TEST(CaseBounds, AllStonesInOnePlace)
{
    std::string text = scene + "blocks:\n";
    for (int i = 0; i < 20'000; ++i)
        text += "- {box: {name: b" + std::to_string(i) + ", lower: [0, 0, 0], upper: [1, 1, 1]}}\n";
    const std::string said = said_soon(text + shake);
    EXPECT_TRUE(mentions(said, "overlap by 1 m"));
    EXPECT_TRUE(mentions(said, "more than 1000 pairs of stones overlap"));
}

TEST(CaseBounds, StepsFramesAndPicturesWithoutEnd)
{
    const auto said = [](const std::string& rest) { return said_soon(scene + floor_and_stone + rest); };
    EXPECT_TRUE(mentions(said("stages: [{type: dynamic, duration: 1e3 s, time_step: 1e-12 s}]\n"),
                         "1e+15 steps: 1000 s in steps of 1e-12 s; a stage has at most 1e+09"));
    EXPECT_TRUE(mentions(said("stages: [{type: dynamic, duration: 1e300 s, time_step: 1e-9 s}]\n"), "steps"));
    EXPECT_TRUE(mentions(said(shake + "output: {every: 1e-300 s}\n"), "intervals in s"));
    EXPECT_TRUE(
        mentions(said(shake + "output: {snapshots: {size: [1000000, 1000000]}}\n"), "must be >= 200 and <= 8000"));
    EXPECT_TRUE(mentions(said(shake + "output: {snapshots: {count: 1000000000}}\n"), "from 1 to 10000"));
    const auto said_of = [&](const std::string& wave) {
        return said("stages: [{type: dynamic, duration: 1, motion: {x: {" + wave + "}}}]\n");
    };
    EXPECT_EQ(said_of("ricker: {acceleration: 1 m/s2, frequency: 1, time_step: 1e-3}"), "no fault");
    for (const char* wave : {"noise: {acceleration: 1 m/s2, duration: 1e15 s}",
                             "noise: {acceleration: 1 m/s2, duration: 1, time_step: 1e-300}",
                             "sweep: {acceleration: 1 m/s2, from: 1, to: 1e12, duration: 1000}",
                             "ricker: {acceleration: 1 m/s2, frequency: 1, time_step: 1e-15}"})
        EXPECT_TRUE(mentions(said_of(wave), "at most 1e7 time steps")) << wave;
}

TEST(CaseBounds, StonesTooHeavyOrTooLargeForANumber)
{
    const auto said = [](const std::string& old_part, const std::string& new_part) {
        return said_soon(with(scene + floor_and_stone + shake, old_part, new_part));
    };
    EXPECT_TRUE(mentions(said("density: 2000 kg/m3", "density: 1e308 kg/m3"), "a mass of inf kg"));
    EXPECT_TRUE(mentions(said("upper: [0.5, 0.5, 0.5]", "upper: [1e150, 1e150, 1e150]"), "a volume of inf m3"));
    EXPECT_TRUE(mentions(said("upper: [0.5, 0.5, 0.5]", "upper: [1e-120, 1e-120, 1e-120]"),
                         "case.yaml:5: blocks[1]: box: face 0 has no area"));
}

TEST(CaseBounds, HistoriesAndKeysWithoutEnd)
{
    std::string histories = scene + floor_and_stone + shake + "output:\n  histories:\n";
    for (int i = 0; i < 200'000; ++i) histories += "    h" + std::to_string(i) + ": {block: gone}\n";
    EXPECT_TRUE(mentions(said_soon(histories), "too many faults; reading stopped here"));
    std::string keys = scene + floor_and_stone + shake;
    for (int i = 0; i < 300'000; ++i) keys += "k" + std::to_string(i) + ": 1\n";
    EXPECT_TRUE(mentions(said_soon(keys), "too many faults; reading stopped here"));
}

TEST(CaseBounds, YamlThatGrowsWhenItIsRead)
{
    EXPECT_TRUE(mentions(said_soon("a: &a [x, x]\nb: &b [*a, *a]\nc: &c [*b, *b]\n"), "an alias"));
    EXPECT_TRUE(mentions(said_soon("a: " + std::string(1'000'000, '[')), "more than 1000 brackets"));
    std::string deep;
    for (int i = 0; i < 3000; ++i) deep += std::string(i, ' ') + "a:\n";
    EXPECT_TRUE(mentions(said_soon(deep), "nested too deep"));
    EXPECT_TRUE(mentions(said_soon(std::string(100'000, '-').append(" a")), "a case is a map of keys"));
    std::string dashes;
    for (int i = 0; i < 100'000; ++i) dashes += "- ";
    EXPECT_TRUE(mentions(said_soon(dashes + "a"), "nested too deep"));
}

// A hostile name is a name: it never leads out of the folder or into a shell. Files a case names are only read.
TEST(CaseBounds, NamesAreNotCommandsOrPaths)
{
    for (const char* name : {"../../etc/passwd", "/dev/zero", "|id", "$(id)", "-o", "a\\nb", "'; id; '"}) {
        const std::string quoted = "\"" + std::string(name) + "\"";
        const std::string said = said_soon(scene + "blocks: [{mesh: " + quoted + "}]\n" + shake);
        EXPECT_TRUE(mentions(said, "no mesh file") || mentions(said, "not a mesh file")) << name << ": " << said;
        const std::string shaken =
            "stages: [{type: dynamic, duration: 1, motion: {x: {record: " + quoted + "}}}]\n";
        EXPECT_TRUE(mentions(said_soon(scene + floor_and_stone + shaken), "stages[0].motion.x.record: ")) << name;
    }
}

}  // namespace voussoir::app::reader
