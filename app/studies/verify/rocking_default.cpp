// Rocking as the program does it when it is told nothing: its order in the time step, and its impacts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studies/verify/families.h"
#include "app/studies/verify/references/rocking_on_springs.h"
#include "app/studies/verify/rocking.h"
#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{

namespace
{

// A block 0.2 x 0.6 m under a half sine that does not overturn it; its first impact comes later than `until`.
constexpr double until = 0.45;  // s
const references::RockingBlock slender{0.1, 0.3, scenes::papers_gravity, 5.4, 1, false};
// N/m, under each corner: the block vibrates at 13 Hz on the soft ones, which steps of 2 ms resolve, and at 130
// Hz.
constexpr double soft_spring = 1e6, hard_spring = 1e8;

RockingCase on_springs(double corner_spring)
{
    RockingCase rocking{.block = slender};
    rocking.stiffness = {ContactStiffness::Kind::per_area, corner_spring / slender.half_width};
    return rocking;
}

std::vector<double> angles_on_springs(const RockingCase& rocking, const std::vector<double>& times)
{
    const double corner_spring = rocking.stiffness.value * slender.half_width;
    const references::CornerSprings springs{.mass = rocking.density * 4 * slender.half_width * slender.half_height,
                                            .normal = corner_spring,
                                            .shear = JointMaterial{}.shear_to_normal_stiffness * corner_spring,
                                            .friction = std::tan(rocking.friction * std::numbers::pi / 180)};
    return references::rocking_angles_on_springs(slender, springs, times);
}

using Exact = std::function<std::vector<double>(const std::vector<double>& times)>;

/// Largest error of the angle over its largest, at one step.
double error_at(scenes::SceneSetting setting, double time_step, const RockingCase& rocking, const Exact& exact,
                VerifyResult& result)
{
    setting.time_step = time_step;
    const LeanRecord record = watch_rocking(setting, rocking, until, result);
    const std::vector<double> angles = exact(record.times);
    result.picture = lean_picture(record, angles);
    const double error = lean_difference(record, angles, until);
    result.note += fmt::format("{}{:g} ms: {:.2e}", result.note.empty() ? "" : ", ", 1e3 * time_step, error);
    return error;
}

/// Slope of log error over log step, by least squares.
double order_of(const std::vector<double>& steps, const std::vector<double>& errors)
{
    double x_mean = 0, y_mean = 0, above = 0, below = 0;
    const auto n = static_cast<double>(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        x_mean += std::log(steps[i]) / n;
        y_mean += std::log(errors[i]) / n;
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double x = std::log(steps[i]) - x_mean;
        above += x * (std::log(errors[i]) - y_mean);
        below += x * x;
    }
    return above / below;
}

VerifyResult run_order(const scenes::SceneSetting& setting, const std::vector<double>& steps,
                       const RockingCase& rocking, const Exact& exact)
{
    VerifyResult result;
    std::vector<double> errors;
    for (const double h : steps) errors.push_back(error_at(setting, h, rocking, exact, result));
    const double order = order_of(steps, errors);
    result.error = std::abs(order - 2);
    result.note += fmt::format("; order {:.2f}", order);
    return result;
}

VerifyResult run_rigid_order(const scenes::SceneSetting& setting)
{
    return run_order(setting, {16e-3, 8e-3, 4e-3, 2e-3}, {.block = slender},
                     [](const std::vector<double>& times) { return references::rocking_angles(slender, times); });
}

VerifyResult run_spring_order(const scenes::SceneSetting& setting)
{
    const std::vector<double> steps{2e-3, 1e-3, 5e-4, 2.5e-4};
    const auto on = [&](double spring) {
        const RockingCase rocking = on_springs(spring);
        return run_order(setting, steps, rocking,
                         [&](const std::vector<double>& times) { return angles_on_springs(rocking, times); });
    };
    VerifyResult result = on(soft_spring), hard = on(hard_spring);
    result.note += fmt::format("; on springs of 1e8 N/m, which the larger steps do not resolve: {}", hard.note);
    result.cpu_time += hard.cpu_time;
    result.simulated_time += hard.simulated_time;
    result.steps += hard.steps;
    result.step_cuts += hard.step_cuts;
    result.iterations += hard.iterations;
    if (result.failure.empty()) result.failure = hard.failure;
    return result;
}

VerifyResult run_half_sine(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.error = error_at(
        setting, setting.time_step, {.block = slender},
        [](const std::vector<double>& times) { return references::rocking_angles(slender, times); }, result);
    return result;
}

// The block whose speed after an impact is 0.85 of that before.
const references::RockingBlock thick{0.5, 1.5, scenes::papers_gravity, 7, 2, false};
constexpr int impacts = 4;

/// Speed after each impact over that before: of a block that rocks freely from apex to apex.
std::vector<double> restitutions(const scenes::SceneSetting& setting, VerifyResult& result)
{
    RockingCase rocking{.block = thick};
    rocking.young = 1e10;
    int swings = 0;
    double last = 0;
    const LeanRecord record = watch_rocking(setting, rocking, 10, result, [&](double, double lean) {
        if (lean * last < 0) ++swings;
        if (lean != 0) last = lean;
        return swings > impacts + 1;
    });
    const std::vector<double> apexes = apexes_after(record, 0.5 / thick.frequency);
    std::vector<double> ratios;
    for (std::size_t i = 1; i < apexes.size() && i <= impacts; ++i)
        ratios.push_back(references::restitution_between(thick, apexes[i - 1], apexes[i]));
    return ratios;
}

VerifyResult run_impacts(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const double housner = references::housner_restitution(thick);
    for (const double h : {2e-3, 1e-3, 2e-4, 5e-5}) {
        scenes::SceneSetting stepped = setting;
        stepped.time_step = h;
        const std::vector<double> ratios = restitutions(stepped, result);
        if (ratios.size() < impacts) {
            result.failure = fmt::format("{} impacts of {} at {:g} ms", ratios.size(), impacts, 1e3 * h);
            return result;
        }
        double mean = 0;
        result.note += fmt::format("{}{:g} ms:", result.note.empty() ? "" : "; ", 1e3 * h);
        for (const double ratio : ratios) {
            mean += ratio / impacts;
            result.error = std::max(result.error, std::abs(ratio - housner));
            result.note += fmt::format(" {:.4f}", ratio);
        }
        result.note += fmt::format(", mean {:.4f}", mean);
    }
    return result;
}

Benchmark row(const std::string& name, const std::string& title, double tolerance,
              std::function<VerifyResult(const scenes::SceneSetting&)> run)
{
    Benchmark benchmark;
    benchmark.name = name;
    benchmark.title = title;
    benchmark.source = "[Housner1963] and [MakrisRoussos2000]; not from a paper on this method";
    benchmark.setting.kinematics = Kinematics::spatial_rigid;
    benchmark.setting.time_step = 2e-3;
    benchmark.tolerance = tolerance;
    benchmark.run = std::move(run);
    return benchmark;
}

}  // namespace

