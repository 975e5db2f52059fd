#include <nlohmann/json.hpp>

#include "app/studies/limit/study.h"
#include "app/version/version.h"

namespace voussoir::app::studies::limit
{

namespace
{

using Json = nlohmann::ordered_json;
using voussoir::limit::UnderLoad;

std::string outcome_name(UnderLoad outcome)
{
    switch (outcome) {
        case UnderLoad::limited:
            return "limited";
        case UnderLoad::falls_before:
            return "falls_under_its_weight";
        case UnderLoad::bears_all:
            return "bears_all";
        case UnderLoad::unknown:
            break;
    }
    return "unknown";
}

Json to_json(const Eigen::Vector3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

}  // namespace

std::string limit_json(const LimitStudy& study)
{
    const auto name = [&](int block) { return study.block_names[static_cast<std::size_t>(block)]; };
    Json stones = Json::array(), joints = Json::array();
    for (const MovingStone& stone : study.stones)
        stones.push_back({{"stone", name(stone.block)},
                          {"velocity", to_json(stone.velocity)},
                          {"spin_per_m", to_json(stone.spin)}});
    for (const MovingJoint& joint : study.joints)
        joints.push_back({{"between", {name(joint.block_a), name(joint.block_b)}},
                          {"motion", joint.slides ? "slides" : "opens"}});
    const bool limited = study.associated.outcome == UnderLoad::limited;
    const Json json{{"case", study.case_name},
                    {"engine", version::in_words(version::engine_version())},
                    {"towards", to_json(study.towards)},
                    {"stones", study.block_names.size()},
                    {"contact_points", study.contact_points},
                    {"bonded_points", study.bonded_points},
                    {"bars", study.bars},
                    {"left_out", study.left_out},
                    {"outcome", outcome_name(study.associated.outcome)},
                    {"associated_g", limited ? Json(study.associated.factor) : Json(nullptr)},
                    {"sliding_stands_at_g", study.sliding ? Json(study.sliding->stands_at) : Json(nullptr)},
                    {"sliding_slides_at_g", study.sliding ? Json(study.sliding->slides_at) : Json(nullptr)},
                    {"tilt_deg", study.tilt > 0 ? Json(study.tilt) : Json(nullptr)},
                    {"mechanism", {{"stones", stones}, {"joints", joints}}},
                    {"in_words", in_words(study)}};
    return json.dump(2) + "\n";
}

}  // namespace voussoir::app::studies::limit
