// What the built program says of its own runs: natural modes, damping of the integrator, error bars.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::commands
{
namespace
{

class TrustProgram : public CommandTest
{
 protected:
    nlohmann::json summary() const { return nlohmann::json::parse(contents("out/summary.json")); }
    bool says(const std::string& text) const { return output_.find(text) != std::string::npos; }
};

/// A layer of 8 m on rigid ground, shear waves of 150 m/s: 4.69 Hz. Joints f E / L stiff.
std::string layer(double f, const std::string& integrator)
{
    const double young = 2.4 * 1800 * 150 * 150;
    // As a stiffness per contact point: two of them on 100 m of width, a metre thick.
    const double per_point = f * young * 100 / 2;
    std::ostringstream text;
    text << "kinematics: planar_deformable\nthickness: 1 m\nmaterials:\n  soil: {density: 1800 kg/m3, young: "
         << young
         << " Pa, poisson: 0.2}\njoints:\n  bonded: {friction: 40 deg, cohesion: 1 GPa, tensile_strength: 1 GPa, "
            "contact_stiffness: "
         << per_point
         << " N/m}\nblocks:\n  - {box: {name: base, lower: [-51, -1], upper: [51, 0]}, group: foundation}\n";
    for (int i = 0; i < 8; ++i)
        text << "  - {box: {name: soil" << i << ", lower: [-50, " << i << "], upper: [50, " << i + 1 << "]}}\n";
    text << "foundation: {blocks: foundation, motion: {x: {ricker: {acceleration: 1 m/s2, frequency: 3 "
            "Hz}}}}\nstages:\n"
            "  - {name: rest, type: static}\n  - {name: shaking, type: dynamic, duration: 1 s, time_step: 2 ms, "
         << integrator
         << ", damping: {rate: 2.9 1/s}}\noutput: {every: 0.1 s, histories: {top: {block: soil7}}}\n";
    return text.str();
}

TEST_F(TrustProgram, KnowsTheFrequencyOfALayerAndHasNothingToWarnOf)
{
    folder_.write("case.yaml", layer(300, "integrator: energy_decaying, dissipation: 0.02"));
    ASSERT_EQ(voussoir("run case.yaml -o out"), 0) << output_;
    const nlohmann::json trust = summary().at("trust");
    EXPECT_EQ(trust.at("search"), "found");
    EXPECT_EQ(trust.at("stage"), "shaking");
    const nlohmann::json& first = trust.at("modes")[0];
    EXPECT_NEAR(first.at("frequency_Hz").get<double>(), 150.0 / 32, 0.01 * 150 / 32);
    EXPECT_NEAR(first.at("mass_fraction")[0].get<double>(), 8 / (std::numbers::pi * std::numbers::pi), 0.01);
    EXPECT_LT(first.at("lowered_by_joints").get<double>(), 0.002);
    const nlohmann::json& damping = trust.at("damping")[0];
    const double omega = 2 * std::numbers::pi * first.at("frequency_Hz").get<double>();
    EXPECT_NEAR(damping.at("damping_asked_for").get<double>(), 2.9 / 2 / omega, 1e-6);
    EXPECT_NEAR(damping.at("algorithmic_damping").get<double>(), 0.02 * omega * 2e-3 / 4, 1e-5);
    EXPECT_LT(trust.at("energy_fractions").at("integrator").get<double>(), 0.01);
    EXPECT_GT(trust.at("energy_fractions").at("damping").get<double>(), 0.2);
    EXPECT_TRUE(summary().at("warnings").empty()) << summary().at("warnings");
    EXPECT_TRUE(says("first modes 4.6")) << output_;
    EXPECT_FALSE(says("warning: ")) << output_;

    ASSERT_EQ(voussoir("check case.yaml"), 0) << output_;
    EXPECT_TRUE(says("as drawn, all joints closed: first modes 4.6")) << output_;
    EXPECT_FALSE(says("warning: ")) << output_;
}

TEST_F(TrustProgram, WarnsOfSoftJointsAndOfAnIntegratorThatDamps)
{
    folder_.write("case.yaml", layer(10, "integrator: newmark"));
    ASSERT_EQ(voussoir("run case.yaml -o out"), 0) << output_;
    for (const char* part :
         {"warning: the integrator damps the vibration of 4.4", "give integrator: energy_decaying",
          "warning: joints lower the frequency of 4.4", "warning: the integrator took"})
        EXPECT_TRUE(says(part)) << part << " is not in\n" << output_;
    EXPECT_EQ(summary().at("warnings").size(), 3) << summary().at("warnings");
    ASSERT_EQ(voussoir("check case.yaml"), 0) << output_;
    EXPECT_TRUE(says("warning: the integrator damps the vibration of 4.4")) << output_;
    EXPECT_TRUE(says("warning: joints lower the frequency of 4.4")) << output_;

    ASSERT_EQ(voussoir("run case.yaml -o out --set output.trust=never"), 0) << output_;
    EXPECT_FALSE(summary().contains("trust"));
    EXPECT_TRUE(summary().at("warnings").empty()) << summary().at("warnings");
    EXPECT_FALSE(says("first modes")) << output_;
}

/// A rigid block that rocks, and does not come down within the run. Joints f E / L stiff.
std::string rocking(double f, const std::string& integrator)
{
    // As a stiffness per contact point: two of them on 0.2 m; the ground adds no compliance.
    const double per_point = 2 * f * 10e9 / 0.6 * 0.2 / 2;
    std::ostringstream text;
    text << "kinematics: planar_rigid\nthickness: 1 m\nmaterials:\n  stone: {density: 2500 kg/m3, young: 10 GPa, "
            "poisson: "
            "0.2}\njoints:\n  dry: {friction: 45 deg, contact_stiffness: "
         << per_point
         << " N/m}\nblocks:\n  - {box: {name: base, lower: [-1, -0.2], upper: [1, 0]}, group: foundation}\n"
            "  - {box: {name: block, lower: [-0.1, 0], upper: [0.1, 0.6]}}\nfoundation: {blocks: foundation, "
            "motion: {x: "
            "{pulse: {acceleration: 5.4 m/s2, period: 1 s}}}}\nstages:\n  - {name: rest, type: static}\n  - "
            "{name: motion, "
            "type: dynamic, duration: 0.45 s, time_step: 2 ms, "
         << integrator << "}\noutput: {every: 0.1 s}\n";
    return text.str();
}

TEST_F(TrustProgram, WarnsOfARockingBlockWithTheOldSettingsOnly)
{
    // Joints half as stiff as the stone that they stand for.
    folder_.write("case.yaml", rocking(0.5, "integrator: newmark"));
    ASSERT_EQ(voussoir("run case.yaml -o out"), 0) << output_;
    EXPECT_TRUE(says("warning: the integrator damps vibrations of 10 Hz by 3.1 % of critical")) << output_;
    EXPECT_TRUE(says("warning: joints lower the frequency")) << output_;
    folder_.write("case.yaml", rocking(300, "integrator: energy_decaying, dissipation: 0.02"));
    ASSERT_EQ(voussoir("run case.yaml -o out"), 0) << output_;
    EXPECT_TRUE(summary().at("warnings").empty()) << summary().at("warnings");
}

/// A rigid block on measured springs of 5 Hz that its weight sets moving: a period, and the springs stay closed.
std::string bouncing()
{
    const double stiffness = 2000 * 0.5 * std::pow(2 * std::numbers::pi * 5, 2);
    std::ostringstream text;
    text << "kinematics: planar_rigid\nthickness: 1 m\nmaterials:\n  stone: {density: 2000 kg/m3, young: 1 GPa, "
            "poisson: "
            "0.2}\njoints:\n  springs: {friction: 40 deg, contact_stiffness: "
         << stiffness
         << " Pa/m}\nblocks:\n  - {box: {name: base, lower: [-1, -1], upper: [1, 0]}, group: foundation}\n"
            "  - {box: {name: block, lower: [-0.5, 0], upper: [0.5, 0.5]}}\nfoundation: {blocks: foundation}\n"
            "gravity: {magnitude: 1 m/s2}\nstages:\n  - {name: motion, type: dynamic, duration: 0.2 s, time_step: "
            "1 ms, "
            "integrator: newmark}\noutput: {every: 0.1 s, error_estimate: true, histories: {top: {block: "
            "block}}}\n";
    return text.str();
}

TEST_F(TrustProgram, EstimatesItsErrorByHalfTheStep)
{
    folder_.write("case.yaml", bouncing());
    ASSERT_EQ(voussoir("run case.yaml -o out"), 0) << output_;
    EXPECT_TRUE(says("error estimate: half the time step")) << output_;
    const nlohmann::json estimate = summary().at("error_estimate");
    EXPECT_EQ(estimate.at("half_step").at("outcome"), "completed");
    EXPECT_FALSE(estimate.contains("twice_stiffness")) << "a measured stiffness is no error";

    // z = -g (1 - cos(omega t)) / omega^2, and newmark is of first order.
    std::istringstream lines(contents("out/histories.csv"));
    std::string line;
    std::getline(lines, line);
    const double omega = 2 * std::numbers::pi * 5;
    double error = 0, size = 0;
    while (std::getline(lines, line)) {
        double t = 0, x = 0, z = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &t, &x, &z), 3);
        error = std::max(error, std::abs(z + (1 - std::cos(omega * t)) / (omega * omega)));
        size = std::max(size, std::abs(z));
    }
    for (const nlohmann::json& quantity : estimate.at("quantities")) {
        if (quantity.at("name") != "top uz") continue;
        EXPECT_EQ(quantity.at("unit"), "m");
        EXPECT_NEAR(quantity.at("largest").get<double>(), size, 1e-12);
        EXPECT_NEAR(quantity.at("half_step").at("difference").get<double>() / error, 0.5, 0.05);
        EXPECT_NEAR(quantity.at("half_step").at("relative").get<double>(),
                    quantity.at("half_step").at("difference").get<double>() / size, 1e-12);
        return;
    }
    FAIL() << "no estimate of the history";
}

