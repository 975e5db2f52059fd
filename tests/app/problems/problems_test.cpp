// Step problems are taken bit for bit and kept whole.
#include <algorithm>
#include <map>

#include "app/problems/judge.h"
#include "app/results/hdf5_file.h"
#include "libdda/run/run.h"
#include "tests/app/problems/shaken_boxes.h"

namespace voussoir::app::problems
{
namespace
{

using Problems = ShakenBoxes;

/// Hashes of the states of a run, by the steps before them.
std::map<std::int64_t, std::uint64_t> hashes_of_run(const Case& the_case)
{
    std::map<std::int64_t, std::uint64_t> hashes;
    RunObserver observer;
    observer.step = [&](const State& state, const StepReport&, const RunReport&) {
        hashes[state.step] = hash_of(state);
    };
    State state = initial_state(the_case.model);
    run(the_case.model, the_case.stages, state, observer);
    return hashes;
}

TEST_F(Problems, AreTheStatesOfTheRunBitForBit)
{
    arguments.every = 7;
    const Corpus corpus = take(arguments);
    ASSERT_GE(corpus.problems.size(), 14U);
    const Case the_case = read(corpus.cases[0]);
    const auto run_hashes = hashes_of_run(the_case);
    for (const StoredStep& problem : corpus.problems) {
        SCOPED_TRACE(problem.name);
        if (problem.state.step > 0) {
            EXPECT_EQ(hash_of(problem.state), run_hashes.at(problem.state.step));
        }
        EXPECT_EQ(problem.name.rfind("case.", 0), 0U);
        if (problem.increment > 0) continue;  // how long a static step is to be next is the driver's
        const MadeStep made = make_step(the_case, stage_of(problem, the_case), problem, OpenClose::newton);
        ASSERT_TRUE(made.holds());
        for (std::size_t i = 0; i < made.state.coordinates.size(); ++i)
            EXPECT_NEAR(made.state.coordinates[i], problem.state.coordinates[i], 0.1);
        State after = made.state;
        after.stage_time = static_cast<double>(after.grid + 1) * 2e-3;  // as the driver of stages counts
        ++after.grid;
        if (!made.report.divided) {
            EXPECT_EQ(hash_of(after), run_hashes.at(after.step));
        }
    }
}

TEST_F(Problems, StayWholeInAFile)
{
    arguments.every = 11;
    const Corpus corpus = take(arguments);
    save(corpus, folder / "a.h5");
    const Corpus loaded = load(folder / "a.h5");
    EXPECT_EQ(loaded.cases, corpus.cases);
    ASSERT_EQ(loaded.problems.size(), corpus.problems.size());
    for (std::size_t i = 0; i < corpus.problems.size(); ++i) {
        const StoredStep &was = corpus.problems[i], &is = loaded.problems[i];
        EXPECT_EQ(is.name, was.name);
        EXPECT_EQ(is.time_step, was.time_step);
        EXPECT_EQ(is.increment, was.increment);
        EXPECT_EQ(is.force_tolerance, was.force_tolerance);
        EXPECT_EQ(is.tags, was.tags);
        EXPECT_EQ(hash_of(is.state), hash_of(was.state));
    }
    save(loaded, folder / "b.h5");
    EXPECT_EQ(bytes_of("a.h5"), bytes_of("b.h5"));
    EXPECT_LT(bytes_of("a.h5").size(), 8000U * corpus.problems.size());
}

TEST_F(Problems, AreChosenByTimeNumberAndTag)
{
    arguments.at = {0.05, 0.1};
    arguments.name = "boxes";
    const Corpus two = take(arguments);
    ASSERT_EQ(two.problems.size(), 2U);
    EXPECT_NEAR(two.problems[0].state.time, 0.05, 2e-3);
    EXPECT_NEAR(two.problems[1].state.time, 0.1, 2e-3);
    EXPECT_EQ(two.problems[0].name.rfind("boxes.", 0), 0U);
    arguments.at = {};
    arguments.of = {"sticking"};
    arguments.most = 3;
    const Corpus turned = take(arguments);
    ASSERT_EQ(turned.problems.size(), 3U);
    for (const StoredStep& problem : turned.problems)
        EXPECT_EQ(std::count(problem.tags.begin(), problem.tags.end(), "sticking"), 1);
}

TEST_F(Problems, ShareACaseOnce)
{
    arguments.every = 50;
    const Corpus one = take(arguments);
    arguments.name = "again";
    Corpus both = one;
    add(take(arguments), both);
    EXPECT_EQ(both.cases.size(), 1U);
    EXPECT_EQ(both.problems.size(), 2 * one.problems.size());
    arguments.settings = {"joints.dry.friction=20 deg"};
    add(take(arguments), both);
    EXPECT_EQ(both.cases.size(), 2U);
    EXPECT_EQ(both.problems.back().case_index, 1U);
}

TEST_F(Problems, OfACaseThatNamesOtherFilesAreRefused)
{
    write("stone.obj", "o s\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    std::string wave = "0\n";
    for (int i = 0; i < 100; ++i) wave += std::to_string(i % 5) + "\n";
    write("wave.txt", wave);
    write("case.yaml",
          with(two_boxes, "{blocks: foundation}",
               "{blocks: foundation, motion: {x: {record: wave.txt, unit: m/s2, time_step: 10 ms}}}"));
    try {
        take(arguments);
        FAIL() << "taken";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("the case names other files"), std::string::npos) << error.what();
    }
}

TEST_F(Problems, OfAnotherModelAreRefused)
{
    arguments.every = 50;
    Corpus corpus = take(arguments);
    const Case the_case = read(corpus.cases[0]);
    StoredStep problem = corpus.problems.back();
    problem.state.coordinates.pop_back();
    EXPECT_THROW(stage_of(problem, the_case), InputError);
    problem = corpus.problems.back();
    problem.state.stage = 2;
    EXPECT_THROW(stage_of(problem, the_case), InputError);
    problem = corpus.problems.back();
    problem.increment = 1;
    EXPECT_THROW(stage_of(problem, the_case), InputError);
}

TEST_F(Problems, InForeignAndDamagedFilesAreRefused)
{
    EXPECT_NE(refusal_of("absent.h5"), "");
    write("text.h5", "no HDF5 at all");
    EXPECT_NE(refusal_of("text.h5").find("text.h5"), std::string::npos);
    results::Hdf5File other = results::Hdf5File::create(folder / "other.h5");
    other.attribute("/", "kind", std::string("something else"));
    other.close();
    EXPECT_NE(refusal_of("other.h5").find("no step problems of this version"), std::string::npos);
    arguments.every = 50;
    save(take(arguments), folder / "good.h5");
    EXPECT_EQ(refusal_of("good.h5"), "");
    const std::string good = bytes_of("good.h5");
    write("short.h5", good.substr(0, good.size() / 2));
    EXPECT_NE(refusal_of("short.h5"), "");
    // Wherever a bit is turned: it is read as it was, or refused with a sentence, never more.
    int refused = 0;
    for (std::size_t at = 0; at < good.size(); at += 97) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 4);
        write("bad.h5", bad);
        refused += !refusal_of("bad.h5").empty();
    }
    EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace voussoir::app::problems
