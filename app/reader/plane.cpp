#include "app/reader/plane.h"

#include <fmt/core.h>

#include <cmath>

#include "libdda/geometry/plane.h"
#include "libdda/geometry/unit_vector.h"

namespace voussoir::app::reader
{

Eigen::Vector3d read_vector(const YamlCursor& value, const words::Dimension& dimension, Kinematics kinematics)
{
    if (is_planar(kinematics) && !value.is_list_of(3)) return to_space(value.as_plane_vector(dimension));
    return value.as_vector(dimension);
}

void forbid_y(YamlCursor& map)
{
    map.forbid("y", "a planar scene lies in x and z");
}

void read_plane_condition(YamlCursor& top, Model& model)
{
    if (model.kinematics == Kinematics::planar_deformable)
        model.plane = top.choice_or<PlaneCondition>(
            "plane", {{"strain", PlaneCondition::strain}, {"stress", PlaneCondition::stress}}, model.plane);
    else if (is_planar(model.kinematics))
        top.forbid("plane", "rigid blocks have neither strain nor stress");
    else
        top.forbid("plane", "it belongs to kinematics: planar_deformable");
}

Eigen::Vector3d read_direction(const YamlCursor& value, Kinematics kinematics)
{
    const Eigen::Vector3d direction = read_vector(value, words::dimension::number, kinematics);
    if (is_planar(kinematics) && std::abs(direction.y()) > 0)  // NaN is a fault already
        value.fault(fmt::format("{:g} along y", direction.y()), "a planar scene lies in x and z: give [x, z]");
    return of_measurable_length(direction);
}

Eigen::Vector3d read_place(const YamlCursor& value, Kinematics kinematics)
{
    const Eigen::Vector3d place = read_vector(value, words::dimension::length, kinematics);
    if (!is_planar(kinematics)) return place;
    if (std::abs(place.y()) > 0)
        value.warn(fmt::format(
            "y = {:g} m is ignored: all points through the thickness of a planar scene move alike", place.y()));
    return {place.x(), 0, place.z()};
}

}  // namespace voussoir::app::reader
