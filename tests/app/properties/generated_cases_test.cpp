// Generated cases run, and the same case told otherwise gives the same answer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <optional>

#include "app/case/case.h"
#include "libdda/model/state.h"
#include "libdda/run/run.h"
#include "tests/app/properties/generated_reading.h"

namespace voussoir::app::properties
{
namespace
{

using Eigen::Vector3d;

/// Where every block is at the end, how fast, and how it went.
struct Answer {
    RunReport report;
    std::map<std::string, Vector3d> places, moves, velocities;  // user's coordinates, m and m/s
};

Answer answer_of(const Case& the_case, const State& state, RunReport report)
{
    Answer answer{std::move(report), {}, {}, {}};
    for (std::size_t b = 0; b < the_case.model.blocks.size(); ++b) {
        const Block& block = the_case.model.blocks[b];
        const Pose pose = pose_of(the_case.model.kinematics, state, static_cast<int>(b));
        answer.places[block.name] = pose.centroid + the_case.model.origin;
        answer.moves[block.name] = pose.centroid - block.moments.centroid;
        answer.velocities[block.name] = velocity_of(the_case.model.kinematics, state, static_cast<int>(b));
    }
    return answer;
}

Answer run_whole(Case the_case, int threads = 1)
{
    for (Stage& stage : the_case.stages) stage.control.threads = threads;
    State state = initial_state(the_case.model);
    RunReport report = run(the_case.model, the_case.stages, state, {});
    return answer_of(the_case, state, std::move(report));
}

Answer run_told(const GeneratedScene& scene, const Telling& telling)
{
    return run_whole(read(scene, telling));
}

/// Stopped after some steps, and gone on with from what was saved.
Answer run_resumed(const Case& the_case, int steps)
{
    State state = initial_state(the_case.model), saved = state;
    std::optional<RunPosition> position;
    int taken = 0;
    RunObserver observer;
    observer.save = [&](const State& here, const RunPosition& at) {
        saved = here;
        position = at;
    };
    observer.step = [&](const State&, const StepReport&, const RunReport&) { ++taken; };
    observer.stop = [&] { return taken >= steps; };
    RunReport report = run(the_case.model, the_case.stages, state, observer);
    if (report.outcome != Outcome::interrupted) return answer_of(the_case, state, std::move(report));
    state = saved;
    report = run(the_case.model, the_case.stages, state, {}, *position);
    return answer_of(the_case, state, std::move(report));
}

double largest_move(const Answer& answer)
{
    double most = 0;
    for (const auto& [name, move] : answer.moves) most = std::max(most, move.norm());
    return most;
}

/// How far two answers to one scene are apart, as a share of the largest move; the second is told otherwise.
double difference(const Answer& plain, const Answer& other, const Telling& telling = {})
{
    if (plain.report.outcome != other.report.outcome) return 1;
    double most = 0;
    for (const auto& [name, move] : plain.moves)
        most =
            std::max(most, (telling.rotation().transpose() * other.moves.at(name) / telling.scale - move).norm());
    constexpr double least = 1e-4;  // m: what stands still is compared with a tenth of a millimetre
    return most / std::max(largest_move(plain), least);
}

/// What is asked of the differences of all seeds, as shares of the largest move.
struct Allowed {
    double usually;  // of 99 in 100 cases: rounding
    double ever;     // of any: a point that sticks or slides by next to nothing is decided by rounding
};

/// Collects differences; those that are too large are told by their seeds, and a single seed with both its cases.
class Differences
{
 public:
    explicit Differences(const Allowed& allowed) : allowed_(allowed) {}
    Differences(const Differences&) = delete;
    Differences& operator=(const Differences&) = delete;
    void add(std::uint64_t seed, double difference, const std::string& texts)
    {
        ++count_;
        if (difference > allowed_.usually)
            unusual_ += fmt::format(" {} ({:.2g})", seed, difference), ++unusual_count_;
        if (difference > allowed_.ever)
            ADD_FAILURE() << "seed " << seed << ": the answers differ by " << difference << " of the largest move"
                          << (is_one_seed() ? texts : "");
    }
    ~Differences()
    {
        EXPECT_GT(count_, 0);
        EXPECT_LE(unusual_count_, 1 + count_ / 100)
            << "seeds whose answers differ by more than " << allowed_.usually << ":" << unusual_;
    }