std::vector<Benchmark> rocking_default_benchmarks()
{
    std::vector<Benchmark> rows;
    rows.push_back(row("rocking-half-sine", "A rocking block of 0.2 x 0.6 m under a half sine, at defaults", 3e-5,
                       run_half_sine));
    rows.back().quantity = "largest |angle - that of the rigid block| until 0.45 s / largest angle";
    rows.back().setting.time_step = 1e-3;
    rows.back().sweep = sweep_of(rows.back().setting, {4e-3, 2e-3, 1e-3, 5e-4});

    rows.push_back(row("rocking-steps-follow",
                       "The same block, its steps at most 10 ms and of an error of 1.25 um", 2e-3, run_half_sine));
    rows.back().quantity = "largest |angle - that of the rigid block| until 0.45 s / largest angle";
    rows.back().setting.time_step = 10e-3;
    rows.back().setting.error_rate = 1.25;
    rows.back().choices =
        "`step_error` goes with the third power of `time_step`, as `voussoir converge` divides it.";
    for (const double h : {40e-3, 20e-3, 10e-3, 5e-3, 2.5e-3}) {
        rows.back().sweep.push_back(rows.back().setting);
        rows.back().sweep.back().time_step = h;
    }

    rows.push_back(
        row("rocking-order", "The order of the method before the first impact, 16 to 2 ms", 0.2, run_rigid_order));
    rows.back().quantity = "|slope of log error over log step - 2|, the error being that of rocking-half-sine";

    rows.push_back(
        row("rocking-order-springs", "The same block on springs of 1e6 N/m, 2 to 0.25 ms", 0.2, run_spring_order));
    rows.back().quantity =
        "|slope of log error over log step - 2|, against the rigid block on the same springs (integrated to "
        "1e-12)";
    rows.back().choices =
        "Springs of a given stiffness under both corners: before it lifts the block tilts on them, its lifting "
        "corner "
        "slips as its pressure falls and then opens, which the reference follows event by event.";

    for (Benchmark& swing : rows) add_planar(swing);
    // Planar, a contact point keeps its length; in space its area is that of the clipped face, which leans.
    rows.back().setting.kinematics = Kinematics::planar_rigid;
    rows.back().also.clear();

    rows.push_back(
        row("rocking-impacts", "Four impacts of a block of 1 x 3 m at 2, 1, 0.2 and 0.05 ms", 0.01, run_impacts));
    rows.back().quantity =
        "largest |speed after an impact / before - 0.850| of 16 impacts, by the apexes on each side";
    rows.back().choices =
        "A half sine of 7 m/s2 and 0.25 s sets the block rocking, to a tenth of the angle at which it falls. "
        "E = 10 GPa where it is deformable. What differs from Housner's impact is the vibration of the block on "
        "its "
        "joint, which nothing damps in steps that follow it: its speed, g over its circular frequency, adds to "
        "that of "
        "the landing. The error falls as the root of the stiffness (5e-4 at a hundred times E) and grows as the "
        "swings "
        "get smaller (1.1 % at 5.5 m/s2, where they are a twenty-fifth of that angle).";
    rows.back().also = {Kinematics::planar_rigid, Kinematics::spatial_deformable, Kinematics::planar_deformable};
    return rows;
}

}  // namespace voussoir::app::studies::verify
