#include "app/results/verdict_json.h"

#include <nlohmann/json.hpp>
#include <numbers>

#include "app/words/verdict_words.h"

namespace voussoir::app::results
{

namespace
{

using Json = nlohmann::ordered_json;

Json name(const Model& model, int block)
{
    return block < 0 ? Json(nullptr) : Json(model.blocks[block].name);
}

Json worst_joint(const Dislocation& worst, const Model& model)
{
    if (worst.block_a < 0) return nullptr;
    return {{"blocks", {name(model, worst.block_a), name(model, worst.block_b)}},
            {"opening_m", worst.opening},
            {"slip_m", worst.slip},
            {"fraction_of_stone", worst.share}};
}

}  // namespace

std::string verdict_json(const Verdict& verdict, const Model& model)
{
    Json json;
    json["standing"] = name_of(verdict.standing);
    json["damage"] = name_of(verdict.damage);
    json["in_words"] = words::in_words(verdict, model);
    Json lost = Json::array();
    for (const int block : verdict.lost) lost.push_back(name(model, block));
    json["lost_stones"] = std::move(lost);
    json["lost_mass_fraction"] = verdict.lost_share;
    json["fastest"] = verdict.fastest < 0 ? Json(nullptr)
                                          : Json{{"block", name(model, verdict.fastest)},
                                                 {"speed_m_s", verdict.speed},
                                                 {"go_on_s", verdict.go_on}};
    json["worst_joint"] = worst_joint(verdict.worst, model);
    json["thresholds"] = {{"limited_deformation", limited_deformation},
                          {"light_damage", light_damage},
                          {"significant_damage", significant_damage},
                          {"overturned_deg", overturning_tilt * 180 / std::numbers::pi},
                          {"at_rest_sqrt_g_size", slow_end}};
    Json displacements = Json::array(), turns = Json::array();
    for (const BlockEnd& block : verdict.blocks) {
        displacements.push_back(block.displacement);
        turns.push_back(block.turn * 180 / std::numbers::pi);
    }
    json["block_displacement_m"] = std::move(displacements);
    json["block_turn_deg"] = std::move(turns);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace voussoir::app::results
