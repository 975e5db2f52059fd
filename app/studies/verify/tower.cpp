// The slender tower: stands under a strong sine, its joints sliding more the higher they are.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "app/studies/verify/families.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/run_scene.h"
#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{

namespace
{

constexpr int courses = 100;  // printed, as height = 10 x width
constexpr double width = 2;   // m, not printed
constexpr double course_height = 10 * width / courses;
constexpr double density = 2400, young = 1e10;                          // not printed
constexpr double friction = 30;                                         // degrees, printed
constexpr double peak = 0.5 * scenes::papers_gravity, frequency = 2.5;  // printed
constexpr double duration = 4;                                          // s, ten cycles, not printed

scenes::StagedScene tower_scene(const scenes::SceneSetting& setting)
{
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = friction * std::numbers::pi / 180;
    joint.stiffness = scenes::stiffness_by_rule(setting, 2 * course_height / young);
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"masonry", density, young, 0.2}, joint, width);
    scenes::hold(scene.model,
                 scenes::add_box(scene.model, "base", {-2 * width, -width, -1}, {2 * width, width, 0}));
    for (int i = 0; i < courses; ++i)
        scenes::add_box(scene.model, fmt::format("course {}", i + 1),
                        {-0.5 * width, -0.5 * width, i * course_height},
                        {0.5 * width, 0.5 * width, (i + 1) * course_height});
    Stage shaking = scenes::dynamic_stage(setting, duration);
    const GroundMotion sine = GroundMotion::sine_acceleration(peak, frequency, 0, duration);
    shaking.motions = {{0, 0, std::make_shared<const GroundMotion>(sine)}};
    scene.stages = {scenes::static_stage(setting), shaking};
    return scene;
}

/// Path of sliding in every joint [m], the lowest first: what the contact springs call plastic slip, over the
/// steps.
class SlipPaths
{
 public:
    template <int D>
    void add(const ContactSetIn<D>& contacts)
    {
        std::vector<Eigen::Vector3d> now(courses, Eigen::Vector3d::Zero());
        std::vector<double> area(courses, 0);
        for (const ContactPatchIn<D>& patch : contacts.patches) {
            if (std::abs(patch.block_a - patch.block_b) != 1) continue;
            const int joint = std::min(patch.block_a, patch.block_b);
            const double sign = patch.block_a > patch.block_b ? 1 : -1;
            for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
                const ContactPointIn<D>& point = contacts.points[i];
                now[joint] += sign * point.area * to_space(point.plastic_slip);
                area[joint] += point.area;
            }
        }
        for (int j = 0; j < courses; ++j) {
            if (area[j] == 0) continue;
            now[j] /= area[j];
            length[j] += (now[j] - last_[j]).norm();
            last_[j] = now[j];
        }
    }

    std::vector<double> length = std::vector<double>(courses, 0);

 private:
    std::vector<Eigen::Vector3d> last_ = std::vector<Eigen::Vector3d>(courses, Eigen::Vector3d::Zero());
};

std::vector<double> ranks(const std::vector<double>& values)
{
    std::vector<int> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
    std::vector<double> rank(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<double>(i);
    return rank;
}

/// Spearman's rank correlation with the place in the list.
double rank_correlation(const std::vector<double>& values)
{
    const std::vector<double> rank = ranks(values);
    const auto n = static_cast<double>(values.size());
    double sum = 0;
    for (std::size_t i = 0; i < rank.size(); ++i) sum += std::pow(rank[i] - static_cast<double>(i), 2);
    return 1 - 6 * sum / (n * (n * n - 1));
}

double mean(const std::vector<double>& values, int first, int last)
{
    return std::accumulate(values.begin() + first, values.begin() + last, 0.0) / (last - first);
}

/// What is left of the tower: the lowest that any course has sunk, and the largest offset of neighbours.
struct Remains {
    double sunk = 0, offset = 0, top = 0;  // m
};

Remains remains_of(const Model& model, const State& state)
{
    Remains remains;
    Eigen::Vector3d below = pose_of(model.kinematics, state, 0).centroid;
    const double base = below.x();
    for (int i = 1; i <= courses; ++i) {
        const Eigen::Vector3d centroid = pose_of(model.kinematics, state, i).centroid;
        remains.sunk = std::max(remains.sunk, (i - 0.5) * course_height - centroid.z());
        remains.offset = std::max(remains.offset, std::abs(centroid.x() - below.x()));
        remains.top = centroid.x() - base;
        below = centroid;
    }
    return remains;
}

VerifyResult run_tower(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const scenes::StagedScene scene = tower_scene(setting);
    State state = initial_state(scene.model);
    SlipPaths paths;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        if (now.stage != 1) return;
        if (is_planar(setting.kinematics))
            paths.add(now.planar_contacts);
        else
            paths.add(now.contacts);
    };
    run_scene(scene, state, observer, result);
    if (!result.failure.empty()) return result;
    const Remains remains = remains_of(scene.model, state);
    const double correlation = rank_correlation(paths.length), quarter = courses / 4;
    const double low = mean(paths.length, 0, courses / 4),
                 high = mean(paths.length, courses - courses / 4, courses);
    std::vector<double> course(courses);
    std::iota(course.begin(), course.end(), 1);
    result.picture =
        linear_diagram("joint, from the base", "slip path [m]", {curve_of("engine", course, paths.length)});
    const bool stands = remains.sunk < 0.5 * course_height && remains.offset < 0.5 * width;
    result.error = (stands ? 0 : 1) + (correlation > 0 ? 0 : 1) + (high > low ? 0 : 1);
    result.note = fmt::format(
        "{}: top displaced {:+.3f} m, largest offset of neighbours {:.4f} m, courses sunk by at most {:.4f} m; "
        "rank "
        "correlation of slip with height {:+.2f}; slip path of a joint {:.2e} m in the top {:.0f} courses, {:.2e} "
        "m in "
        "the lowest",
        stands ? "stands" : "falls", remains.top, remains.offset, remains.sunk, correlation, high, quarter, low);
    return result;
}

}  // namespace

std::vector<Benchmark> tower_benchmarks()
{
    Benchmark row;
    row.name = "slender-tower";
    row.title = "A tower of 100 courses under 0.5 g at 2.5 Hz";
    row.source = "ma, figure 2";
    row.quantity =
        "statements contradicted: stands; slip increases with height; top quarter slides more than the lowest";
    row.paper_error = "apparently performs well; slides more with height (figure not available)";
    row.setting = as_in_papers({.kinematics = Kinematics::spatial_rigid, .time_step = 1e-3});
    row.sweep = sweep_of(row.setting, {5e-3, 2e-3, 1e-3, 5e-4});
    row.run = run_tower;
    return {row};
}

}  // namespace voussoir::app::studies::verify
