// What console, summary and report have to say before any figure is used.
#include "app/words/doubts.h"

#include <gtest/gtest.h>

namespace voussoir::testing
{
namespace
{

TEST(Doubts, AreTheWarningsOfTheRunAndThenThoseOfItsTrust)
{
    const Model model = make_model(Kinematics::spatial_rigid, {"stone", 2000, 1e10, 0.2}, {});
    Stage stage;
    stage.name = "motion";
    stage.type = StageType::dynamic;
    stage.control.time_step = 4e-3;
    stage.control.force_tolerance = 1e-5;
    RunReport report;
    EXPECT_TRUE(app::words::doubts_of(report, std::nullopt, model, {stage}).empty());
    report.warnings = {{DiagnosisKind::energy_unaccounted, -1, {}, {0.02}}};
    Trust trust;
    trust.stage = 0;
    trust.findings = {{TrustFinding::Kind::integrator_energy, 0, 0.18, 0.05, 3.6}};
    const std::vector<std::string> doubts = app::words::doubts_of(report, trust, model, {stage});
    ASSERT_EQ(doubts.size(), 2U);
    EXPECT_EQ(doubts[0],
              "2 % of the energy is unaccounted for (limit 1 %): do not trust this run; try time_step: 2 ms, or "
              "force_tolerance: 1e-06");
    EXPECT_EQ(doubts[1],
              "the integrator took 18 % of the energy put in (limit 5 %): what vibrates loses too much; give "
              "time_step: 1 ms");
}

}  // namespace
}  // namespace voussoir::testing
