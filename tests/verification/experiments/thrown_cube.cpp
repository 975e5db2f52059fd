#include "tests/verification/experiments/thrown_cube.h"

#include <algorithm>
#include <cmath>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"
#include "tests/verification/experiments/laboratory.h"

namespace voussoir::verification
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double row_interval = 1.0 / 148;  // s
constexpr double half = cube_edge / 2;

/// The integral of x x^T that gives the inertia as it was read: I = tr(S) 1 - S.
Block cube_block()
{
    Block uniform = make_block("cube", 0, 1, {make_box(Vector3d::Constant(-half), Vector3d::Constant(half))});
    Moments moments = uniform.moments;
    moments.second = cube_inertia / 2 / (cube_mass / moments.volume) * Matrix3d::Identity();
    return make_block("cube", 0, 1, uniform.parts, moments);
}

Model cube_model(const CubeSetting& setting)
{
    JointMaterial joint = testing::dry(std::atan(setting.friction) / testing::degrees);
    joint.restitution = setting.restitution;
    if (setting.stiffness) joint.stiffness = {ContactStiffness::Kind::per_point, *setting.stiffness};
    Model model = make_model(Kinematics::spatial_rigid, testing::stone(), joint);
    model.materials.push_back({"plastic", cube_mass / std::pow(cube_edge, 3), setting.young, 0.35});
    const int table = testing::add_box(model, "table", {-3, -3, setting.table - 0.2}, {3, 3, setting.table});
    testing::hold(model, table);
    model.blocks.push_back(cube_block());
    return model;
}

void add_row(const LaboratoryTable& table, std::size_t row, TrackedMotion& motion)
{
    const auto at = [&](const char* name) { return table.number(row, name); };
    motion.times.push_back(at("t_s"));
    motion.centres.emplace_back(at("x_m"), at("y_m"), at("z_m"));
    motion.turns.push_back(Quaterniond(at("qw"), at("qx"), at("qy"), at("qz")).normalized());
}

Toss start_of(const LaboratoryTable& table, std::size_t row)
{
    const auto at = [&](const char* name) { return table.number(row, name); };
    Toss toss;
    toss.number = static_cast<int>(at("toss"));
    add_row(table, row, toss.measured);
    // The difference to the row before is the velocity half an interval ago; the cube is falling.
    toss.velocity = Vector3d(at("vx_m_s"), at("vy_m_s"), at("vz_m_s") - testing::gravity * row_interval / 2);
    toss.spin = toss.measured.turns[0] * Vector3d(at("wbx_rad_s"), at("wby_rad_s"), at("wbz_rad_s"));
    return toss;
}

/// Which face is up: 1 to 3 for the axes of the cube, negative for the opposite sides.
int face_up(const Quaterniond& turn)
{
    const Vector3d up = turn.toRotationMatrix().row(2);
    Eigen::Index axis = 0;
    up.cwiseAbs().maxCoeff(&axis);
    return static_cast<int>(axis + 1) * (up[axis] > 0 ? 1 : -1);
}

Quaterniond turn_of(const Model& model, const State& state)
{
    return Quaterniond(pose_of(model.kinematics, state, 1).map).normalized();
}

/// Adds the rows that lie between two states.
class RowKeeper
{
 public:
    RowKeeper(const Model& model, const Toss& toss, TrackedMotion& predicted)
        : model_(model), toss_(toss), predicted_(predicted)
    {
    }
    void note(const State& state)
    {
        const Vector3d centre = testing::centroid(model_, state, 1);
        const Quaterniond turn = turn_of(model_, state);
        for (std::size_t row = predicted_.times.size(); row < toss_.measured.times.size(); ++row) {
            const double time = toss_.measured.times[row];
            if (time > state.time + 1e-12) break;
            const double share = row == 0 ? 1 : (time - time_) / (state.time - time_);
            predicted_.times.push_back(time);
            predicted_.centres.push_back(row == 0 ? centre : Vector3d(centre_ + share * (centre - centre_)));
            predicted_.turns.push_back(row == 0 ? turn : turn_.slerp(share, turn));
        }
        time_ = state.time;
        centre_ = centre;
        turn_ = turn;
    }