// Nothing but the step is halved: the run beside is the one that a user gets who halves it, dissipation and all.
TEST_F(TrustProgram, HalvesTheStepAndNothingElse)
{
    folder_.write("case.yaml", with(bouncing(), "time_step: 1 ms, integrator: newmark",
                                    "time_step: 10 ms, integrator: energy_decaying"));
    ASSERT_EQ(voussoir("run case.yaml -o out"), 0) << output_;
    const nlohmann::json quantities = summary().at("error_estimate").at("quantities");
    const auto heights = [&](const std::string& file) {
        std::istringstream lines(contents(file));
        std::string line;
        std::getline(lines, line);
        std::map<long, double> at;  // by 0.1 ms
        double t = 0, x = 0, z = 0;
        while (std::getline(lines, line) && std::sscanf(line.c_str(), "%lf,%lf,%lf", &t, &x, &z) == 3)
            at[std::lround(t * 1e4)] = z;
        return at;
    };
    ASSERT_EQ(
        voussoir("run case.yaml -o half --set \"stages[0].time_step=5 ms\" --set output.error_estimate=false"), 0)
        << output_;
    const std::map<long, double> coarse = heights("out/histories.csv"), fine = heights("half/histories.csv");
    double difference = 0;
    for (const auto& [time, height] : coarse) difference = std::max(difference, std::abs(fine.at(time) - height));
    ASSERT_GT(difference, 0);
    for (const nlohmann::json& quantity : quantities)
        if (quantity.at("name") == "top uz") {
            EXPECT_NEAR(quantity.at("half_step").at("difference").get<double>() / difference, 1, 1e-6);
        }
}

