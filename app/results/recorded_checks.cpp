#include "app/results/recorded_checks.h"

#include <algorithm>
#include <cmath>

#include "libdda/errors.h"

namespace voussoir::app::results
{

namespace
{

struct Expectations {
    const std::string& place;
    void operator()(bool holds, const char* found) const
    {
        if (!holds) throw InputError(place, found, "the file is damaged: run the case again");
    }
};

bool all_below(const std::vector<std::int32_t>& indices, std::size_t bound)
{
    return std::all_of(indices.begin(), indices.end(),
                       [&](std::int32_t index) { return index >= 0 && static_cast<std::size_t>(index) < bound; });
}

/// `count` + 1 positions in a list of `size` entries, from 0 and not falling.
bool are_positions(const std::vector<std::int32_t>& positions, std::size_t count, std::size_t size)
{
    return positions.size() == count + 1 && positions.front() == 0 &&
           std::is_sorted(positions.begin(), positions.end()) &&
           static_cast<std::size_t>(positions.back()) <= size;
}

bool are_finite(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

void check_recorded(const RecordedModel& model, const std::string& place)
{
    const Expectations expect{place};
    const SurfaceMesh& mesh = model.mesh;
    const std::size_t blocks = model.block_names.size(), faces = mesh.face_block.size();
    const std::size_t vertices = mesh.levers.size() / static_cast<std::size_t>(mesh.dimension);
    expect(model.centroids.size() == blocks, "another number of centroids than of blocks");
    for (const Eigen::Vector3d& x : model.centroids) expect(x.allFinite(), "a centroid that is not finite");
    expect(all_below(model.foundations, blocks), "a foundation that is not a block");
    expect(!is_planar(model.kinematics) || (model.thickness > 0 && std::isfinite(model.thickness)),
           "a planar scene without thickness");
    expect(are_finite(mesh.levers) && mesh.levers.size() % static_cast<std::size_t>(mesh.dimension) == 0,
           "a vertex that is not finite");
    expect(are_positions(mesh.block_first_vertex, blocks, vertices), "vertices that belong to no block");
    expect(are_positions(mesh.face_first, faces, mesh.face_vertices.size()), "faces without corners");
    expect(all_below(mesh.face_vertices, vertices), "a face with a corner that is not there");
    expect(all_below(mesh.face_block, blocks), "a face that belongs to no block");
    expect(mesh.face_part.size() == faces, "a face that belongs to no part");
    const auto is_block = [&](int block) { return block >= 0 && static_cast<std::size_t>(block) < blocks; };
    for (const WatchedJoint& joint : model.joints)
        expect(is_block(joint.block_a) && is_block(joint.block_b), "a joint between no blocks");
}

void check_recorded(const RecordedFrame& frame, const RecordedModel& model, const std::string& place)
{
    const Expectations expect{place};
    const std::size_t blocks = model.block_names.size();
    const auto is_block = [&](int block) { return block >= 0 && static_cast<std::size_t>(block) < blocks; };
    expect(std::isfinite(frame.time), "a frame without time");
    expect(frame.stage >= 0 &&
               static_cast<std::size_t>(frame.stage) < std::max<std::size_t>(model.stage_names.size(), 1),
           "a frame of no stage");
    expect(frame.state.coordinates.size() ==
                   blocks * static_cast<std::size_t>(coordinates_per_block(model.kinematics)) &&
               are_finite(frame.state.coordinates),
           "a frame without the positions of its blocks");
    expect(
        frame.state.velocities.size() == blocks * static_cast<std::size_t>(unknowns_per_block(model.kinematics)),
        "a frame without the velocities of its blocks");
    expect(frame.stresses.size() == (is_deformable(model.kinematics) ? blocks : 0),
           "a frame without the stresses of its blocks");
    expect(frame.joints.size() == model.joints.size(), "a frame without its joints");
    for (const JointResultant& contact : frame.contacts)
        expect(is_block(contact.block_a) && is_block(contact.block_b), "a contact between no blocks");
}

}  // namespace voussoir::app::results
