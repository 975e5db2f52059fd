#include "app/results/trust_json.h"

#include <nlohmann/json.hpp>

#include "app/results/error_estimate.h"

namespace voussoir::app::results
{

namespace
{

using Json = nlohmann::ordered_json;

std::string_view name_of(ModesOutcome outcome)
{
    switch (outcome) {
        case ModesOutcome::found:
            return "found";
        case ModesOutcome::nothing_closed:
            return "nothing_closed";
        case ModesOutcome::too_costly:
            return "too_costly";
        case ModesOutcome::failed:
            break;
    }
    return "failed";
}

Json damping(const DampingAt& at)
{
    return {{"frequency_Hz", at.frequency},       {"algorithmic_damping", at.algorithmic},
            {"damping_by_dashpots", at.dashpots}, {"damping_asked_for", at.asked},
            {"period_error", at.period_error},    {"is_judged", at.matters}};
}

Json modes(const NaturalModes& found)
{
    Json list = Json::array();
    for (const NaturalMode& mode : found.modes)
        list.push_back({{"frequency_Hz", mode.frequency},
                        {"mass_fraction", {mode.mass_share.x(), mode.mass_share.y(), mode.mass_share.z()}},
                        {"strain_energy_in_joints", mode.joint_share},
                        {"lowered_by_joints", mode.lowered_by_joints},
                        {"raised_by_stones", mode.raised_by_stones},
                        {"raised_by_corners", mode.raised_by_corners}});
    return list;
}

Json shares(const EnergyShares& shares)
{
    return {{"put_in_J", shares.put_in},      {"integrator", shares.integrator}, {"closing", shares.closing},
            {"redetection", shares.contacts}, {"friction", shares.friction},     {"impact", shares.impact},
            {"damping", shares.damping},      {"dashpots", shares.dashpots},     {"fracture", shares.fracture},
            {"yielding", shares.yielding}};
}

}  // namespace

std::string trust_json(const Trust& trust, const std::vector<Stage>& stages)
{
    Json json;
    json["state"] = trust.start.at_rest ? "at rest, after a static stage" : "at the start";
    json["search"] = name_of(trust.start.modes.outcome);
    json["modes"] = modes(trust.start.modes);
    if (trust.stage >= 0) {
        json["stage"] = stages[trust.stage].name;
        json["damping"] = Json::array();
        for (const DampingAt& at : trust.damping) json["damping"].push_back(damping(at));
        json["energy_fractions"] = shares(trust.shares);
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<std::string> doubts_of(const ErrorEstimate& estimate, Outcome outcome)
{
    std::vector<std::string> doubts;
    for (const RunBeside& beside : estimate.runs) {
        const std::string its = beside.outcome.substr(0, beside.outcome.find(':'));
        if (its == name_of(outcome)) continue;
        doubts.push_back("with " + beside.name + " the run ends otherwise (" + beside.outcome + "; here " +
                         std::string(name_of(outcome)) +
                         "): what becomes of the structure depends on it; find where "
                         "the answer stays, with voussoir converge");
    }
    return doubts;
}

std::string estimate_json(const ErrorEstimate& estimate)
{
    Json json;
    for (const RunBeside& run : estimate.runs) json[run.key] = {{"outcome", run.outcome}};
    Json list = Json::array();
    for (const ComparedQuantity& quantity : estimate.quantities) {
        Json entry = {{"name", quantity.name}, {"unit", quantity.unit}, {"largest", quantity.size}};
        for (std::size_t i = 0; i < estimate.runs.size(); ++i) {
            Json& difference = entry[estimate.runs[i].key];
            difference["difference"] = quantity.differences[i];
            difference["relative"] =
                quantity.size > 0 ? Json(quantity.differences[i] / quantity.size) : Json(nullptr);
        }
        list.push_back(entry);
    }
    json["quantities"] = list;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace voussoir::app::results
