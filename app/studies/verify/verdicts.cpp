// What the engine says of structures at rest, on both sides of the limit that linear programming knows.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "app/studies/scenes/stages.h"
#include "app/studies/verify/families.h"
#include "app/studies/verify/limit_scenes.h"
#include "libdda/limit/limit_analysis.h"
#include "libdda/run/run.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr std::uint64_t seed = 2;  // not that of the tests
constexpr int scenes = 9;          // two of each sort and one dome, which takes as long as all others
constexpr std::array<double, 4> shares{0.97, 0.995, 1.005, 1.03};  // of the limit

/// A static stage as a case file has it, with gravity that leans along +x by a share of itself.
RunReport rest_under(const Model& model, double factor, const scenes::SceneSetting& setting, VerifyResult& result)
{
    const Stage stage =
        scenes::static_stage(setting, {factor * scenes::papers_gravity, 0, -scenes::papers_gravity});
    State state = initial_state(model);
    const std::clock_t start = std::clock();
    RunReport report = run(model, {stage}, state, {});
    result.cpu_time += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    result.steps += report.steps;
    result.step_cuts += report.step_cuts;
    result.iterations += report.open_close_iterations;
    return report;
}

bool leaves_open(const RunReport& report)
{
    return report.outcome == Outcome::undecided ||
           std::any_of(report.warnings.begin(), report.warnings.end(),
                       [](const Diagnosis& warning) { return warning.kind == DiagnosisKind::friction_open; });
}

/// Nothing stands beyond the associated limit. Below it blocks that slide without opening may fall: an answer that
/// says so is none that is wrong.
bool is_wrong(const RunReport& report, double share)
{
    if (share > 1) return report.outcome != Outcome::collapsed;
    return report.outcome != Outcome::completed && !leaves_open(report);
}

VerifyResult run_verdicts(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    int verdicts = 0, wrong = 0, open = 0;
    std::string of_which;
    for (int n = 0; n < scenes; ++n) {
        LimitMasonry scene = limit_scene(seed, n, !is_deformable(setting.kinematics));
        const limit::LimitState limit = limit::associated_limit(limit_problem(limit_scene(seed, n, true).model));
        if (!limit.found) continue;
        for (JointMaterial& joint : scene.model.joints)
            joint.stiffness.factor *= setting.stiffness_factor.value_or(1);
        for (const double share : shares) {
            const RunReport report = rest_under(scene.model, share * limit.factor, setting, result);
            ++verdicts;
            open += share < 1 && leaves_open(report);
            if (!is_wrong(report, share)) continue;
            ++wrong;
            of_which += fmt::format("; wrong: {}, at {} of {:.4f}", scene.description, share, limit.factor);
        }
    }
    result.error = verdicts > 0 ? static_cast<double>(wrong) / verdicts : 1;
    result.note = fmt::format("{} of {} verdicts wrong, {} left open by friction, and said so{}", wrong, verdicts,
                              open, of_which);
    return result;
}

}  // namespace

std::vector<Benchmark> verdict_benchmarks()
{
    Benchmark row;
    row.name = "verdicts-at-rest";
    row.title = "Verdicts on structures at rest";
    row.source = "docs/at_rest.md: limit analysis by linear programming over the engine's contacts";
    row.quantity = "share of verdicts that are wrong";
    row.choices =
        "Random arches, walls, portals, leaning frames and domes, two of each but one dome (seed 2; the tests "
        "have others), "
        "under their weight and 0.97, 0.995, 1.005 and 1.03 of the share of it along x at which they become a "
        "mechanism; elastic stones are of 50 GPa. Beyond the limit of joints that slide open by the angle of "
        "friction nothing stands. Below it "
        "stones that slide without opening may fall: such an answer is wrong unless it says that friction leaves "
        "it open. Default joints of a case without motion; the diagram has joints softer and stiffer than that, "
        "on which structures lean, and thin arches lose some of their limit.";
    row.paper_error = "none: not from a paper";
    row.setting.kinematics = Kinematics::planar_rigid;
    row.setting.time_step = 1;
    row.also = {Kinematics::planar_deformable};
    row.tolerance = 0;
    row.run = run_verdicts;
    for (const double factor : {0.03, 0.1, 0.3, 1.0, 3.0}) {
        row.sweep.push_back(row.setting);
        row.sweep.back().stiffness_factor = factor;
    }
    return {row};
}

}  // namespace voussoir::app::studies::verify
