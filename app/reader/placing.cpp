#include "app/reader/placing.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>

#include "app/reader/plane.h"
#include "importers/patterns/max_blocks.h"
#include "libdda/geometry/unit_vector.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector3d;
using importers::helper::after;
using importers::patterns::max_blocks;

Vector3d read_axis(YamlCursor& rotate, Kinematics kinematics)
{
    const std::optional<YamlCursor> value =
        is_planar(kinematics) ? rotate.find("axis")
                              : rotate.require("axis", "the axis of the rotation, z or [x, y, z]");
    if (!value) return -Vector3d::UnitY();
    if (value->is_scalar())
        return Vector3d::Unit(rotate.find_choice<int>("axis", {{"x", 0}, {"y", 1}, {"z", 2}}).value_or(2));
    const Vector3d axis = value->as_vector(words::dimension::number);
    if (axis.isZero(0)) value->fault("an axis of length 0", "give a direction");
    return unit_vector(axis);
}

Vector3d read_scale(const YamlCursor& value, Kinematics kinematics)
{
    if (!value.is_list())
        return Vector3d::Constant(value.as_quantity(words::dimension::number, words::Range::positive()));
    Vector3d factors = read_vector(value, words::dimension::number, kinematics);
    if (is_planar(kinematics) && !value.is_list_of(3)) factors.y() = 1;
    if ((factors.array() <= 0).any())  // NaN is a fault already
        value.fault(fmt::format("[{:g}, {:g}, {:g}]", factors.x(), factors.y(), factors.z()),
                    "all factors must be > 0; mirror: {plane: x} makes left of right");
    return factors;
}

/// `{plane: x, at: 1 m}`: the plane x = 1 m.
PlacedCopy read_mirror(YamlCursor& mirror)
{
    PlacedCopy copy;
    if (!mirror.expect_map("a mirror {plane: x, at: 1 m}")) return copy;
    const std::optional<int> axis = mirror.find_choice<int>("plane", {{"x", 0}, {"y", 1}, {"z", 2}});
    if (!axis) mirror.require("plane", "the axis across the mirror, x, y or z");
    const double at = mirror.quantity_or("at", words::dimension::length, words::Range::any(), 0);
    mirror.reject_unknown_keys();
    copy.linear(axis.value_or(0), axis.value_or(0)) = -1;
    copy.offset[axis.value_or(0)] = 2 * at;
    return copy;
}

PlacedCopy turned(const Rotation& rotation, int times = 1)
{
    PlacedCopy copy;
    copy.linear = rotation.matrix(times);
    copy.offset = rotation.about - copy.linear * rotation.about;
    return copy;
}

/// One item of `copy`: what it does to the original, once for each copy.
struct CopyStep {
    std::vector<PlacedCopy> copies;
    bool is_mirror = false;
};

/// `{copies: 3, step: [2 m, 0, 0], rotate: {...}}`: copy k is turned by k angles and moved by k steps.
/// Or `{mirror: {...}}`.
CopyStep read_copy_step(YamlCursor& item, Kinematics kinematics)
{
    std::optional<YamlCursor> mirror = item.find("mirror"), rotate = item.find("rotate");
    const std::optional<YamlCursor> step = item.find("step"), count = item.find("copies");
    item.reject_unknown_keys();
    if (mirror) {
        if (rotate || step || count)
            mirror->fault("a mirror beside copies, step or rotate",
                          "make it an item of its own: [{copies: 3, ...}, {mirror: ...}]");
        return {{read_mirror(*mirror)}, true};
    }
    if (!step && !rotate) item.fault("a copy in the place of the original", "give step, rotate or mirror");
    const int copies = item.integer_or("copies", 1, static_cast<int>(max_blocks) - 1, 1);
    const Vector3d moved = step ? read_vector(*step, words::dimension::length, kinematics) : Vector3d(0, 0, 0);
    const Rotation turn = rotate ? read_rotation(*rotate, kinematics, Vector3d::Zero(), "the origin") : Rotation();
    CopyStep row;
    for (int k = 1; k <= copies; ++k) {
        row.copies.push_back(turned(turn, k));
        row.copies.back().offset += k * moved;
    }
    return row;
}

