// What users read of how far a run can be trusted, word for word.
#include "app/words/trust_words.h"

#include <gtest/gtest.h>

namespace voussoir::testing
{

namespace
{

using app::words::shares_in_words;
using app::words::vibrations_in_words;
using app::words::warnings_of;
using Kind = TrustFinding::Kind;

Stage motion(Integrator integrator)
{
    Stage stage;
    stage.name = "motion";
    stage.control.time_step = 2e-3;
    stage.control.integrator = integrator;
    return stage;
}

Trust judged()
{
    Trust trust;
    trust.stage = 0;
    trust.of_modes = true;
    trust.start.modes.outcome = ModesOutcome::found;
    for (const double frequency : {4.314, 5.02, 7.7, 12.0, 80.0}) {
        trust.start.modes.modes.push_back({frequency, {0.8, 0, 0}, 0.1, 0.0016, 0, 0});
        trust.damping.push_back({frequency, 1e-5 * frequency, 0, 0, 0, frequency < 33});
    }
    return trust;
}

TEST(TrustWords, AreOneLineWhenAllIsWell)
{
    EXPECT_EQ(vibrations_in_words(judged()),
              "first modes 4.31, 5.02, 7.7, 12, ... Hz; the integrator damps them by at most 0.012 % of critical; "
              "joints lower them by at most 0.16 %");
    EXPECT_TRUE(warnings_of(judged(), {motion(Integrator::newmark)}).empty());
    Trust loose;
    loose.stage = 0;
    loose.damping = {{10, 0.0006, 0, 0, 0, true}};
    EXPECT_EQ(
        vibrations_in_words(loose),
        "no joint is closed, so there are no natural modes; the integrator damps 10 Hz by 0.06 % of critical");
    loose.steps_follow = true;  // that of the longest step
    EXPECT_EQ(vibrations_in_words(loose),
              "no joint is closed, so there are no natural modes; the integrator damps 10 Hz by at most 0.06 % of "
              "critical");
    EXPECT_EQ(vibrations_in_words({}), "no joint is closed, so there are no natural modes");
}

TEST(TrustWords, SayWhereTheEnergyWent)
{
    EnergyShares shares;
    EXPECT_EQ(shares_in_words(shares), "");
    shares.put_in = 563.2e3;
    shares.friction = 0.4;
    EXPECT_EQ(shares_in_words(shares), "of 563.2 kJ put in by the motion: integrator < 0.01 %, friction 40 %");
}

TEST(TrustWords, NameTheLimitAndTheRemedy)
{
    Trust trust = judged();
    const auto said = [&](const TrustFinding& finding, Integrator integrator = Integrator::energy_decaying) {
        trust.findings = {finding};
        return warnings_of(trust, {motion(integrator)}).at(0);
    };
    const TrustFinding damped{Kind::algorithmic_damping, 4.314, 0.0271, 0.002, 37.5};
    EXPECT_EQ(said(damped, Integrator::newmark),
              "the integrator damps the vibration of 4.31 Hz by 2.7 % of critical (limit 0.2 %): give integrator: "
              "energy_decaying, or time_step: 0.05 ms");
    EXPECT_EQ(said(damped),
              "the integrator damps the vibration of 4.31 Hz by 2.7 % of critical (limit 0.2 %): give time_step: "
              "0.05 ms");
    EXPECT_EQ(
        said({Kind::dashpots, 4.314, 0.0271, 0.002, 37.5}),
        "the dashpots of joints (relaxation_time) damp the vibration of 4.31 Hz by 2.7 % of critical (limit 0.2 "
        "%): give a relaxation_time 0.02 times as long");
    EXPECT_EQ(said({Kind::period, 30, 0.0135, 0.01, 1.35}),
              "the computed period of the vibration of 30 Hz is 1.4 % too long (limit 1 %): give time_step: 1 ms");
    EXPECT_EQ(said({Kind::soft_joints, 4.314, 0.0465, 0.01, 4.65}),
              "joints lower the frequency of 4.31 Hz by 4.7 % against that of the stones (limit 1 %): their "
              "stiffness is a rule, no measurement; give the measured contact_stiffness in Pa/m, or a "
              "contact_stiffness_factor 5 times as large");
    // Of rigid stones half as stiff as they should be.
    trust.start.modes.rigid = true;
    EXPECT_EQ(said({Kind::soft_joints, 4.314, 0.293, 0.02, 14.65}),
              "joints lower the frequency of 4.31 Hz by 29 % against that of the stones (limit 2 %): their "
              "stiffness is a rule, no measurement; give the measured contact_stiffness in Pa/m, or a "
              "contact_stiffness_factor 2 times as large");
    trust.start.modes.rigid = false;
    EXPECT_EQ(said({Kind::stiff_stones, 10.6, 2.4, 0.5, 4.8}),
              "on face: corners stones do not bend: if these did, the vibration of 10.6 Hz would have some 3.1 "
              "Hz; give the joints face: points, or take no frequency from this run");
    EXPECT_EQ(said({Kind::integrator_energy, 0, 0.64, 0.05, 12.8}),
              "the integrator took 64 % of the energy put in (limit 5 %): what vibrates loses too much; give "
              "time_step: 0.1 ms");
    EXPECT_EQ(said({Kind::integrator_energy, 0, 0.64, 0.05, 12.8}, Integrator::newmark),
              "the integrator took 64 % of the energy put in (limit 5 %): what vibrates loses too much; give "
              "integrator: energy_decaying");
    EXPECT_EQ(
        said({Kind::closing_energy, 0, 0.1, 0.05, 2}),
        "joints that closed or opened within a step took 10 % of the energy put in (limit 5 %): what impacts "
        "loses too much; give time_step: 1 ms");
    trust.of_modes = false;
    EXPECT_EQ(
        said({Kind::algorithmic_damping, 10, 0.031, 0.012, 2.6}),
        "the integrator damps vibrations of 10 Hz by 3.1 % of critical (limit 1.2 %): give time_step: 0.7 ms");
}

TEST(TrustWords, WhereStepsFollowTheirErrorTheRemedyIsASmallerOne)
{
    Trust trust = judged();
    trust.findings = {{Kind::closing_energy, 0, 0.1, 0.05, 2}};
    Stage stage = motion(Integrator::energy_decaying);
    stage.control.step_error = 1e-4;  // m; it is of third order: half the steps have an eighth of it
    EXPECT_EQ(
        warnings_of(trust, {stage}).at(0),
        "joints that closed or opened within a step took 10 % of the energy put in (limit 5 %): what impacts "
        "loses too much; give step_error: 0.01 mm");
}

}  // namespace

}  // namespace voussoir::testing
