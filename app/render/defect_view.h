// From where the marks of a picture are seen best.
#pragma once

#include "app/render/defect_pictures.h"

namespace voussoir::app::render
{

/// Points of a mark, spread over it: its own points, ends and middles of lines, corners and middles of polygons
/// [m].
std::vector<Eigen::Vector3d> samples_of(const importers::mesh::MarkedFeature& feature);

/// Unit direction towards the viewer: of some directions around and slightly above (or below) the one from which
/// the fewest samples of the marks are hidden by the stones, the usual view first.
Eigen::Vector3d best_direction(const std::vector<PictureShape>& shapes, const DefectPicture& picture);

/// What the picture should hold: the stones that are not ghosts, and the marks [m].
std::vector<Eigen::Vector3d> points_to_see(const std::vector<PictureShape>& shapes, const DefectPicture& picture);

}  // namespace voussoir::app::render
