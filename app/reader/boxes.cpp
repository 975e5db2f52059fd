#include <Eigen/Geometry>
#include <limits>

#include "app/reader/block_reading.h"

namespace voussoir::app::reader
{
namespace
{

/// `rotate: {axis: [0, 1, 0], angle: 45 deg, about: [0, 0, 0]}`; about the box's centre if `about` is not given.
void rotate_vertices(YamlCursor& rotate, const Eigen::Vector3d& centre, std::vector<Eigen::Vector3d>& vertices)
{
    if (!rotate.expect_map("a rotation {axis: [x, y, z], angle: 45 deg}")) return;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(), about = centre;
    if (const auto value = rotate.require("axis", "the axis of the rotation [x, y, z]"))
        axis = value->as_vector(words::dimension::number);
    const double angle = rotate.quantity("angle", words::dimension::angle, words::Range::any());
    if (const auto value = rotate.find("about"))
        about = value->as_vector(words::dimension::length);
    else
        rotate.took_default("about", "the centre of the box");
    rotate.reject_unknown_keys();
    if (axis.norm() == 0) return rotate.fault("an axis of length 0", "give a direction");
    const Eigen::AngleAxisd rotation(angle, axis.normalized());
    for (Eigen::Vector3d& vertex : vertices) vertex = about + rotation * (vertex - about);
}

Eigen::Vector3d read_corner(YamlCursor& box, const std::string& key)
{
    const auto value = box.require(key, "the " + key + " corner [x, y, z]");
    if (value) return value->as_vector(words::dimension::length);
    return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

void read_box(YamlCursor& entry, YamlCursor& box, BlockReading& reading)
{
    if (!box.expect_map("a box {name, lower: [x, y, z], upper: [x, y, z]}")) return;
    const std::optional<YamlCursor> first_corner = box.find("lower");
    if (is_planar(reading.model.kinematics) && first_corner && first_corner->is_list_of(2))
        return read_flat_box(entry, box, reading);
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = box.text("name", "the block's name");
    const Eigen::Vector3d lower = read_corner(box, "lower"), upper = read_corner(box, "upper");
    if ((upper.array() <= lower.array()).any()) box.fault("no volume", "upper must exceed lower in x, y and z");
    std::optional<YamlCursor> rotate = box.find("rotate");
    box.reject_unknown_keys();
    const Belonging belonging = read_belonging(entry, reading.model.materials);
    // A rotation is checked even if the box is none, so that its faults are listed too.
    const bool sound = reading.findings.faults.size() == faults_before;
    ConvexPolyhedron shape =
        make_box(sound ? lower : Eigen::Vector3d(0, 0, 0), sound ? upper : Eigen::Vector3d(1, 1, 1));
    if (rotate) rotate_vertices(*rotate, (lower + upper) / 2, shape.vertices);
    if (reading.findings.faults.size() > faults_before) return;
    add_block(name, box.place(), belonging.group, belonging.material, {std::move(shape)}, reading);
}

}  // namespace voussoir::app::reader
