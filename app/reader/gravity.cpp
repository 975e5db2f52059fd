#include "app/reader/gravity.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <numbers>

#include "app/reader/plane.h"
#include "libdda/geometry/unit_vector.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double largest_gravity = 1e9;  // m/s2: more is a slip, and squares of it are soon no numbers
constexpr double least_lean = 1e-6;      // rad, between gravity and the direction that it is to turn towards

/// A vector turned by an angle towards a direction, in the plane of the two.
Eigen::Vector3d turned(const Eigen::Vector3d& gravity, const Eigen::Vector3d& towards, double angle)
{
    const Eigen::Vector3d axis = unit_vector(Eigen::Vector3d(gravity.cross(towards)));
    return Eigen::AngleAxisd(angle, axis) * gravity;
}

/// The direction that gravity leans towards; zero, with a fault, if there is none.
Eigen::Vector3d read_towards(YamlCursor& map, Kinematics kinematics, const Eigen::Vector3d& gravity)
{
    const auto value = map.require("towards", "the horizontal direction that gravity leans to, such as [1, 0, 0]");
    if (!value) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d towards = read_direction(*value, kinematics);
    if (gravity.cross(unit_vector(towards)).norm() > least_lean * gravity.norm()) return towards;
    value->fault("along gravity, or of length 0", "give a direction across it, such as [1, 0, 0]");
    return Eigen::Vector3d::Zero();
}

}  // namespace

Eigen::Vector3d read_gravity(YamlCursor& top, Kinematics kinematics)
{
    Eigen::Vector3d otherwise = Stage{}.gravity;
    std::optional<YamlCursor> map = top.find("gravity");
    if (!map) {
        top.took_default("gravity", fmt::format("{:g} m/s2 along -z", otherwise.norm()));
        return otherwise;
    }
    if (!map->expect_map("gravity {magnitude: 9.80665 m/s2, direction: [0, 0, -1]}")) return otherwise;
    const double magnitude = map->quantity_or("magnitude", words::dimension::acceleration,
                                              words::Range{0, largest_gravity, true, true}, otherwise.norm());
    Eigen::Vector3d direction = otherwise.normalized();
    if (const std::optional<YamlCursor> value = map->find("direction")) {
        direction = read_direction(*value, kinematics);
        if (direction.norm() == 0) value->fault("a direction of length 0", "give one such as [0, 0, -1]");
    } else {
        map->took_default("direction", "[0, 0, -1]");
    }
    map->reject_unknown_keys();
    return magnitude * direction.normalized();
}

void read_stage_gravity(YamlCursor& top, Kinematics kinematics, Stage& stage)
{
    std::optional<YamlCursor> map = top.find("gravity");
    if (!map || !map->expect_map("gravity {ramp: 2 s} or {tilt: 10 deg, towards: [1, 0, 0]}")) return;
    const Eigen::Vector3d scene = stage.gravity;
    if (stage.type != StageType::dynamic)
        for (const char* key : {"ramp", "from"}) map->forbid(key, "time does not pass in a static stage");
    const words::Range angles{0, std::numbers::pi, true, false};
    const auto ramp = map->find_quantity("ramp", words::dimension::time, words::Range::positive());
    const auto tilt = map->find_quantity("tilt", words::dimension::angle, angles);
    const auto from = map->find_quantity("from", words::dimension::angle, angles);
    if (ramp) stage.gravity_ramp.duration = *ramp;
    if (tilt) {
        const Eigen::Vector3d towards = read_towards(*map, kinematics, scene);
        if (towards.norm() > 0) {
            stage.gravity = turned(scene, towards, *tilt);
            stage.gravity_ramp.from = turned(scene, towards, from.value_or(0));
            stage.gravity_ramp.turns = true;
        }
    } else {
        map->forbid("towards", "there is no tilt");
        map->forbid("from", "there is no tilt");
        if (!ramp) map->fault("neither ramp nor tilt", "give {ramp: 2 s} or {tilt: 10 deg, towards: [1, 0, 0]}");
    }
    if (tilt && !ramp) map->forbid("from", "there is no ramp");
    map->reject_unknown_keys();
}

}  // namespace voussoir::app::reader
