#include "libdda/analysis/collapse.h"

#include <algorithm>

#include "libdda/analysis/bar_forces.h"
#include "libdda/analysis/ground.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/model/disjoint_sets.h"

namespace voussoir
{

namespace
{

using Eigen::Vector3d;

constexpr double domain = 3;  // times the scene's extent

bool is_held(const Model& model, int block)
{
    return std::any_of(model.foundations.begin(), model.foundations.end(),
                       [&](const Foundation& foundation) { return foundation.block == block; });
}

template <int D>
void join(const ContactSetIn<D>& contacts, DisjointSets& sets)
{
    for (const ContactPatchIn<D>& patch : contacts.patches)
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            if (contacts.points[i].status != ContactStatus::open) sets.join(patch.block_a, patch.block_b);
}

/// What hangs from a bar does not fall as long as the bar carries it.
void join_bars(const Model& model, const State& state, DisjointSets& sets)
{
    const std::vector<BarNow> bars = bars_now(model, state);
    for (std::size_t i = 0; i < bars.size(); ++i)
        if (bars[i].axial != 0 || bars[i].shear != 0) sets.join(model.bars[i].block_a, model.bars[i].block_b);
}

/// Whether a chain of closed contacts and bars joins each block to one that the ground holds, or goes on beyond.
std::vector<bool> supported(const Model& model, const State& state)
{
    DisjointSets sets(model.blocks.size());
    join(state.contacts, sets);
    join(state.planar_contacts, sets);
    join_bars(model, state, sets);
    std::vector<bool> holds(model.blocks.size(), false), result(holds);
    for (const int b : blocks_held_by_ground(model)) holds[sets.root_of(b)] = true;
    for (std::size_t b = 0; b < result.size(); ++b) result[b] = holds[sets.root_of(static_cast<int>(b))];
    return result;
}

Vector3d centroid(const Model& model, const State& state, int block)
{
    return pose_of(model.kinematics, state, block).centroid;
}

template <int D>
void note_touched(const ContactSetIn<D>& contacts, std::vector<bool>& touched)
{
    for (const ContactPatchIn<D>& patch : contacts.patches)
        if (patch.point_count > 0) touched[patch.block_a] = touched[patch.block_b] = true;
}

/// Blocks that move of their own in the model as it begins, or touch nothing there.
std::vector<bool> in_flight_at_start(const Model& model)
{
    State start = initial_state(model);
    find_initial_contacts(model, start);
    std::vector<bool> touched(model.blocks.size(), false);
    note_touched(start.contacts, touched);
    note_touched(start.planar_contacts, touched);
    for (const InitialMotion& motion : model.initial_motions) touched[motion.block] = false;
    touched.flip();
    return touched;
}

/// How far the ground has moved since the start; where supports moved differently, their mean [m].
Vector3d ground_displacement(const Model& model, const CollapseWatch& watch, const State& state)
{
    Vector3d sum = Vector3d::Zero();
    const std::vector<int> blocks = blocks_that_are_ground(model);
    for (const int b : blocks) sum += centroid(model, state, b) - watch.start[b];
    return sum / static_cast<double>(blocks.size());
}

}  // namespace

CollapseWatch::CollapseWatch(const Model& model, const State& state)
{
    const int count = static_cast<int>(model.blocks.size());
    for (int b = 0; b < count; ++b) start.push_back(centroid(model, state, b));
    for (const Vector3d& place : start) middle += place / count;
    for (int b = 0; b < count; ++b) extent = std::max(extent, (start[b] - middle).norm() + size_of(model, b));
}

void note_fallen(const Model& model, const CollapseWatch& watch, const Vector3d& gravity, const State& state,
                 RunReport& report)
{
    if (model.foundations.empty() && model.boundaries.empty()) return;
    const Vector3d down = gravity.norm() > 0 ? Vector3d(gravity.normalized()) : Vector3d::Zero();
    std::vector<FallenBlock*> known;  // by block, if any has fallen
    if (!report.fallen.empty()) known.assign(model.blocks.size(), nullptr);
    for (FallenBlock& fallen : report.fallen) known[fallen.block] = &fallen;
    const Vector3d ground = ground_displacement(model, watch, state);
    std::vector<bool> is_supported;
    std::vector<FallenBlock> more;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        const Vector3d now = centroid(model, state, b) - ground;
        const bool left = (now - watch.middle).norm() > domain * watch.extent;
        if (!known.empty() && known[b] != nullptr) {
            known[b]->left = known[b]->left || left;
            continue;
        }
        const double depth = down.dot(now - watch.start[b]);
        if (!left && !(depth > 0 && depth > size_of(model, b))) continue;
        if (is_held(model, b)) continue;  // foundations are looked through only for blocks that went far
        if (is_supported.empty()) is_supported = supported(model, state);
        if (!is_supported[b]) more.push_back({b, state.time, left});
    }
    report.fallen.insert(report.fallen.end(), more.begin(), more.end());
}

std::vector<int> blocks_that_fell(const Model& model, const State& state, const RunReport& report)
{
    std::vector<int> blocks;
    if (report.fallen.empty()) return blocks;
    const std::vector<bool> flew = in_flight_at_start(model), lies = supported(model, state);
    for (const FallenBlock& fallen : report.fallen)
        if (fallen.left || !flew[fallen.block] || !lies[fallen.block]) blocks.push_back(fallen.block);
    return blocks;
}

void note_lost(const std::vector<int>& blocks, double time, RunReport& report)
{
    for (const int block : blocks)
        if (std::none_of(report.fallen.begin(), report.fallen.end(),
                         [&](const FallenBlock& fallen) { return fallen.block == block; }))
            report.fallen.push_back({block, time, false});
}

bool all_have_left(const Model& model, const RunReport& report)
{
    if (report.fallen.empty()) return false;
    std::size_t gone = 0;
    for (const FallenBlock& fallen : report.fallen) gone += fallen.left;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) gone += is_held(model, b);
    return gone == model.blocks.size();
}

std::optional<Diagnosis> diagnosis_of_fallen(const RunReport& report)
{
    if (report.fallen.empty()) return std::nullopt;
    Diagnosis diagnosis{DiagnosisKind::fallen, -1, {}, {}};
    for (const FallenBlock& fallen : report.fallen) {
        diagnosis.blocks.push_back(fallen.block);
        diagnosis.values.push_back(fallen.time);
    }
    return diagnosis;
}

}  // namespace voussoir
