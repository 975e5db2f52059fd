#include "app/report/energy_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/report/sections.h"
#include "app/words/trust_words.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

/// A term of the balance, what it is called, and the curve of the diagram that it is a part of.
struct Term {
    const char* key;
    const char* part;
    const char* words;
    const char* curve;
};

constexpr const char* at_start = "at the start";
constexpr const char* put_in = "put in";
constexpr const char* lost = "lost";
constexpr const char* at_end = "at the end";
constexpr const char* no_term = "no term has it";
constexpr const char* damped = "damping, fracture, yielding";
constexpr const char* computed = "integrator, closing joints, contacts found anew";
constexpr const char* stored = "strain, springs of joints";
constexpr double negligible = 1e-9;  // of the whole

constexpr Term terms[] = {
    {"start_kinetic_J", at_start, "kinetic energy", put_in},
    {"start_strain_J", at_start, "strain of stones", put_in},
    {"start_contact_J", at_start, "springs of joints", put_in},
    {"foundation_work_J", put_in, "motion of the ground", put_in},
    {"boundary_work_J", put_in, "viscous boundaries", put_in},
    {"gravity_work_J", put_in, "gravity", put_in},
    {"load_work_J", put_in, "body accelerations", put_in},
    {"friction_J", lost, "friction", "friction"},
    {"impact_J", lost, "impacts of stones that landed", "impacts"},
    {"damping_material_J", lost, "damping of materials", damped},
    {"damping_kinetic_J", lost, "damping of velocities", damped},
    {"damping_contact_J", lost, "dashpots of joints", damped},
    {"fracture_J", lost, "bonds that broke", damped},
    {"yielding_J", lost, "bars that yielded", damped},
    {"damping_static_J", lost, "on the way to rest in static stages", damped},
    {"closing_J", lost, "joints that closed or opened within a step", computed},
    {"algorithmic_J", lost, "integrator", computed},
    {"algorithmic_rotation_J", lost, "integrator: turns and stretches of stones", computed},
    {"redetection_J", lost, "contacts that were found anew", computed},
    {"kinetic_J", at_end, "kinetic energy", "kinetic"},
    {"strain_J", at_end, "strain of stones", stored},
    {"contact_J", at_end, "springs of joints", stored},
    {"residual_J", no_term, "residual", nullptr},
};

double sum_of(const Json& energy, const char* part)
{
    double sum = 0;
    for (const Term& term : terms)
        if (std::string_view(term.part) == part) sum += energy.value(term.key, 0.0);
    return sum;
}

/// What the balance is judged by [J].
double scale_of(const Json& energy)
{
    return std::max({std::abs(sum_of(energy, put_in)), sum_of(energy, lost), sum_of(energy, at_start),
                     energy.value("peak_stored_J", 0.0)});
}

}  // namespace

std::vector<EnergyCurve> energy_curves()
{
    std::vector<EnergyCurve> curves;
    for (const Term& term : terms) {
        if (term.curve == nullptr) continue;
        const auto known = std::find_if(curves.begin(), curves.end(),
                                        [&](const EnergyCurve& curve) { return curve.words == term.curve; });
        EnergyCurve& curve = known != curves.end() ? *known : curves.emplace_back(EnergyCurve{term.curve, {}});
        curve.terms.emplace_back(term.key);
    }
    return curves;
}

Table energy_table(const std::string& summary)
{
    const Json all = Json::parse(summary);
    Table table{"energy", "Energy balance", {"part", "term", "energy [kJ]", "share [%]"}, {}};
    if (!all.contains("energy")) return table;
    const Json& energy = all.at("energy");
    const double scale = scale_of(energy);
    table.title +=
        "; shares of " + figure(scale / 1e3) +
        " kJ, the largest of what was put in, was lost and was stored at once; terms below a billionth of it "
        "are left out";
    for (const auto& [key, part, words, curve] : terms) {
        if (!energy.contains(key) || !energy.at(key).is_number()) continue;
        const double value = energy.at(key).get<double>();
        if (std::abs(value) <= negligible * scale && part != no_term) continue;
        table.rows.push_back({part, words, figure(value / 1e3), scale > 0 ? figure(100 * value / scale) : "none"});
    }
    return table;
}

std::string energy_in_words(const std::string& summary)
{
    const Json all = Json::parse(summary);
    if (!all.contains("trust") || !all.at("trust").contains("energy_fractions")) return "";
    const Json& fractions = all.at("trust").at("energy_fractions");
    const auto of = [&](const char* key) { return fractions.value(key, 0.0); };
    EnergyShares shares;
    shares.put_in = of("put_in_J");
    shares.integrator = of("integrator");
    shares.closing = of("closing");
    shares.contacts = of("redetection");
    shares.friction = of("friction");
    shares.impact = of("impact");
    shares.damping = of("damping");
    shares.dashpots = of("dashpots");
    shares.fracture = of("fracture");
    shares.yielding = of("yielding");
    std::string words = words::shares_in_words(shares);
    if (words.empty()) return words;
    words.front() = 'O';
    return words +
           "; the rest is stored or was given back. What the integrator takes is no damping of the structure.";
}

}  // namespace voussoir::app::report
