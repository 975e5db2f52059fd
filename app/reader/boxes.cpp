#include <Eigen/Geometry>
#include <limits>

#include "app/reader/block_reading.h"

namespace voussoir::app::reader
{
namespace
{

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
    Belonging belonging = read_belonging(entry, reading.model, true);
    entry.reject_unknown_keys();
    // A rotation is checked even if the box is none, so that its faults are listed too.
    const bool sound = reading.findings.faults.size() == faults_before;
    ConvexPolyhedron shape =
        make_box(sound ? lower : Eigen::Vector3d(0, 0, 0), sound ? upper : Eigen::Vector3d(1, 1, 1));
    if (rotate) {
        const Rotation turn =
            read_rotation(*rotate, reading.model.kinematics, (lower + upper) / 2, "the centre of the box");
        const Eigen::Matrix3d matrix = turn.matrix();
        for (Eigen::Vector3d& vertex : shape.vertices) vertex = turn.about + matrix * (vertex - turn.about);
    }
    if (reading.findings.faults.size() > faults_before) return;
    add_stones({{name, {std::move(shape)}, {}}}, box, std::move(belonging), "the block is named " + name, reading);
}

}  // namespace voussoir::app::reader
