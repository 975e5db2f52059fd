#include "app/problems/whole.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <map>

#include "app/problems/judge.h"
#include "libdda/run/run.h"

namespace voussoir::app::problems
{

namespace
{

constexpr double most_of_energy = 0.05;  // by which energies may differ
constexpr double small_energy = 0.01;    // of the largest of the run: a smaller one is compared with this

std::vector<double> centroids_of(const Model& model, const State& state)
{
    std::vector<double> all;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        const Eigen::Vector3d place = pose_of(model.kinematics, state, b).centroid;
        all.insert(all.end(), place.begin(), place.end());
    }
    return all;
}

constexpr double light = 0.1;  // of a block's weight: what presses less does not land

/// What the points of a state press with, in weights of the lighter block, by what names them from step to step.
template <int D>
auto pressing(const Model& model, double gravity, const State& state)
{
    std::map<std::array<std::uint32_t, 5>, double> forces;
    const ContactSetIn<D>& contacts = contacts_in<D>(state);
    const auto number = [](int index) { return static_cast<std::uint32_t>(index); };
    for (const ContactPatchIn<D>& patch : contacts.patches)
        for (int i = 0; i < patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts.points[patch.first_point + i];
            const double weight = gravity * std::min(model.mass(patch.block_a), model.mass(patch.block_b));
            forces[{number(patch.block_a), number(patch.block_b), number(patch.part_a), number(patch.part_b),
                    point.feature}] = point.status == ContactStatus::open ? 0 : point.normal_force / weight;
        }
    return forces;
}

/// Whether a point that was open has come to press in a step: an impact of which no impulse tells.
template <int D>
bool lands(const Model& model, double gravity, const State& before, const State& after)
{
    const auto old = pressing<D>(model, gravity, before), now = pressing<D>(model, gravity, after);
    return std::any_of(now.begin(), now.end(), [&](const auto& point) {
        const auto found = old.find(point.first);
        return point.second > light && found != old.end() && found->second == 0;
    });
}

/// Whether stones of the case land without impulses.
bool lands_on_springs(const Case& the_case)
{
    return std::any_of(the_case.model.joints.begin(), the_case.model.joints.end(),
                       [](const JointMaterial& joint) { return !joint.has_landing_law(); }) ||
           std::any_of(the_case.stages.begin(), the_case.stages.end(), [](const Stage& stage) {
               return stage.type == StageType::dynamic && stage.control.integrator == Integrator::newmark;
           });
}

/// Sees from when on two runs part: after an impact a hair makes all the difference, and after a cut the steps are
/// no longer the same.
class Parting
{
 public:
    Parting(const Case& the_case, const State& start)
        : case_(the_case), on_springs_(lands_on_springs(the_case)), before_(start)
    {
    }
    bool is_in(const State& after, const StepReport& step, const RunReport& report)
    {
        const Stage& stage = case_.stages[static_cast<std::size_t>(after.stage)];
        const bool in_time = stage.type == StageType::dynamic;
        bool found = in_time && (report.energy.impact > 0 || step.cuts > 0);
        if (in_time && on_springs_ && !found) found = has_landed(stage.gravity.norm(), after);
        if (on_springs_) before_ = after;
        return found;
    }

 private:
    bool has_landed(double gravity, const State& after) const
    {
        return is_planar(case_.model.kinematics) ? lands<2>(case_.model, gravity, before_, after)
                                                 : lands<3>(case_.model, gravity, before_, after);
    }

    const Case& case_;
    bool on_springs_;
    State before_;
};

WholeRun run_with(const Case& the_case, OpenClose of_motion)
{
    std::vector<Stage> stages = the_case.stages;
    for (Stage& stage : stages) {
        stage.control.threads = 1;
        if (stage.type != StageType::dynamic) continue;
        stage.control.open_close = of_motion;
        if (of_motion == OpenClose::plain) stage.control.max_open_close = plain_open_close;
    }
    WholeRun made;
    State state = initial_state(the_case.model);
    Parting parting(the_case, state);
    RunObserver observer;
    observer.step = [&](const State& after, const StepReport& step, const RunReport& report) {
        if (made.parting < 0 && parting.is_in(after, step, report)) made.parting = after.time;
    };
    observer.frame = [&](const State& now, const RunReport&) {
        const bool in_time = stages[static_cast<std::size_t>(now.stage)].type == StageType::dynamic;
        if (in_time && made.parting < 0) made.centroids.push_back(centroids_of(the_case.model, now));
    };
    const std::clock_t start = std::clock();
    made.report = run(the_case.model, stages, state, observer);
    made.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return made;
}

double largest_distance(const std::vector<double>& one, const std::vector<double>& other)
{
    double largest = 0;
    for (std::size_t i = 0; i + 2 < one.size(); i += 3)
        largest =
            std::max(largest, std::hypot(one[i] - other[i], one[i + 1] - other[i + 1], one[i + 2] - other[i + 2]));
    return largest;
}

/// Of the first dynamic stage: what one step may leave of a block's way [m].
double unit_of(const Case& the_case)
{
    const auto stage = std::find_if(the_case.stages.begin(), the_case.stages.end(),
                                    [](const Stage& each) { return each.type == StageType::dynamic; });
    if (stage == the_case.stages.end()) return 0;
    const double h = stage->control.time_step;
    return stage->control.force_tolerance * stage->gravity.norm() * h * h / 2;
}

double share_between(double one, double other, double scale)
{
    const double whole = std::max({std::abs(one), std::abs(other), small_energy * scale});
    return whole > 0 ? std::abs(one - other) / whole : 0;
}

}  // namespace

bool WholeComparison::passes() const
{
    return difference <= most_difference && one_outcome && input <= most_of_energy && dissipated <= most_of_energy;
}

WholeComparison compare_whole(const Case& the_case)
{
    WholeComparison both;
    both.fast = run_with(the_case, OpenClose::newton);
    both.plain = run_with(the_case, OpenClose::plain);
    const std::size_t frames = std::min(both.fast.centroids.size(), both.plain.centroids.size());
    const double unit = unit_of(the_case);
    for (std::size_t i = 0; i < frames; ++i) {
        const double distance = largest_distance(both.fast.centroids[i], both.plain.centroids[i]);
        const auto steps = static_cast<double>(i + 1);
        both.by_steps = std::max(both.by_steps, distance / (unit * steps));
        both.difference = std::max(both.difference, distance / (unit * steps * std::sqrt(steps)));
    }
    both.frames = static_cast<int>(frames);
    both.one_outcome = both.fast.report.outcome == both.plain.report.outcome;
    const EnergyLedger &fast = both.fast.report.energy, &plain = both.plain.report.energy;
    const double scale = std::max(fast.scale(), plain.scale());
    both.input = share_between(fast.input(), plain.input(), scale);
    both.dissipated = share_between(fast.dissipated(), plain.dissipated(), scale);
    return both;
}

}  // namespace voussoir::app::problems
