#include "app/results/histories.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <utility>

#include "app/results/atomic_file.h"
#include "app/results/surface_mesh.h"
#include "libdda/errors.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

int block_named(const Model& model, const HistoryPoint& point)
{
    const auto found = std::find_if(model.blocks.begin(), model.blocks.end(),
                                    [&](const Block& block) { return block.name == point.block; });
    if (found == model.blocks.end()) {
        throw InputError("output.histories." + point.name, "block \"" + point.block + "\"",
                         "name a block of the model");
    }
    return static_cast<int>(found - model.blocks.begin());
}

/// Velocity of a material point: dc/dt + dA/dt X, or dc/dt + omega x (R X) in a rigid scene.
Vector3d point_velocity(const Model& model, const State& state, int block, const Vector3d& lever)
{
    const Vector3d centre = velocity_of(model.kinematics, state, block);
    if (is_deformable(model.kinematics)) {
        const double* rate = state.velocities.data() + block * unknowns_per_block(model.kinematics) + 3;
        return centre + Eigen::Map<const Eigen::Matrix3d>(rate) * lever;
    }
    const Vector3d turned = pose_of(model.kinematics, state, block).map * lever;
    return centre + angular_velocity_of(model, state, block).cross(turned);
}

void append_three(std::vector<double>& values, const Vector3d& v)
{
    values.insert(values.end(), v.data(), v.data() + 3);
}

/// A name that cannot break the line it stands in.
std::string csv_safe(std::string name)
{
    for (char& c : name) {
        if (c == ',' || c == '"' || c == '\n' || c == '\r') c = '_';
    }
    return name;
}

}  // namespace

Histories::Histories(const Case& the_case, const std::filesystem::path& path) : model_(the_case.model), path_(path)
{
    if (the_case.output.histories.empty()) return;
    columns = {"time [s]"};
    for (const HistoryPoint& point : the_case.output.histories) {
        const int block = block_named(model_, point);
        const Vector3d centroid = model_.blocks[block].moments.centroid;
        const Vector3d place = point.point ? Vector3d(*point.point - model_.origin) : centroid;
        points_.push_back({block, place - centroid});
        for (const char* quantity : {"ux [m]", "uy [m]", "uz [m]", "vx [m/s]", "vy [m/s]", "vz [m/s]"}) {
            columns.push_back(csv_safe(point.name) + " " + quantity);
        }
    }
    if (!model_.foundations.empty()) {
        for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("ground u{} [m]", axis));
    }
    stream_.open(path_, std::ios::trunc);
    if (!stream_) refuse_writing(path_, errno);
    stream_ << fmt::format("{}\n", fmt::join(columns, ","));
}

void Histories::line(const State& state)
{
    if (columns.empty()) return;
    pending_.push_back(state.time);
    for (const Point& point : points_) {
        const Pose pose = pose_of(model_.kinematics, state, point.block);
        const Vector3d moved = pose.centroid - model_.blocks[point.block].moments.centroid;
        append_three(pending_, moved + pose.map * point.lever - point.lever);
        append_three(pending_, point_velocity(model_, state, point.block, point.lever));
    }
    if (!model_.foundations.empty()) append_three(pending_, ground_displacement(model_, state));
}

std::vector<double> Histories::flush()
{
    if (columns.empty()) return {};
    std::string text;
    for (std::size_t i = 0; i < pending_.size(); ++i) {
        const bool last = (i + 1) % columns.size() == 0;
        fmt::format_to(std::back_inserter(text), "{}{}", pending_[i], last ? '\n' : ',');
    }
    errno = 0;
    if (!(stream_ << text << std::flush)) refuse_writing(path_, errno == 0 ? EIO : errno);
    return std::exchange(pending_, {});
}

}  // namespace voussoir
