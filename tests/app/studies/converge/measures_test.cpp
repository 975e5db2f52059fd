// Words for quantities, what is recorded of a run, and the measures on histories that are made up.
#include <gtest/gtest.h>

#include <cmath>

#include "app/reader/case_file.h"
#include "app/studies/converge/quantity.h"
#include "app/studies/converge/recorder.h"
#include "app/studies/converge/sample.h"
#include "app/studies/converge/setting.h"
#include "app/words/figures_in_words.h"
#include "libdda/errors.h"
#include "libdda/model/state.h"
#include "tests/app/test_files.h"

namespace voussoir::app::studies::converge
{
namespace
{

using Eigen::Vector3d;

class Measures : public ::testing::Test
{
 protected:
    TemporaryFolder folder_;
    Case case_ = reader::read_case(folder_.write("case.yaml", two_boxes), {});

    std::vector<std::string> names(const std::vector<std::string>& words) const
    {
        std::vector<std::string> list;
        for (const Quantity& quantity : read_quantities(words, case_)) list.push_back(name_of(quantity, case_));
        return list;
    }
    std::string refusal(const std::vector<std::string>& words) const
    {
        try {
            read_quantities(words, case_);
        } catch (const InputError& error) {
            return to_sentence(error.faults.front());
        }
        return "no refusal";
    }
};

TEST_F(Measures, AreReadFromWords)
{
    EXPECT_EQ(names({"top.ux", "top.d:peak", "largest:end", "top.ux"}),
              (std::vector<std::string>{"top.ux:history", "top.d:peak", "largest:end"}));
    EXPECT_EQ(names({}), std::vector<std::string>{"top.d:history"});
    case_.output.histories.clear();
    EXPECT_EQ(names({}), (std::vector<std::string>{"largest:peak", "largest:end"}));
}

TEST_F(Measures, UnknownOnesAreRefusedWithTheNearest)
{
    EXPECT_NE(refusal({"topp.ux"}).find("did you mean top.ux?"), std::string::npos) << refusal({"topp.ux"});
    EXPECT_NE(refusal({"top.ux:peek"}).find("did you mean peak?"), std::string::npos) << refusal({"top.ux:peek"});
    case_.model.kinematics = Kinematics::planar_rigid;
    EXPECT_EQ(refusal({"top.dz"}), "no refusal");
    EXPECT_NE(refusal({"top.dy"}).find("top.dy"), std::string::npos) << refusal({"top.dy"});
    EXPECT_NE(refusal({"largest:"}).find("history, peak, end"), std::string::npos) << refusal({"largest:"});
}

TEST_F(Measures, TakeHistoryPeakAndEnd)
{
    Recording recording;
    recording.values.resize(1);
    for (int i = 0; i <= 4; ++i) {  // 0, -1, -4, -9, -16 at 0, 1, ... s
        recording.times.push_back(i);
        recording.values[0].emplace_back(-i * i, 0, 0);
    }
    Quantity quantity;
    quantity.component = 0;
    const Sample at = sample_of(quantity, recording, {0, 1.5, 3, 3.5, 4});
    EXPECT_EQ(at.cols(), 5);
    for (const auto& [column, value] : {std::pair(0, 0.0), {1, -2.5}, {2, -9.0}, {3, -12.5}, {4, -16.0}})
        EXPECT_DOUBLE_EQ(at(0, column), value);
    EXPECT_DOUBLE_EQ(value_of(quantity, at), 16);
    quantity.measure = Measure::peak;
    EXPECT_DOUBLE_EQ(sample_of(quantity, recording, {0, 3})(0, 0), 9);
    quantity.measure = Measure::end;
    EXPECT_DOUBLE_EQ(value_of(quantity, sample_of(quantity, recording, {0, 4})), -16);
    quantity.component = -1;
    EXPECT_DOUBLE_EQ(value_of(quantity, sample_of(quantity, recording, {0, 4})), 16);
}

/// The floor moves by `ground`, the stone by `stone`.
State moved(const Model& model, double time, const Vector3d& ground, const Vector3d& stone)
{
    State state = initial_state(model);
    const std::size_t per_block = state.coordinates.size() / model.blocks.size();
    Eigen::Map<Vector3d>{state.coordinates.data()} += ground;
    Eigen::Map<Vector3d>{state.coordinates.data() + per_block} += stone;
    state.time = time;
    return state;
}

TEST_F(Measures, DriftIsRelativeToTheGroundSinceTheMotionBegan)
{
    Recorder recorder(case_, read_quantities({"top.u", "top.d", "top.dz", "largest"}, case_), {});
    recorder.step(moved(case_.model, 0, {0, 0, 0}, {0, 0, -0.01}));  // it settles: time stands
    recorder.step(moved(case_.model, 1, {0.2, 0, 0}, {0.5, 0, -0.03}));
    const Recording& found = recorder.recording;
    EXPECT_EQ(found.times, (std::vector<double>{0, 1}));
    EXPECT_TRUE(found.values[0][0].isApprox(Vector3d(0, 0, -0.01)));
    EXPECT_TRUE(found.values[0][1].isApprox(Vector3d(0.5, 0, -0.03)));
    EXPECT_TRUE(found.values[1][0].isZero());
    EXPECT_TRUE(found.values[1][1].isApprox(Vector3d(0.3, 0, -0.02)));
    EXPECT_NEAR(found.values[2][1].x(), -0.02, 1e-15);
    EXPECT_NEAR(found.values[3][1].x(), std::hypot(0.3, 0.02), 1e-15);
    EXPECT_FALSE(recorder.collapse);
}

TEST_F(Measures, CollapseIsADisplacementRelativeToTheGround)
{
    const auto collapses = [&](const CollapseRule& rule, double ground, double stone) {
        Recorder recorder(case_, {}, rule);
        recorder.step(moved(case_.model, 2, {ground, 0, 0}, {stone, 0, 0}));
        return recorder.collapse.has_value();
    };
    EXPECT_TRUE(collapses({}, 0, 1.001));  // a cube of 1 m
    EXPECT_FALSE(collapses({}, 0, 0.999));
    EXPECT_FALSE(collapses({}, 5, 5.5));
    EXPECT_TRUE(collapses({{}, 0.1}, 5, 5.11));
    EXPECT_FALSE(collapses({{}, {}}, 0, 100));
}

TEST_F(Measures, SettingsChangeDynamicStagesAndAllJoints)
{
    const Case changed = with_setting(case_, {Integrator::newmark, 0.5, 4});
    EXPECT_EQ(changed.stages[0].control.time_step, case_.stages[0].control.time_step);
    EXPECT_EQ(changed.stages[0].control.integrator, case_.stages[0].control.integrator);
    EXPECT_EQ(changed.stages[1].control.time_step, 1e-3);
    EXPECT_EQ(changed.stages[1].control.integrator, Integrator::newmark);
    EXPECT_EQ(changed.model.joints[0].stiffness.factor, 4);
}

TEST_F(Measures, PlansRunFromCoarseToFine)
{
    const ConvergePlan plan = plan_of({{"1 ms", "0.004", "2 ms"}, {2, 0.5, 1}, {"newmark"}}, case_);
    EXPECT_EQ(plan.step_factors, (std::vector<double>{2, 1, 0.5}));
    EXPECT_EQ(plan.stiffness_factors, (std::vector<double>{0.5, 1, 2}));
    EXPECT_EQ(plan.integrators, (std::vector{Integrator::energy_decaying, Integrator::newmark}));
    try {
        plan_of({{"1 m", "-1 ms"}, {1, 1}, {"newmarc"}}, case_);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.faults.size(), 4u) << error.what();
    }
}

TEST_F(Measures, PlansRefuseWhatIsNoNumber)
{
    EXPECT_THROW(plan_of({{}, {std::nan(""), 1}, {}}, case_), InputError);
}

// The stage lasts 0.2 s.
TEST_F(Measures, PlansHoldOnlyStepsThatCanBeRun)
{
    EXPECT_THROW(plan_of({{"1 ms", "0.3 s"}, {}, {}}, case_), InputError);
    EXPECT_NO_THROW(plan_of({{"1 ms", "0.2 s"}, {}, {}}, case_));
    EXPECT_TRUE(plan_of({}, case_).notes.empty());
    case_.stages[1].control.time_step = 0.1;
    case_.stages[1].control.min_time_step = 0.05;
    const ConvergePlan plan = plan_of({}, case_);
    EXPECT_EQ(plan.step_factors, (std::vector<double>{2, 1, 0.5}));
    EXPECT_EQ(plan.notes.size(), 2u);
    EXPECT_THROW(plan_of({{"0.1 s", "10 ms"}, {}, {}}, case_), InputError);
}

TEST(Words, StepsAreInMillisecondsBelowASecond)
{
    EXPECT_EQ(words::step_in_words(2e-3), "2 ms");
    EXPECT_EQ(words::step_in_words(0.5), "500 ms");
    EXPECT_EQ(words::step_in_words(20), "20 s");
}

}  // namespace
}  // namespace voussoir::app::studies::converge
