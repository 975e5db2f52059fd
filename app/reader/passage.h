// How a motion runs along the ground: `passes`.
#pragma once

#include <vector>

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// A wave that passes: where it comes later, and by how much.
struct Passage {
    Eigen::Vector3d slowness = Eigen::Vector3d::Zero();  // s/m, how much later it comes along each axis
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  // m, model coordinates: where it comes when its motion says
    /// How much later it comes to a place [m, model coordinates] [s].
    double delay_at(const Eigen::Vector3d& place) const { return slowness.dot(place - from); }
};

/// Reads `{speed: 2000 m/s, direction: [1, 0, 0], from: [0, 0, 0]}`. Without `from` it comes first where it first
/// meets the model; a place that it would reach before its motion begins is a fault.
/// @param places that it comes to [m, model coordinates]
Passage read_passage(YamlCursor& map, const Model& model, const std::vector<Eigen::Vector3d>& places);

}  // namespace voussoir::app::reader
