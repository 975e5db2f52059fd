#include "tests/peers/trials.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "app/studies/scenes/stages.h"
#include "app/studies/verify/limit_masonry.h"
#include "app/studies/verify/references/rocking.h"
#include "app/studies/verify/references/sliding.h"
#include "libdda/errors.h"

namespace voussoir::peers
{

std::string march(const Scene& scene, double h, const std::function<void(const Eigen::Vector3d&)>& step,
                  const PlaceOf& place_of, const Watch& watch)
{
    const auto at_rest = std::llround(scene.rest / h), moving = std::llround(scene.duration / h);
    for (long i = 0; i < at_rest; ++i) step(Eigen::Vector3d::Zero());
    watch(0, place_of);
    for (long i = 0; i < moving; ++i) {
        const double from = static_cast<double>(i) * h, to = static_cast<double>(i + 1) * h;
        step(mean_push(scene, from, to));
        if (!watch(to, place_of)) break;
    }
    for (std::size_t block = 0; block < scene.bodies.size(); ++block)
        if (!place_of(static_cast<int>(block)).centroid.allFinite()) return "a position is no number";
    return {};
}

namespace
{

namespace references = app::studies::verify::references;
using Eigen::Vector3d;

double cpu_now()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string run_engine(const Scene& scene, const Setting& setting, const Watch& watch)
{
    if (setting.engine == "voussoir") return run_voussoir(scene, setting, watch);
    if (setting.engine.starts_with("bullet")) return run_bullet(scene, setting, watch);
    if (setting.engine.starts_with("ode")) return run_ode(scene, setting, watch);
    throw InputError("voussoir-peers", "engine " + setting.engine, "must be one that scripts/peers names");
}

/// Runs a scene and books its cost.
void observe(const Scene& scene, const Setting& setting, const Watch& watch, Finding& finding)
{
    long steps = -1;
    const double start = cpu_now();
    const std::string failure = run_engine(scene, setting, [&](double time, const PlaceOf& place_of) {
        ++steps;
        return watch(time, place_of);
    });
    const double cost = cpu_now() - start;
    if (finding.failure.empty()) finding.failure = failure;
    finding.cpu_time += cost;
    finding.step_time = cost / static_cast<double>(std::max(1L, steps));
}

/// Equation 8 seen from the foundation, at the times of a run.
std::vector<references::SlidingPoint> exact_sliding(bool across, const std::vector<double>& times)
{
    const std::vector<FoundationWave> waves = foundation_waves(across);
    references::SlidingProblem problem;
    problem.driving = [waves](double t) {
        Eigen::Vector2d driving;
        for (int axis = 0; axis < 2; ++axis) {
            const double omega = 2 * std::numbers::pi * waves[axis].frequency;
            driving[axis] = -waves[axis].amplitude * omega * omega * std::cos(omega * t);
        }
        return driving;
    };
    problem.pressing = [](double) { return app::studies::scenes::papers_gravity; };
    problem.friction = 0.6;
    return references::slide(problem, times);
}

/// Largest distance from the reference / largest displacement.
Finding slide(bool across, const Setting& setting)
{
    Finding finding;
    std::vector<double> times;
    std::vector<Vector3d> places;
    const auto watch = [&](double time, const PlaceOf& place_of) {
        times.push_back(time);
        places.push_back(place_of(1).centroid);
        return true;
    };
    observe(sliding_block(across), setting, watch, finding);
    const std::vector<references::SlidingPoint> exact = exact_sliding(across, times);
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Vector3d slid(exact[i].displacement.x(), exact[i].displacement.y(), 0);
        worst = std::max(worst, (places[i] - places[0] - slid).norm());
        largest = std::max(largest, slid.norm());
    }
    finding.error = worst / largest;
    return finding;
}

/// Largest |angle - reference| / peak angle, up to the first impact of the reference.
Finding rock(const Setting& setting)
{
    const references::RockingBlock block{
        rocking_half_width, rocking_half_height, app::studies::scenes::papers_gravity,
        rocking_amplitude,  rocking_frequency,   false};
    const double end = *references::first_impact(block);
    Finding finding;
    std::vector<double> times, angles;
    const auto watch = [&](double time, const PlaceOf& place_of) {
        const Vector3d axis = place_of(1).turn.col(2);
        times.push_back(time);
        angles.push_back(std::atan2(axis.x(), axis.z()));
        return true;
    };
    observe(rocking_block(end), setting, watch, finding);
    const std::vector<double> exact = references::rocking_angles(block, times);
    double worst = 0, peak = 0;
    for (std::size_t i = 0; i < times.size() && times[i] <= end; ++i) {
        worst = std::max(worst, std::abs(angles[i] - angles[0] - exact[i]));
        peak = std::max(peak, std::abs(exact[i]));
    }
    finding.error = worst / peak;
    return finding;
}

/// Largest distance of a block from where it was when the motion began.
double largest_shift(const std::vector<Vector3d>& start, const PlaceOf& place_of)
{
    double shift = 0;
    for (std::size_t block = 0; block < start.size(); ++block)
        shift = std::max(shift, (place_of(static_cast<int>(block)).centroid - start[block]).norm());
    return shift;
}

/// Largest distance [m] of a block at the end from where it was at the beginning of the motion, four whole cycles
/// earlier.
Finding shake_wall(int courses, int blocks, const Setting& setting)
{
    Finding finding;
    const Scene scene = shaken_wall(courses, blocks);
    std::vector<Vector3d> start;
    const auto watch = [&](double time, const PlaceOf& place_of) {
        if (time == 0)
            for (std::size_t block = 0; block < scene.bodies.size(); ++block)
                start.push_back(place_of(static_cast<int>(block)).centroid);
        if (time > scene.duration - setting.time_step / 2) finding.error = largest_shift(start, place_of);
        return true;
    };
    observe(scene, setting, watch, finding);
    return finding;
}

constexpr double fallen = 0.01;  // of the radius

/// Whether an arch falls in the 3 s after its weight is there.
bool arch_falls(double share, const Setting& setting, Finding& finding)
{
    const Scene scene = semicircular_arch(share);
    std::vector<Vector3d> start;
    for (const Block& block : scene.model.blocks) start.push_back(block.moments.centroid);
    bool falls = false;
    const auto watch = [&](double, const PlaceOf& place_of) {
        falls = largest_shift(start, place_of) > fallen * arch_radius;
        return !falls;
    };
    observe(scene, setting, watch, finding);
    return falls;
}

/// |least thickness at which the arch stands / that of limit analysis - 1|, by bisection.
Finding find_least_thickness(const Setting& setting)
{
    const auto bisect = [](double low, double high, double width, const auto& stands) {
        while (high - low > width) {
            const double middle = (low + high) / 2;
            (stands(middle) ? high : low) = middle;
        }
        return (low + high) / 2;
    };
    const double reference = bisect(0.1, 0.115, 1e-6, [](double share) {
        return limit::associated_limit(app::studies::verify::limit_problem(semicircular_arch(share).model)).found;
    });
    Finding finding;
    constexpr double thin = 0.09, thick = 0.25;
    const bool thick_falls = arch_falls(thick, setting, finding);
    finding.error = thick / reference - 1;
    if (thick_falls) finding.failure = "the arch falls even at 0.25 of the radius";
    if (!finding.failure.empty()) return finding;
    finding.error = 1 - thin / reference;
    if (!arch_falls(thin, setting, finding)) finding.failure = "the arch stands even at 0.09 of the radius";
    if (!finding.failure.empty()) return finding;
    const double found =
        bisect(thin, thick, 1e-5, [&](double share) { return !arch_falls(share, setting, finding); });
    finding.error = std::abs(found / reference - 1);
    return finding;
}

}  // namespace

Finding run_trial(const std::string& name, const Setting& setting)
{
    if (name == "sliding") return slide(false, setting);
    if (name == "sliding_across") return slide(true, setting);
    if (name == "rocking") return rock(setting);
    if (name == "wall_100") return shake_wall(8, 12, setting);
    if (name == "wall_504") return shake_wall(16, 31, setting);
    if (name == "arch") return find_least_thickness(setting);
    throw InputError("voussoir-peers", "scene " + name, "must be one that scripts/peers names");
}

}  // namespace voussoir::peers
