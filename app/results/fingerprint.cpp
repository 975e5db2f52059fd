#include "app/results/fingerprint.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/results/packed.h"

namespace voussoir::app::results
{

namespace
{

constexpr double finest_record = 5e-4;  // s: no sample of a record falls between instants as close as this

void add_part(const ConvexPolyhedron& part, Packer& packer)
{
    for (const Eigen::Vector3d& vertex : part.vertices) packer.field(vertex);
    for (const auto& face : part.faces) packer.list(face);
}

void add_block(const Block& block, Packer& packer)
{
    packer.fields(block.name, block.group, block.material, block.moments.volume, block.attached_mass,
                  block.friction_factor, block.moments.centroid);
    for (const ConvexPolyhedron& part : block.parts) add_part(part, packer);
    for (const ConvexPolygon& outline : block.outlines)
        for (const Eigen::Vector2d& vertex : outline.vertices) packer.field(vertex);
}

std::uint64_t hash_of_blocks(const Model& model)
{
    std::uint64_t hash = fnv1a({});
    for (const Block& block : model.blocks) {
        Packer packer;
        add_block(block, packer);
        hash = fnv1a(packer.bytes, hash);
    }
    if (model.fit_tolerance == 0) return hash;
    Packer packer;
    packer.field(model.fit_tolerance);
    return fnv1a(packer.bytes, hash);
}

/// Displacement, velocity and acceleration of the whole stage.
std::uint64_t hash_of_motion(const GroundMotion& motion, const Stage& stage, std::uint64_t hash)
{
    const double interval = std::min(finest_record, stage.control.time_step);
    const auto count = static_cast<std::int64_t>(std::ceil(stage.duration / interval));
    Packer packer;
    for (std::int64_t i = 0; i <= count; ++i) {
        const double time = static_cast<double>(i) * interval;
        packer.fields(motion.displacement(time), motion.velocity(time), motion.acceleration(time));
    }
    return fnv1a(packer.bytes, hash);
}

std::uint64_t hash_of_motions(const std::vector<Stage>& stages)
{
    std::uint64_t hash = fnv1a({});
    for (const Stage& stage : stages) {
        std::set<const GroundMotion*> seen;  // one motion may move many foundations
        const auto add = [&](const GroundMotion* motion, int follower, int component) {
            Packer packer;
            packer.fields(follower, component);
            hash = fnv1a(packer.bytes, hash);
            if (seen.insert(motion).second) hash = hash_of_motion(*motion, stage, hash);
        };
        for (const FoundationMotion& m : stage.motions) add(m.motion.get(), m.foundation, m.component);
        for (const BodyAcceleration& m : stage.body_accelerations) add(m.motion.get(), m.block, m.component);
        for (const IncomingWave& m : stage.incoming_waves) add(m.motion.get(), m.boundary, m.component);
    }
    return hash;
}

}  // namespace

Fingerprint fingerprint_of(const Case& the_case)
{
    Packer overrides;
    overrides.list(the_case.overrides);
    return {version::engine_version(), fnv1a(the_case.text), fnv1a(overrides.bytes),
            hash_of_blocks(the_case.model), hash_of_motions(the_case.stages)};
}

bool same_input(const Fingerprint& before, const Fingerprint& now)
{
    return before.text == now.text && before.overrides == now.overrides;
}

std::string differences(const Fingerprint& before, const Fingerprint& now)
{
    std::string changed;
    const auto compare = [&](bool differs, const std::string& what) {
        if (differs) changed += (changed.empty() ? "" : ", ") + what;
    };
    compare(before.text != now.text, "the case file");
    compare(before.overrides != now.overrides, "--set");
    if (!changed.empty()) return changed;  // what follows from it
    compare(before.blocks != now.blocks, "a mesh file (the blocks differ)");
    compare(before.motions != now.motions, "a record (the ground motion differs)");
    return changed;
}

}  // namespace voussoir::app::results