TEST_F(TrustProgram, EstimatesTheInfluenceOfARuledStiffness)
{
    // The rule's own stiffness, with the block's weight on it: half the settlement with twice the stiffness.
    std::string text =
        with(with(bouncing(), "contact_stiffness: ", "shear_to_normal_stiffness: 0.5}  # "),
             "type: dynamic, duration: 0.2 s, time_step: 1 ms, integrator: newmark", "type: static");
    folder_.write("case.yaml", text);
    ASSERT_EQ(voussoir("run case.yaml -o out"), 0) << output_;
    const nlohmann::json estimate = summary().at("error_estimate");
    EXPECT_FALSE(estimate.contains("half_step")) << "nothing is dynamic";
    EXPECT_EQ(estimate.at("twice_stiffness").at("outcome"), "completed");
    for (const nlohmann::json& quantity : estimate.at("quantities"))
        if (quantity.at("name") == "largest displacement at the end") {
            EXPECT_NEAR(quantity.at("twice_stiffness").at("relative").get<double>(), 0.5, 1e-6);
        }
}

TEST_F(TrustProgram, RefusesWhatItDoesNotKnow)
{
    folder_.write("case.yaml", with(two_boxes, "{every: 20 ms,", "{every: 20 ms, trust: sometimes,"));
    EXPECT_EQ(voussoir("check case.yaml"), 2);
    EXPECT_TRUE(says("output.trust: \"sometimes\"") && says("automatic")) << output_;
    folder_.write("case.yaml", with(two_boxes, "{every: 20 ms,", "{every: 20 ms, error_estimate: 2,"));
    EXPECT_EQ(voussoir("check case.yaml"), 2);
    EXPECT_TRUE(says("output.error_estimate")) << output_;
}

}  // namespace
}  // namespace voussoir::app::commands