 private:
    const Model& model_;
    const Toss& toss_;
    TrackedMotion& predicted_;
    double time_ = 0;
    Vector3d centre_ = Vector3d::Zero();
    Quaterniond turn_ = Quaterniond::Identity();
};

double horizontal(const Vector3d& v)
{
    return v.head<2>().norm();
}

TossScore score_of(const Toss& toss, const CubeSetting& setting, const CubeModel& model)
{
    TossScore score;
    const TrackedMotion& measured = toss.measured;
    const TrackedMotion predicted = model(toss, setting, score.ran);
    const std::size_t rows = predicted.times.size();
    for (std::size_t i = 0; i < rows; ++i) {
        const double distance = (predicted.centres[i] - measured.centres[i]).norm();
        score.position += distance / static_cast<double>(rows);
        score.rotation +=
            predicted.turns[i].angularDistance(measured.turns[i]) / testing::degrees / static_cast<double>(rows);
        score.distances.push_back(distance);
    }
    score.right_face = face_up(predicted.turns.back()) == face_up(measured.turns.back());
    const Vector3d went = measured.centres.back() - measured.centres.front();
    const Vector3d goes = predicted.centres.back() - predicted.centres.front();
    score.travel = horizontal(goes - went);
    score.measured_travel = horizontal(went);
    score.predicted_travel = horizontal(goes);
    return score;
}

}  // namespace

std::vector<Toss> read_tosses(const std::filesystem::path& file)
{
    const LaboratoryTable table = read_laboratory_table(file);
    std::vector<Toss> tosses;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (tosses.empty() || tosses.back().number != static_cast<int>(table.number(row, "toss")))
            tosses.push_back(start_of(table, row));
        else
            add_row(table, row, tosses.back().measured);
    }
    return tosses;
}

TrackedMotion predicted_toss(const Toss& toss, const CubeSetting& setting, bool& ran)
{
    const Model model = cube_model(setting);
    State state = initial_state(model);
    testing::set_pose(model, state, 1, toss.measured.centres[0], toss.measured.turns[0].toRotationMatrix());
    testing::set_velocity(model, state, 1, toss.velocity, toss.spin);
    TrackedMotion predicted;
    RowKeeper keeper(model, toss, predicted);
    keeper.note(state);
    Stage stage = testing::dynamic_stage(toss.measured.times.back(), setting.control.time_step);
    stage.control = setting.control;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) { keeper.note(now); };
    // A stone thrown up and down by more than its size counts as fallen.
    const Outcome outcome = run(model, {stage}, state, observer).outcome;
    ran = (outcome == Outcome::completed || outcome == Outcome::collapsed) &&
          predicted.times.size() == toss.measured.times.size();
    return predicted;
}

std::vector<TossScore> scores_of(const std::vector<Toss>& tosses, const CubeSetting& setting,
                                 const CubeModel& model)
{
    std::vector<TossScore> scores(tosses.size());
    for_each_case(static_cast<int>(tosses.size()),
                  [&](int i) { scores[i] = score_of(tosses[i], setting, model); });
    return scores;
}

CubeFigures figures_of(const std::vector<TossScore>& scores)
{
    std::vector<double> position, rotation, travel, bias;
    CubeFigures figures;
    for (const TossScore& score : scores) {
        position.push_back(score.position);
        rotation.push_back(score.rotation);
        travel.push_back(score.travel);
        bias.push_back(score.predicted_travel - score.measured_travel);
        figures.right_faces += score.right_face / static_cast<double>(scores.size());
        figures.stopped += score.ran ? 0 : 1;
        figures.mean_position += score.position / static_cast<double>(scores.size());
    }
    const double right = figures.right_faces;
    figures.right_faces_error = std::sqrt(right * (1 - right) / static_cast<double>(scores.size()));
    figures.position = median_of(position);
    figures.position_low = quantile_of(position, 0.25);
    figures.position_high = quantile_of(position, 0.75);
    figures.rotation = median_of(rotation);
    figures.travel = median_of(travel);
    figures.travel_bias = median_of(bias);
    return figures;
}

}  // namespace voussoir::verification
