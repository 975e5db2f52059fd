// A camera that finds its own place.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voussoir::app::render
{

/// The part of the picture that is to be filled, from -1 (left, bottom) to 1 (right, top).
struct PictureArea {
    double left = -1, right = 1, bottom = -1, top = 1;
};

struct Camera {
    Eigen::Matrix4d view_projection;  // model coordinates [m] to clip coordinates
    Eigen::Vector3d right, up, back;  // the camera's axes, unit
};

enum class View {
    from_aside,   // the longest horizontal extent across the picture, from aside and slightly above
    straight_on,  // along y, as an elevation is drawn: x to the right, z up
};

/// Looks at the points with a perspective of 16 degrees and stands so that they just fill `area`.
/// @param points (n >= 1) [m]; @param aspect width / height of the whole picture
Camera camera_for(const std::vector<Eigen::Vector3d>& points, const PictureArea& area, double aspect, View view);

/// The same from a direction of one's own. @param back unit, towards the viewer; not vertical
Camera camera_from(const std::vector<Eigen::Vector3d>& points, const PictureArea& area, double aspect,
                   const Eigen::Vector3d& back);

/// The same without perspective: parallel edges stay parallel, and lengths across the view can be measured.
Camera parallel_camera(const std::vector<Eigen::Vector3d>& points, const PictureArea& area, double aspect,
                       const Eigen::Vector3d& back);

}  // namespace voussoir::app::render
