#include "app/reader/passage.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "app/reader/plane.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector3d;

constexpr double slowest_wave = 1;  // m/s along the ground: less is a slip of the pen
constexpr double early = 1e-9;      // s: what rounding of a place may make of nothing

std::string in_words(const Vector3d& place, const Model& model)
{
    const Vector3d p = place + model.origin;
    if (is_planar(model.kinematics)) return fmt::format("[{:.6g}, {:.6g}]", p.x(), p.z());
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", p.x(), p.y(), p.z());
}

}  // namespace

Passage read_passage(YamlCursor& map, const Model& model, const std::vector<Vector3d>& places)
{
    Passage passage;
    if (!map.expect_map("passes {speed: 2000 m/s, direction: [1, 0, 0]}")) return passage;
    const std::size_t faults = map.fault_count();
    const double speed = map.quantity("speed", words::dimension::velocity,
                                      {slowest_wave, std::numeric_limits<double>::infinity(), true, true});
    const auto direction = map.require("direction", "the way it goes, such as [1, 0, 0]");
    if (direction) {
        const Vector3d way = read_direction(*direction, model.kinematics);
        if (way.norm() == 0) direction->fault("a direction of length 0", "give one such as [1, 0, 0]");
        passage.slowness = way.normalized() / speed;
    }
    const auto from = map.find("from");
    if (from) passage.from = read_place(*from, model.kinematics) - model.origin;
    map.reject_unknown_keys();
    if (map.fault_count() != faults) return {};  // what is wrong delays nothing
    if (places.empty()) return passage;
    const Vector3d first = *std::min_element(
        places.begin(), places.end(),
        [&](const Vector3d& a, const Vector3d& b) { return passage.slowness.dot(a) < passage.slowness.dot(b); });
    if (!from) {
        passage.from = first;
        map.took_default("from", in_words(first, model) + ", where it comes first");
    } else if (const double delay = passage.delay_at(first); delay < -early) {
        from->fault(
            fmt::format("a wave that is at {} {:.3g} s before its motion begins", in_words(first, model), -delay),
            "name a place that it reaches no later, or leave `from` away");
    }
    return passage;
}

}  // namespace voussoir::app::reader
