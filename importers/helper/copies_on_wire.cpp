#include "importers/helper/copies_on_wire.h"

#include <array>
#include <nlohmann/json.hpp>

namespace voussoir::importers::helper
{

using nlohmann::json;

std::string copies_to_json(const std::vector<PlacedCopy>& copies)
{
    json value = json::array();
    for (const PlacedCopy& copy : copies) {
        std::array<double, 9> linear{};
        Eigen::Map<Eigen::Matrix3d>(linear.data()) = copy.linear;
        const std::array<double, 3> offset{copy.offset.x(), copy.offset.y(), copy.offset.z()};
        value.push_back({{"linear", linear}, {"offset", offset}, {"suffix", copy.suffix}});
    }
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::vector<PlacedCopy> copies_from_json(const std::string& text)
{
    std::vector<PlacedCopy> copies;
    for (const json& entry : json::parse(text)) {
        const auto linear = entry.at("linear").get<std::array<double, 9>>();
        const auto offset = entry.at("offset").get<std::array<double, 3>>();
        copies.push_back({Eigen::Map<const Eigen::Matrix3d>(linear.data()),
                          Eigen::Map<const Eigen::Vector3d>(offset.data()), entry.at("suffix")});
    }
    return copies;
}

}  // namespace voussoir::importers::helper
