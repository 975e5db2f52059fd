// Where a run's energy went, as the report's table has it: terms in order, shares of one whole, sums that close.
#include "app/report/energy_table.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/results/energy_terms.h"

namespace voussoir::app::report
{
namespace
{

/// 40 kJ were there, 100 kJ came from the ground, 20 kJ went into lifting; 60 kJ were lost and 60 kJ are stored.
EnergyLedger shaken()
{
    EnergyLedger energy;
    energy.start_kinetic = 40e3;
    energy.foundation_work = 100e3;
    energy.gravity_work = -20e3;
    energy.friction = 45e3;
    energy.impact = 9e3;
    energy.algorithmic = 6e3;
    energy.kinetic = 50e3;
    energy.contact = 10e3;
    energy.start_contact = 1e-20;
    energy.peak_stored = 75e3;
    return energy;
}

std::string summary_of(const EnergyLedger& energy)
{
    nlohmann::json terms;
    for (const auto& [name, value] : results::energy_terms(energy)) terms[name] = value;
    return nlohmann::json{{"energy", terms}}.dump();
}

TEST(EnergyTable, HasTheTermsInTheirOrderAndNoneThatIsNothing)
{
    const Table table = energy_table(summary_of(shaken()));
    const std::vector<std::vector<std::string>> rows = {
        {"at the start", "kinetic energy", "40", "50"},
        {"put in", "motion of the ground", "100", "125"},
        {"put in", "gravity", "-20", "-25"},
        {"lost", "friction", "45", "56.25"},
        {"lost", "impacts of stones that landed", "9", "11.25"},
        {"lost", "integrator", "6", "7.5"},
        {"at the end", "kinetic energy", "50", "62.5"},
        {"at the end", "springs of joints", "10", "12.5"},
        {"no term has it", "residual", "0", "0"},
    };
    EXPECT_EQ(table.rows, rows);
    EXPECT_NE(table.title.find("shares of 80 kJ"), std::string::npos) << table.title;
}

TEST(EnergyTable, KnowsEveryTermOfTheLedger)
{
    nlohmann::json terms;
    std::size_t count = 0;
    for (const auto& [name, value] : results::energy_terms(EnergyLedger())) {
        terms[name] = 1e3;
        count += name.rfind("peak", 0) != 0;  // peaks are no part of the balance
    }
    EXPECT_EQ(energy_table(nlohmann::json{{"energy", terms}}.dump()).rows.size(), count);
}

TEST(EnergyTable, SharesAreOfWhatTheBalanceIsJudgedBy)
{
    for (const double peak : {10e3, 75e3, 300e3}) {
        EnergyLedger energy = shaken();
        energy.peak_stored = peak;
        const Table table = energy_table(summary_of(energy));
        EXPECT_NEAR(std::stod(table.rows[3][3]), 100 * energy.friction / energy.scale(), 0.005) << peak;
    }
}

// What was put in is what became of it, also in the diagram.
TEST(EnergyTable, CurvesAddUp)
{
    const EnergyLedger energy = shaken();
    std::map<std::string, double> terms;
    for (const auto& [name, value] : results::energy_terms(energy)) terms[name] = value;
    std::vector<double> sums;
    for (const EnergyCurve& curve : energy_curves()) {
        sums.push_back(0);
        for (const std::string& term : curve.terms) sums.back() += terms.at(term);
    }
    EXPECT_EQ(energy_curves().front().words, "put in");
    EXPECT_NEAR(sums.front(), 120e3, 1);
    EXPECT_NEAR(std::accumulate(sums.begin() + 1, sums.end(), 0.0), sums.front(), 1);
    std::size_t count = 0;
    for (const EnergyCurve& curve : energy_curves()) count += curve.terms.size();
    for (const auto& [name, value] : terms) count -= name.rfind("peak", 0) != 0 && name != "residual_J";
    EXPECT_EQ(count, 0U) << "every term is in a curve";
}

TEST(EnergyInWords, NamesTheSharesAndWhatIsLeft)
{
    const std::string words = energy_in_words(
        R"({"trust": {"energy_fractions": {"put_in_J": 153000, "integrator": 0.2, "redetection": 0, "friction": 0.08,
        "impact": 0.65, "damping": 0, "dashpots": 0, "fracture": 0}}})");
    EXPECT_EQ(
        words.rfind("Of 153 kJ put in by the motion: integrator 20 %, friction 8 %, impacts 65 %; the rest", 0),
        0U)
        << words;
    EXPECT_EQ(energy_in_words("{}"), "");
}

}  // namespace
}  // namespace voussoir::app::report
