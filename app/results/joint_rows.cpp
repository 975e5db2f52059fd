#include "app/results/joint_rows.h"

#include <algorithm>
#include <limits>

#include "app/results/scene_vectors.h"

namespace voussoir::app::results
{

namespace
{

/// A number of each joint in each frame.
struct JointColumn {
    const char* name;
    double (*value)(const JointNow& now);
};

constexpr JointColumn columns[] = {
    {"opening", [](const JointNow& now) { return now.motion.opening; }},
    {"mean_opening", [](const JointNow& now) { return now.motion.mean_opening; }},
    {"slip", [](const JointNow& now) { return now.motion.slip; }},
    {"largest_slip", [](const JointNow& now) { return now.motion.largest_slip; }},
    {"normal_force", [](const JointNow& now) { return now.normal_force; }},
    {"shear_force", [](const JointNow& now) { return now.shear_force; }},
    {"eccentricity", [](const JointNow& now) { return now.eccentricity; }},
    {"area_in_use", [](const JointNow& now) { return now.area_in_use; }},
};

std::string dataset(const char* name)
{
    return std::string("/frames/joints/") + name;
}

bool any_bonded(const std::vector<WatchedJoint>& joints)
{
    return std::any_of(joints.begin(), joints.end(), [](const WatchedJoint& joint) { return joint.bonded; });
}

}  // namespace

void write_joints(const Model& model, const std::vector<WatchedJoint>& joints, Hdf5File& file)
{
    if (joints.empty()) return;
    std::vector<std::int32_t> pairs, bonded;
    std::vector<double> area, facing, centre, normal;
    for (const WatchedJoint& joint : joints) {
        pairs.insert(pairs.end(), {joint.block_a, joint.block_b});
        area.push_back(joint.area);
        facing.push_back(joint.facing_area);
        append_vector(centre, joint.centre, model.kinematics);
        append_vector(normal, joint.normal, model.kinematics);
        bonded.push_back(joint.bonded);
    }
    const std::uint64_t count = joints.size(), dimension = axes_of(model.kinematics).size();
    file.make_group("/joints");
    file.write("/joints/pair", pairs, {count, 2});
    file.write("/joints/area", area);
    file.write("/joints/facing_area", facing);
    file.write("/joints/centre", centre, {count, dimension});
    file.write("/joints/normal", normal, {count, dimension});
    if (any_bonded(joints)) file.write("/joints/bonded", bonded);
}

void add_joint_datasets(const std::vector<WatchedJoint>& joints, std::vector<GrowingDataset>& datasets)
{
    if (joints.empty()) return;
    const Extents row = {joints.size()};
    constexpr std::uint64_t chunk_bytes = 1U << 15;  // there are many of them, and short runs should stay small
    for (const JointColumn& column : columns)
        datasets.push_back({dataset(column.name), ElementType::float32, row, {}, chunk_bytes});
    if (any_bonded(joints)) datasets.push_back({dataset("broken"), ElementType::int32, row, {}, chunk_bytes});
}

void add_joint_rows(const std::vector<WatchedJoint>& joints, const std::vector<JointNow>& now,
                    std::vector<Rows>& rows)
{
    if (joints.empty()) return;
    for (const JointColumn& column : columns) {
        std::vector<float> values;
        for (const JointNow& joint : now) values.push_back(static_cast<float>(column.value(joint)));
        rows.push_back({dataset(column.name), std::move(values)});
    }
    if (!any_bonded(joints)) return;
    std::vector<std::int32_t> broken;
    for (const JointNow& joint : now) broken.push_back(joint.broken);
    rows.push_back({dataset("broken"), std::move(broken)});
}

void write_joint_peaks(std::span<const JointPeaks> peaks, Hdf5File& file)
{
    if (peaks.empty()) return;
    constexpr double never = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> opening, slip, opened, slid;
    for (const JointPeaks& joint : peaks) {
        opening.push_back(joint.opening);
        slip.push_back(joint.slip);
        opened.push_back(joint.opened.value_or(never));
        slid.push_back(joint.slid.value_or(never));
    }
    file.write("/joints/largest_opening", opening);
    file.write("/joints/largest_slip", slip);
    file.write("/joints/opened_time", opened);
    file.write("/joints/slid_time", slid);
}

}  // namespace voussoir::app::results
