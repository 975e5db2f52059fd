// Cells, how they are judged, and how they end in a process of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "app/reader/case_file.h"
#include "app/studies/stability/maps.h"
#include "app/studies/stability/page.h"
#include "app/studies/stability/runner.h"
#include "app/studies/stability/sound_range.h"
#include "libdda/errors.h"

namespace voussoir::app::studies::stability
{
namespace
{

StabilityCell cell_named(const std::string& name)
{
    for (const StabilityScene& scene : stability_scenes(reader::case_reader))
        for (const StabilityCell& cell : scene.cells)
            if (cell.name == name) return cell;
    ADD_FAILURE() << name;
    return {};
}

CellRun with_error(double error)
{
    CellRun run;
    run.error = error;
    return run;
}

TEST(StabilityCells, AreTwoHundredWithNamesOfTheirOwnAndAReferenceEach)
{
    std::set<std::string> names;
    std::size_t count = 0;
    for (const StabilityScene& scene : stability_scenes(reader::case_reader))
        for (const StabilityCell& cell : scene.cells) {
            names.insert(cell.name);
            ++count;
            EXPECT_EQ(cell.scene, scene.name);
            EXPECT_FALSE(cell.reference.empty()) << cell.name;
            EXPECT_FALSE(cell.parameters.empty()) << cell.name;
            EXPECT_GT(cell.tolerance, 0) << cell.name;
            EXPECT_LE(cell.tolerance, 0.05) << cell.name;
            EXPECT_GT(cell.budget, 0) << cell.name;
        }
    EXPECT_EQ(names.size(), count);
    EXPECT_GE(count, 200u);
}

TEST(StabilityCells, TheMapsSpanTenDecadesOfStiffnessAndThreeOfTimeStep)
{
    int maps = 0;
    for (const StabilityScene& scene : stability_scenes(reader::case_reader)) {
        if (!scene.over_stiffness_and_step) continue;
        ++maps;
        std::set<double> stiffnesses, steps;
        for (const StabilityCell& cell : scene.cells) {
            stiffnesses.insert(cell.parameters.at(0).value);
            steps.insert(cell.time_step);
        }
        EXPECT_GE(*stiffnesses.rbegin() / *stiffnesses.begin(), 0.99e10) << scene.name;
        EXPECT_GE(*steps.rbegin() / *steps.begin(), 0.99e3) << scene.name;
        EXPECT_EQ(stiffnesses.size() * steps.size(), scene.cells.size()) << scene.name;
    }
    EXPECT_EQ(maps, 3) << "sliding, rocking and the wall";
}

TEST(StabilityCells, AreJudgedByTheirTolerance)
{
    StabilityCell cell;
    cell.tolerance = 0.02;
    EXPECT_EQ(judge(cell, with_error(0.02)), CellOutcome::passed);
    EXPECT_EQ(judge(cell, with_error(0.0201)), CellOutcome::wrong);
    EXPECT_EQ(judge(cell, with_error(NAN)), CellOutcome::wrong);
    EXPECT_EQ(judge(cell, with_error(INFINITY)), CellOutcome::wrong);
    CellRun warned = with_error(0.0201);
    warned.warning = "contacts so soft are part of the answer";
    EXPECT_EQ(judge(cell, warned), CellOutcome::warned);
    for (const double no_answer : {0.201, double(NAN), double(INFINITY)}) {
        warned.error = no_answer;
        EXPECT_EQ(judge(cell, warned), CellOutcome::wrong)
            << "a warning excuses a rough answer, not " << no_answer;
    }
}

/// A map of eleven stiffnesses and steps of 1e-5 to 1e-1 s, in which `fails` says what does not pass.
std::vector<CellResult> map_results(StabilityScene& scene, const std::function<bool(double, double)>& fails)
{
    scene.name = "map";
    scene.over_stiffness_and_step = true;
    std::vector<CellResult> results;
    for (int decade = 4; decade <= 14; ++decade)
        for (int step = -5; step <= -1; ++step) {
            CellResult result;
            result.cell.scene = scene.name;
            result.cell.parameters = {{"contact stiffness", std::pow(10, decade), "N/m"}};
            result.cell.time_step = std::pow(10, step);
            result.outcome = fails(decade, step) ? CellOutcome::stopped : CellOutcome::passed;
            scene.cells.push_back(result.cell);
            results.push_back(result);
        }
    return results;
}

TEST(StabilityRange, IsTheRectangleInWhichAllCellsPassed)
{
    StabilityScene scene, hole;
    const auto results = map_results(
        scene, [](int decade, int step) { return decade < 6 || step > -3 || (decade == 14 && step == -5); });
    const SoundRange range = sound_range(scene, results).value();
    EXPECT_NEAR(range.softest, 1e6, 1);
    EXPECT_NEAR(range.stiffest, 1e13, 1e6);
    EXPECT_NEAR(range.shortest, 1e-5, 1e-12);
    EXPECT_NEAR(range.longest, 1e-3, 1e-12);
    EXPECT_EQ(sound_range_in_words(scene, results),
              "map works from 1e+06 to 1e+13 N/m and from 0.01 ms to 1 ms (7 and 2 decades)");
    EXPECT_TRUE(holds_too_little(scene, results)) << "three decades of time step are asked for";
    std::vector<CellResult> some(results.begin(), results.end() - 1);
    EXPECT_FALSE(holds_too_little(scene, some)) << "a part of a map tells nothing";
    EXPECT_EQ(sound_range_in_words(scene, some), "");
    const auto ring = map_results(hole, [](int decade, int step) { return decade == 9 && step == -3; });
    EXPECT_TRUE(holds_too_little(hole, ring)) << "a hole in the middle";
}

TEST(StabilityRange, IsEnoughWithEightDecadesOfStiffnessAndThreeOfTimeStep)
{
    StabilityScene enough, nothing;
    const auto good = map_results(enough, [](int decade, int step) { return decade > 12 || step > -2; });
    EXPECT_FALSE(holds_too_little(enough, good));
    EXPECT_EQ(sound_range_in_words(enough, good),
              "map works from 1e+04 to 1e+12 N/m and from 0.01 ms to 10 ms (8 and 3 decades)");
    const auto bad = map_results(nothing, [](int, int) { return true; });
    EXPECT_TRUE(holds_too_little(nothing, bad));
    EXPECT_EQ(sound_range_in_words(nothing, bad), "map holds nowhere");
}

TEST(StabilityCells, WhatSaidWhyItHasNoAnswerIsNotWrong)
{
    StabilityCell cell;
    CellRun stopped = with_error(NAN), refused = with_error(NAN);
    stopped.diagnosis = "gave up";
    refused.refusal = "no such thing";
    EXPECT_EQ(judge(cell, stopped), CellOutcome::stopped);
    EXPECT_EQ(judge(cell, refused), CellOutcome::refused);
    cell.run = []() -> CellRun { throw InputError("here", "this", "that"); };
    const CellRun thrown = run_here(cell);
    EXPECT_NE(thrown.refusal.find("that"), std::string::npos);
    EXPECT_EQ(judge(cell, thrown), CellOutcome::refused);
}

TEST(StabilityCells, WhatSaidThatItShouldNotBeTrustedIsNotSilentlyWrong)
{
    StabilityCell cell;
    cell.tolerance = 0.02;
    CellRun run = with_error(0.03);
    run.warning = "3 % of the energy is unaccounted for";
    EXPECT_EQ(judge(cell, run), CellOutcome::warned);
    EXPECT_FALSE(is_failure(CellOutcome::warned));
    run.error = 0.01;
    EXPECT_EQ(judge(cell, run), CellOutcome::passed);
}

TEST(StabilityCells, WhatSinksInItsSpringsStopsAndIsNamed)
{
    const CellRun run = run_here(cell_named("sliding/k=1e+04/h=0.005"));
    EXPECT_NE(run.diagnosis.find("'block' and 'base' overlap"), std::string::npos) << run.diagnosis;
    EXPECT_NE(run.diagnosis.find("too soft"), std::string::npos) << run.diagnosis;
    EXPECT_NE(run.note.find("by the reference it settles 0.049"), std::string::npos) << run.note;
}

TEST(StabilityCells, RunInAProcessOfTheirOwnAsTheyDoHere)
{
    const StabilityCell cell = cell_named("sliding/k=1e+08/h=0.005");
    const CellResult apart = run_apart(cell, {});
    const CellRun here = run_here(cell);
    EXPECT_EQ(apart.outcome, CellOutcome::passed) << apart.diagnosis;
    EXPECT_EQ(apart.run.error, here.error);
    EXPECT_EQ(apart.run.steps, here.steps);
    EXPECT_GT(apart.run.steps, 400);
    const CellRun quick = run_apart(cell_named("sliding/k=1e+10/h=0.02"), {}).run;
    EXPECT_GT(quick.cpu_time, 0)
        << "a millisecond is less than the ticks in which a process with a limit is counted";
}

TEST(StabilityCells, BeyondTheBudgetIsATimeout)
{
    StabilityCell cell = cell_named("wall/k=1e+08/h=2e-05");
    cell.budget = 1;
    const CellResult result = run_apart(cell, {});
    EXPECT_EQ(result.outcome, CellOutcome::timeout);
    EXPECT_FALSE(result.diagnosis.empty());
}

#ifndef __SANITIZE_ADDRESS__  // under which no bound is set: it reserves terabytes of addresses
TEST(StabilityCells, BeyondTheMemoryIsACrash)
{
    CellLimits limits;
    limits.memory = std::size_t{40} << 20;
    const CellResult result = run_apart(cell_named("thousand/columns=1-deformable/h=0.001"), limits);
    EXPECT_EQ(result.outcome, CellOutcome::crash);
    EXPECT_FALSE(result.diagnosis.empty());
}
#endif

TEST(StabilityCells, ResultsComeInTheOrderOfTheCellsWhateverTheNumberOfJobs)
{
    const std::vector<StabilityCell> cells{cell_named("sliding/k=1e+08/h=0.005"),
                                           cell_named("sliding/k=1e+08/h=0.02"), cell_named("column/E=1e+09")};
    std::size_t told = 0;
    const std::vector<CellResult> results = run_cells(cells, 3, [&](const CellResult&) { ++told; });
    EXPECT_EQ(told, cells.size());
    ASSERT_EQ(results.size(), cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_EQ(results[i].cell.name, cells[i].name);
}

TEST(StabilityMaps, AWrongCellIsRedAndNamedOnThePage)
{
    CellResult good, bad;
    good.cell = cell_named("sliding/k=1e+08/h=0.005");
    good.run.error = 1e-3;
    bad.cell = cell_named("sliding/k=1e+09/h=0.005");
    bad.run.error = 0.5;
    bad.outcome = CellOutcome::wrong;
    bad.diagnosis = "error 50 % is beyond 2 %";
    const std::vector<StabilityScene> scenes = stability_scenes(reader::case_reader);
    const std::vector<plots::Figure> figures = stability_figures(scenes, {good, bad});
    ASSERT_EQ(figures.size(), 1u);
    const plots::TileMap& map = figures[0].maps.at(0);
    EXPECT_EQ(map.tiles.size(), 2u);
    EXPECT_EQ(map.tiles[1].text, "50 %");
    EXPECT_GT(map.tiles[1].color[0], 2 * map.tiles[1].color[1]);
    EXPECT_GT(map.tiles[0].color[1], map.tiles[0].color[0]);
    const std::string page = stability_page(scenes, {good, bad}, "voussoir stability -o here", {}, false);
    EXPECT_NE(page.find("**wrong**"), std::string::npos);
    EXPECT_NE(page.find("`sliding/k=1e+09/h=0.005` wrong: error 50 %"), std::string::npos);
    EXPECT_NE(page.find("1 passed, 0 refused, 0 stopped, 0 warned, 1 wrong"), std::string::npos);
}

TEST(StabilityMaps, EverySceneIsOnThePageThatShips)
{
    std::ostringstream page;
    page << std::ifstream(VOUSSOIR_DOCS "/stability.md").rdbuf();
    for (const StabilityScene& scene : stability_scenes(reader::case_reader)) {
        EXPECT_NE(page.str().find("\n## " + scene.name + "\n"), std::string::npos)
            << scene.name << ": rerun voussoir stability --tables -o docs";
        const bool holds = page.str().find(", " + scene.name + " works from ") != std::string::npos;
        EXPECT_EQ(holds, scene.over_stiffness_and_step)
            << scene.name << ": rerun voussoir stability --tables -o docs";
    }
}

}  // namespace
}  // namespace voussoir::app::studies::stability