 private:
    static bool is_one_seed() { return seeds().second - seeds().first == 1; }

    Allowed allowed_;
    int count_ = 0, unusual_count_ = 0;
    std::string unusual_;
};

/// Tells the scenes of all seeds that are `wanted` in another way and compares.
void expect_same(const Allowed& allowed, const std::function<bool(const GeneratedScene&)>& wanted,
                 const std::function<Telling(std::uint64_t)>& telling_of, const Telling& plain = {})
{
    Differences differences(allowed);
    const auto [first, end] = seeds();
    for (std::uint64_t seed = first; seed < end; ++seed) {
        const GeneratedScene scene = generated(seed);
        if (!wanted(scene)) continue;
        const Telling telling = telling_of(seed);
        const std::string here = text_of(scene, plain), there = text_of(scene, telling);
        const Answer answer = run_told(scene, plain), other = run_told(scene, telling);
        differences.add(seed, difference(answer, other, telling),
                        fmt::format("\n{}\nends as {} after {} steps\n{}\nends as {} after {} steps", here,
                                    static_cast<int>(answer.report.outcome), answer.report.steps, there,
                                    static_cast<int>(other.report.outcome), other.report.steps));
    }
}

bool always(const GeneratedScene&)
{
    return true;
}

}  // namespace

TEST(GeneratedCases, RunToTheirEnd)
{
    const auto [first, end] = seeds();
    std::map<std::string, int> ends;
    for (std::uint64_t seed = first; seed < end; ++seed) {
        const Answer answer = run_told(generated(seed), {});
        ++ends[std::string(name_of(answer.report.outcome))];
        EXPECT_TRUE(answer.report.outcome == Outcome::completed || answer.report.outcome == Outcome::collapsed)
            << "seed " << seed << ::testing::PrintToString(answer.report.diagnosis);
    }
    count(ends);
}

// What is accepted starts, whatever it is.
TEST(GeneratedCases, DamagedOnesThatAreAcceptedStart)
{
    const auto [first, end] = seeds();
    std::map<std::string, int> ends;
    for (std::uint64_t seed = first; seed < end; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::optional<Case> the_case = read_damaged(seed);
        if (!the_case) {
            ++ends["refused"];
            continue;
        }
        int steps = 0;
        RunObserver observer;
        observer.step = [&](const State&, const StepReport&, const RunReport&) { ++steps; };
        observer.stop = [&] { return steps >= 5; };
        State state = initial_state(the_case->model);
        const RunReport report = run(the_case->model, the_case->stages, state, observer);
        ++ends[report.outcome == Outcome::gave_up ? "gave_up" : "started"];
        const Answer answer = answer_of(*the_case, state, report);
        for (const auto& [name, place] : answer.places) EXPECT_TRUE(place.allFinite()) << name;
    }
    count(ends);
    EXPECT_GT(ends["started"], 0);
    EXPECT_GT(ends["refused"], 0);
}

TEST(GeneratedCases, AnswersDoNotDependOnTheUnitOfLength)
{
    expect_same({1e-6, 5e-3}, always, [](std::uint64_t seed) {
        Telling telling;
        telling.unit = seed % 2 == 0 ? "mm" : "cm";
        return telling;
    });
}

TEST(GeneratedCases, AnswersDoNotDependOnTheOrderOfStacks)
{
    expect_same({1e-6, 5e-3}, always, [](std::uint64_t) {
        Telling telling;
        telling.other_order = true;
        return telling;
    });
}

TEST(GeneratedCases, AnswersTurnWithTheScene)
{
    expect_same({1e-5, 1e-2}, always, [](std::uint64_t seed) {
        Telling telling;
        telling.quarter_turns = 1 + static_cast<int>(seed % 3);
        return telling;
    });
}

TEST(GeneratedCases, AnswersAreMirroredWithTheScene)
{
    expect_same({1e-5, 1e-2}, always, [](std::uint64_t) {
        Telling telling;
        telling.mirrored = true;
        return telling;
    });
}

TEST(GeneratedCases, AnswersMoveWithTheScene)
{
    expect_same({1e-4, 5e-3}, always, [](std::uint64_t seed) {
        Telling telling;
        // What is placed keeps its shape as far as 1e7 m: a wall of stones of a tenth of a metre is refused at 1e9
        // m.
        const GeneratedScene scene = generated(seed);
        const double farthest = scene.wall || scene.mesh ? 1e7 : 1e9;
        const double far = seed % 2 == 0 ? farthest : 100;
        telling.offset = {far, -far, 0};
        return telling;
    });
}

TEST(GeneratedCases, AnswersScaleWithTheUnitsOfAllQuantities)
{
    expect_same({1e-5, 5e-3}, always, [](std::uint64_t seed) {
        Telling telling;
        telling.scale = seed % 2 == 0 ? 10 : 0.25;
        return telling;
    });
}

TEST(GeneratedCases, ThreadsAndResumingChangeNoBit)
{
    const auto [first, end] = seeds();
    for (std::uint64_t seed = first; seed < end; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Case the_case = read(generated(seed), {});
        const Answer whole = run_whole(the_case);
        const Answer threaded = run_whole(the_case, 3),
                     resumed = run_resumed(the_case, 1 + static_cast<int>(seed % 7));
        for (const auto& [name, place] : whole.places) {
            EXPECT_EQ(threaded.places.at(name), place) << name;
            EXPECT_EQ(resumed.places.at(name), place) << name;
            EXPECT_EQ(resumed.velocities.at(name), whole.velocities.at(name)) << name;
        }
    }
}

/// Scenes told in space and in a plane. @param walls whether of them or of all others
void expect_planar_as_spatial(const std::string& kind, const Allowed& allowed, bool walls)
{
    Telling space;
    space.kinematics = "spatial_" + kind;
    space.young = 1e10;  // the masses of softer stones are seen to bulge across the plane
    space.joint = ", contact_stiffness: 1 GPa/m, face: corners";  // where a needle begins, the others differ
    expect_same(
        allowed, [&](const GeneratedScene& scene) { return scene.flat && scene.wall.has_value() == walls; },
        [&](std::uint64_t) {
            Telling plane = space;
            plane.kinematics = "planar_" + kind;
            return plane;
        },
        space);
}

TEST(GeneratedCases, PlanarScenesAreSpatialOnesOfOneExtent)
{
    expect_planar_as_spatial("rigid", {1e-6, 1e-2}, false);
    expect_planar_as_spatial("deformable", {3e-3, 3e-2}, false);
}

// Corners of two stones within a ten-thousandth of their size are taken as one, and of a stone of a planar scene
// that is the root of its area, of a spatial one that of its volume: where a course has slid by a fiftieth of a
// millimetre, one of the two tellings has taken over the corner of the other stone already.
TEST(GeneratedCases, PlanarWallsAreSpatialOnesOfOneExtent)
{
    expect_planar_as_spatial("rigid", {1e-4, 1e-2}, true);
    expect_planar_as_spatial("deformable", {3e-2, 3e-2}, true);
}

TEST(GeneratedCases, StiffStonesAreRigidOnes)
{
    Telling rigid;
    rigid.kinematics = "spatial_rigid";
    rigid.joint = ", contact_stiffness: 0.1 GPa/m";
    expect_same(
        {1e-2, 3e-2}, always,
        [&](std::uint64_t) {
            Telling stiff = rigid;
            stiff.kinematics = "spatial_deformable";
            stiff.young =
                1e11;  // stresses of stiffer ones are rounded by more than a resting stone may be unbalanced
            return stiff;
        },
        rigid);
}

}  // namespace voussoir::app::properties
