// Mosca's bridge as Ma et al. ran it: gravity for 0.02 s, then 0.5 g at 2.5 Hz for 0.4 s, E = 4.5 GPa, 2 ms,
// rise 1.5 m. The paper's curves are pictures we do not have; its words are: compression up to 5 MPa and tension
// of 10 kPa without damping, high stresses around the centre of the span, and with 6 % velocity reduction more
// concentrated there.
#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <memory>

#include "tests/verification/bridge_model.h"

namespace voussoir::verification
{

namespace
{

using Eigen::Vector3d;

enum class Abutments { prescribed, free_to_slide };

struct Reading {
    Abutments abutments;
    double abutment_length;          // m
    double velocity_kept;            // per step; 0.94 is the paper's 6 %
    bool equilibrium_first = false;  // static self-weight in place of the paper's 0.02 s of gravity
};

struct Answer {
    RunReport report;
    double crown_down = 0, crown_lift = 0;     // m, extremes of the vertical displacement
    double abutment_end = 0, span_change = 0;  // m, horizontal, right abutment; and right minus left
    double compression = 0, tension = 0;       // Pa, at the end over all voussoirs
    double record_compression = 0;             // Pa, over the whole run
    double highest_x = 0;                      // m, distance of the most compressed stone from mid-span
    double central_share = 0;                  // mean compression of the central third / of the outer thirds
};

/// Extreme principal stresses of the voussoirs now, and where.
void read_stresses(const Model& model, const State& state, Answer& answer)
{
    double centre = 0, outside = 0;
    int centre_count = 0, outside_count = 0;
    answer.compression = answer.tension = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        if (model.blocks[b].name.rfind("voussoir", 0) != 0) continue;
        const Vector3d principal =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(stress_of(model, state, b)).eigenvalues();
        const double x = std::abs(model.blocks[b].moments.centroid.x());
        (x < 7.5 ? centre : outside) += -principal[0];
        ++(x < 7.5 ? centre_count : outside_count);
        answer.tension = std::max(answer.tension, principal[2]);
        if (-principal[0] <= answer.compression) continue;
        answer.compression = -principal[0];
        answer.highest_x = x;
    }
    answer.central_share = (centre / centre_count) / (outside / outside_count);
    answer.record_compression = std::max(answer.record_compression, answer.compression);
}

Answer shake(const Reading& reading)
{
    importers::patterns::ArchBridge bridge;
    bridge.rise = 1.5;
    bridge.abutment_length = reading.abutment_length;
    Model model = bridge_model(bridge);
    // "Normal contact stiffness 4.5 GPa" of a planar code: N/m per contact point and metre of width, two points to
    // a joint; here four points carry the whole width.
    model.joints[0].face = FaceLaw::corners;
    model.joints[0].stiffness = {ContactStiffness::Kind::per_point, 4.5e9 * bridge.width / 2};
    const bool free = reading.abutments == Abutments::free_to_slide;
    for (Foundation& foundation : model.foundations) foundation.translation_held[0] = !free;

    Stage gravity_stage = testing::dynamic_stage(0.02, 2e-3), shaking = testing::dynamic_stage(0.4, 2e-3);
    for (Stage* stage : {&gravity_stage, &shaking}) stage->damping.factor_per_step = reading.velocity_kept;
    const auto sine =
        std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(0.5 * testing::gravity, 2.5, 0, 10));
    for (int f = 0; f < 2; ++f) {
        if (free)
            shaking.body_accelerations.push_back({model.foundations[f].block, 0, sine});
        else
            shaking.motions.push_back({f, 0, sine});
    }

    Answer answer;
    State state = initial_state(model);
    const int crown = block_named(model, "voussoir_47");
    const auto moved = [&](const std::string& name) {
        const int b = block_named(model, name);
        return Vector3d(testing::centroid(model, state, b) - model.blocks[b].moments.centroid);
    };
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const double z = testing::centroid(model, now, crown).z() - model.blocks[crown].moments.centroid.z();
        answer.crown_down = std::min(answer.crown_down, z);
        answer.crown_lift = std::max(answer.crown_lift, z);
        read_stresses(model, now, answer);
    };
    const Stage first = reading.equilibrium_first ? testing::static_stage(1) : gravity_stage;
    answer.report = run(model, {first, shaking}, state, observer);
    answer.abutment_end = moved("abutment_right").x();
    answer.span_change = moved("abutment_right").x() - moved("abutment_left").x();
    return answer;
}

}  // namespace

TEST(MoscaPaper, SequenceOfThePaperUnderBothReadingsOfItsAbutments)
{
    std::printf("%-40s %9s %9s %9s %9s %9s %9s %9s %8s %8s\n", "reading", "crown", "crown", "abutment", "span",
                "compr.", "compr.", "tension", "highest", "centre/");
    std::printf("%-40s %9s %9s %9s %9s %9s %9s %9s %8s %8s\n", "", "low mm", "high mm", "end mm", "change mm",
                "end MPa", "run MPa", "end kPa", "at x m", "outside");
    for (const Reading& reading :
         {Reading{Abutments::prescribed, 6, 1}, Reading{Abutments::prescribed, 6, 0.94},
          Reading{Abutments::free_to_slide, 6, 1}, Reading{Abutments::free_to_slide, 6, 0.94},
          Reading{Abutments::free_to_slide, 18, 1}, Reading{Abutments::free_to_slide, 18, 0.94},
          Reading{Abutments::prescribed, 6, 1, true}, Reading{Abutments::prescribed, 6, 0.94, true}}) {
        const Answer a = shake(reading);
        char name[64];
        std::snprintf(name, sizeof name, "%s, %g m, %s%s",
                      reading.abutments == Abutments::prescribed ? "prescribed" : "free", reading.abutment_length,
                      reading.velocity_kept < 1 ? "6 % damping" : "no damping",
                      reading.equilibrium_first ? ", static" : "");
        std::printf("%-40s %9.2f %9.2f %9.1f %9.2f %9.2f %9.2f %9.1f %8.1f %8.2f\n", name, 1e3 * a.crown_down,
                    1e3 * a.crown_lift, 1e3 * a.abutment_end, 1e3 * a.span_change, a.compression / 1e6,
                    a.record_compression / 1e6, a.tension / 1e3, a.highest_x, a.central_share);
        EXPECT_EQ(a.report.outcome, Outcome::completed) << ::testing::PrintToString(a.report.diagnosis);
        EXPECT_LT(a.report.energy.relative_residual(), 1e-3);
        if (reading.abutments == Abutments::prescribed) {
            // The ground's own displacement, from rest: A/w^2 (w t - sin w t) at the end of one period.
            const double w = 2 * std::numbers::pi * 2.5;
            EXPECT_NEAR(a.abutment_end, 0.5 * testing::gravity / (w * w) * (w * 0.4), 1e-9);
            EXPECT_NEAR(a.span_change, 0, 1e-12);
        }
    }
}

}  // namespace voussoir::verification
