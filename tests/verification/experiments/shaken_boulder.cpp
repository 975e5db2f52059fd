#include "tests/verification/experiments/shaken_boulder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "importers/helper/import_meshes.h"
#include "libdda/errors.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"
#include "tests/verification/experiments/laboratory.h"

namespace voussoir::verification
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double mass = 353.8;           // kg, as read
constexpr double overturned_tilt = 45;   // degrees
constexpr double another_face = 8;       // degrees at the end: the barrier of the rest it started from is 12
constexpr double rest_after_motion = 2;  // s
constexpr double sampling_interval = 0.005;

Model boulder_model(const BoulderShape& shape, const BoulderSetting& setting)
{
    JointMaterial joint = testing::dry(std::atan(setting.friction) / testing::degrees);
    joint.restitution = setting.restitution;
    if (setting.stiffness) joint.stiffness = {ContactStiffness::Kind::per_point, *setting.stiffness};
    const BlockMaterial granite{"granite", mass / shape.moments.volume, setting.young, 0.25};
    Model model = make_model(Kinematics::spatial_rigid, granite, joint);
    testing::hold(model, testing::add_box(model, "table", {-4, -4, -0.5}, {4, 4, 0}));
    model.blocks.push_back(make_block("boulder", 0, 0, shape.parts, shape.moments));
    return model;
}

Stage shaking(const TableMotion& test, const BoulderSetting& setting)
{
    Stage stage = testing::dynamic_stage(test.motion->duration() + rest_after_motion, setting.control.time_step,
                                         {0, 0, -standard_gravity});
    stage.control = setting.control;
    stage.motions = {{0, 0, std::make_shared<GroundMotion>(test.motion->scaled(setting.sign))}};
    return stage;
}

Stage settling(const BoulderSetting& setting)
{
    Stage stage = testing::static_stage(5e-3, {0, 0, -standard_gravity});
    stage.control.integrator = setting.control.integrator;
    return stage;
}

/// Follows how far the boulder leans from where it stood when the shaking began.
class TiltWatch
{
 public:
    TiltWatch(const Model& model, BoulderEnd& end) : model_(model), end_(end) {}

    void begin(const State& state)
    {
        const Matrix3d map = pose_of(model_.kinematics, state, 1).map;
        up_ = map.transpose() * Vector3d::UnitZ();
        start_ = place(state);
    }
    void note(const State& state)
    {
        const Vector3d up_now = pose_of(model_.kinematics, state, 1).map * up_;
        end_.last_tilt = std::acos(std::clamp(up_now.z(), -1.0, 1.0)) / testing::degrees;
        end_.largest_tilt = std::max(end_.largest_tilt, end_.last_tilt);
        end_.moved = (place(state) - start_).norm();
    }

 private:
    Vector3d place(const State& state) const
    {
        return testing::centroid(model_, state, 1) - testing::centroid(model_, state, 0);
    }

    const Model& model_;
    BoulderEnd& end_;
    Vector3d up_ = Vector3d::UnitZ(), start_ = Vector3d::Zero();
};

double thread_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::shared_ptr<const GroundMotion> read_motion(const std::filesystem::path& file)
{
    const LaboratoryTable table = read_laboratory_table(file);
    std::vector<double> samples;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double expected = sampling_interval * static_cast<double>(row);
        if (std::abs(table.number(row, "time_s") - expected) > 1e-6)
            throw InputError({{file.string(), table.word(row, "time_s"), "200 samples a second"}});
        samples.push_back(table.number(row, "displacement_m"));
    }
    return std::make_shared<GroundMotion>(
        GroundMotion::from_displacement(std::move(samples), sampling_interval, file.filename().string()));
}

void count(bool predicted, bool measured, BoulderFigures& figures)
{
    ++figures.tests;
    figures.right += predicted == measured ? 1 : 0;
    figures.false_overturnings += predicted && !measured ? 1 : 0;
    figures.misses += !predicted && measured ? 1 : 0;
}

}  // namespace

BoulderShape read_boulder()
{
    importers::helper::MeshRequest request;
    request.file = laboratory_folder("boulder") / "SP1.obj";
    request.simplify.parts = 12;
    request.simplify.volume_error = 0.02;
    const importers::helper::ImportedMesh mesh = importers::helper::import_meshes({request}).meshes.at(0);
    if (!mesh.accepted) throw InputError({{request.file.string(), mesh.reason, "a stone"}});
    const importers::helper::Stone& stone = mesh.stones.at(0);
    double lowest = 1e300;
    for (const ConvexPolyhedron& part : stone.parts)
        for (const Vector3d& x : part.vertices) lowest = std::min(lowest, x.z());
    const Vector3d shift(-stone.moments.centroid.x(), -stone.moments.centroid.y(), -lowest);
    BoulderShape shape{{}, stone.moments};
    shape.moments.centroid += shift;
    for (const ConvexPolyhedron& part : stone.parts) shape.parts.push_back(translated(part, shift));
    return shape;
}

std::vector<TableMotion> read_table_motions()
{
    const LaboratoryTable table = read_laboratory_table(laboratory_folder("boulder") / "tests.csv");
    std::vector<TableMotion> tests;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        tests.push_back({static_cast<int>(table.number(row, "id")), table.word(row, "record"),
                         table.number(row, "overturned") > 0, table.number(row, "listed_pgv_m_s"),
                         table.number(row, "listed_pga_g"),
                         read_motion(laboratory_folder("boulder") / table.word(row, "file"))});
    return tests;
}

BoulderEnd end_of(const BoulderShape& shape, const TableMotion& test, const BoulderSetting& setting)
{
    const double start = thread_seconds();
    const Model model = boulder_model(shape, setting);
    State state = initial_state(model);
    BoulderEnd end;
    end.settled = testing::run_quietly(model, {settling(setting)}, state).outcome == Outcome::completed;
    std::fill(state.velocities.begin(), state.velocities.end(), 0.0);
    begin_stage(model, 0, state);
    TiltWatch watch(model, end);
    watch.begin(state);
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) { watch.note(now); };
    observer.stop = [&] { return end.last_tilt > overturned_tilt; };
    const Outcome outcome = run(model, {shaking(test, setting)}, state, observer).outcome;
    end.overturned = end.last_tilt > another_face;
    end.ran = outcome == Outcome::completed || outcome == Outcome::collapsed || end.last_tilt > overturned_tilt;
    end.seconds = thread_seconds() - start;
    return end;
}

std::vector<BoulderEnd> ends_of(const BoulderShape& shape, const std::vector<TableMotion>& tests,
                                const BoulderSetting& setting)
{
    std::vector<BoulderEnd> ends(tests.size());
    for_each_case(static_cast<int>(tests.size()), [&](int i) { ends[i] = end_of(shape, tests[i], setting); });
    return ends;
}

BoulderFigures figures_of(const std::vector<TableMotion>& tests, const std::vector<BoulderEnd>& ends)
{
    BoulderFigures figures;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        count(ends[i].overturned, tests[i].overturned, figures);
        figures.stopped += ends[i].ran && ends[i].settled ? 0 : 1;
    }
    return figures;
}

BoulderFigures figures_of_threshold(const std::vector<TableMotion>& tests, double threshold)
{
    BoulderFigures figures;
    for (const TableMotion& test : tests) count(test.peak_velocity > threshold, test.overturned, figures);
    return figures;
}

}  // namespace voussoir::verification