/// A copy while rows are multiplied.
struct CountedCopy {
    PlacedCopy place;
    std::string numbers, mirrored;  // "_1_3": which of each row it is
    bool is_first = true;           // of every row: its name needs no numbers
};

/// Each copy so far, once as it is and once for each copy of the step.
std::vector<CountedCopy> multiplied(const std::vector<CountedCopy>& copies, const CopyStep& step, int mirrors)
{
    std::vector<CountedCopy> all;
    all.reserve(copies.size() * (step.copies.size() + 1));
    for (std::size_t k = 0; k <= step.copies.size(); ++k)
        for (CountedCopy copy : copies) {
            if (k > 0) copy.place = after(step.copies[k - 1], copy.place);
            if (!step.is_mirror) {
                copy.numbers += "_" + std::to_string(k + 1);
                copy.is_first = copy.is_first && k == 0;
            } else if (k > 0) {
                copy.mirrored += mirrors == 1 ? "_mirrored" : "_mirrored" + std::to_string(mirrors);
            }
            all.push_back(std::move(copy));
        }
    return all;
}

std::vector<PlacedCopy> read_copies(const YamlCursor& copy, Kinematics kinematics, const PlacedCopy& original)
{
    const std::string_view form = "a copy {copies: 3, step: [x, y, z]} or a list of them";
    std::vector<CountedCopy> copies{{original, "", "", true}};
    std::vector<YamlCursor> items = copy.is_map() ? std::vector<YamlCursor>{copy} : copy.items(form);
    if (items.empty() && copy.is_list()) copy.fault("no copy", "give " + std::string(form));
    int mirrors = 0;
    for (YamlCursor& item : items) {
        if (!item.expect_map(form)) continue;
        const CopyStep step = read_copy_step(item, kinematics);
        if (copies.size() * (step.copies.size() + 1) > max_blocks) {
            item.fault(fmt::format("more than {} copies", max_blocks), "give fewer copies");
            break;
        }
        mirrors += step.is_mirror;
        copies = multiplied(copies, step, mirrors);
    }
    std::vector<PlacedCopy> places;
    for (CountedCopy& counted : copies) {
        places.push_back(std::move(counted.place));
        places.back().suffix = (counted.is_first ? "" : counted.numbers) + counted.mirrored;
    }
    return places;
}

}  // namespace

Eigen::Matrix3d Rotation::matrix(int times) const
{
    if (angle == 0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(times * angle, axis).toRotationMatrix();
}

Rotation read_rotation(YamlCursor& rotate, Kinematics kinematics, const Vector3d& about, std::string_view whose)
{
    Rotation rotation;
    rotation.about = about;
    if (!rotate.expect_map("a rotation {axis: z, angle: 45 deg}")) return rotation;
    rotation.axis = read_axis(rotate, kinematics);
    rotation.angle = rotate.quantity("angle", words::dimension::angle, words::Range::any());
    if (const auto value = rotate.find("about"))
        rotation.about = read_vector(*value, words::dimension::length, kinematics);
    else
        rotate.took_default("about", std::string(whose));
    rotate.reject_unknown_keys();
    return rotation;
}

std::vector<PlacedCopy> read_placing(YamlCursor& entry, Kinematics kinematics)
{
    PlacedCopy place;
    if (const auto scale = entry.find("scale")) place.linear = read_scale(*scale, kinematics).asDiagonal();
    if (auto mirror = entry.find("mirror")) place = after(read_mirror(*mirror), place);
    if (auto rotate = entry.find("rotate"))
        place = after(turned(read_rotation(*rotate, kinematics, Vector3d::Zero(), "the origin")), place);
    if (const auto move = entry.find("move"))
        place.offset += read_vector(*move, words::dimension::length, kinematics);
    if (const auto copy = entry.find("copy")) return read_copies(*copy, kinematics, place);
    return {place};
}

}  // namespace voussoir::app::reader
