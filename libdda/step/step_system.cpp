#include "libdda/step/step_system.h"

#include <algorithm>
#include <atomic>

#include "libdda/model/parallel.h"
#include "libdda/solve/incomplete_factor.h"
#include "libdda/step/contact_stiffness.h"
#include "libdda/step/part_timer.h"

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

/// Whether stones rub on one another at all.
bool has_friction(const Model& model, int block_a, int block_b)
{
    const JointMaterial& joint = model.joint_between(block_a, block_b);
    return model.friction_factor(block_a, block_b) > 0 &&
           (joint.friction_angle > 0 || !joint.friction_at_speed.empty());
}

/// Whether all that is closed of a joint slides.
template <int D>
bool slides(const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch)
{
    bool any = false;
    for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
        const ContactPointIn<D>& point = contacts.points[i];
        if (point.gap >= 0) continue;
        if (point.status != ContactStatus::sliding) return false;
        any = true;
    }
    return any;
}

/// An elastic stone that slides with constant friction is unstable without damping: its strains and its friction
/// feed each other, at a rate that does not depend on the step, until it chatters and its mean friction falls.
/// While a stone slides its elastic force is therefore that of the end of the step. On a joint without friction
/// nothing feeds anything, and it keeps its energy. Source: docs/numerics.md 5.
template <class K>
void damp_sliding_blocks(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                         std::vector<BlockStep<K>>& blocks)
{
    if (!K::deformable || end_share(stage) == 1) return;
    for (const ContactPatchIn<K::dimension>& patch : contacts.patches)
        if (has_friction(model, patch.block_a, patch.block_b) && slides(contacts, patch))
            for (const int b : {patch.block_a, patch.block_b}) take_elasticity_at_end(blocks[b]);
}

/// Tells the solver where the rows are.
template <class K>
void place_rows(StepSystem<K>& system)
{
    constexpr int D = K::dimension;
    solve::RowPlaces& places = system.places;
    places.kinematics = K::kinematics;
    places.centres.resize(D * system.block_of_row.size());
    places.free.resize(system.block_of_row.size());
    for (std::size_t row = 0; row < system.block_of_row.size(); ++row) {
        const BlockStep<K>& block = system.blocks[system.block_of_row[row]];
        typename K::Vector::MapType(places.centres.data() + D * row) = block.start.centroid;
        places.free[row] = std::none_of(block.held.begin(), block.held.end(), [](bool held) { return held; });
    }
    system.solver->place(places);
}

}  // namespace

template <class K>
void assemble_blocks(const Model& model, const Stage& stage, const State& state,
                     const ContactSetIn<K::dimension>& contacts, double h, const std::vector<Jump<K>>& jumps,
                     StepSystem<K>& system)
{
    const int count = static_cast<int>(model.blocks.size());
    const double end_time = state.stage_time + h;
    system.h = h;
    system.fracture = 0;
    system.blocks.resize(count);
    system.block_of_row.clear();
    for (BlockStep<K>& block : system.blocks) block.is_foundation = false;
    for (const Foundation& foundation : model.foundations) system.blocks[foundation.block].is_foundation = true;
    in_parallel(model.blocks.size(), stage.control.threads, [&](std::size_t first, std::size_t end) {
        const auto earlier = [](const Jump<K>& jump, std::size_t block) {
            return jump.block < static_cast<int>(block);
        };
        auto jump = std::lower_bound(jumps.begin(), jumps.end(), first, earlier);
        for (int b = static_cast<int>(first); b < static_cast<int>(end); ++b) {
            const bool lands = jump != jumps.end() && jump->block == b;
            begin_block(model, stage, state, b, h, end_time, lands ? &*jump++ : nullptr, system.blocks[b]);
        }
    });
    for (int b = 0; b < count; ++b) {
        BlockStep<K>& block = system.blocks[b];
        bool all_held = true;
        for (const bool held : block.held) all_held = all_held && held;
        block.row = all_held ? -1 : static_cast<int>(system.block_of_row.size());
        if (!all_held) system.block_of_row.push_back(b);
    }
    damp_sliding_blocks<K>(model, stage, contacts, system.blocks);
    find_applied_forces(model, stage, state, h, end_time, system.blocks, system.applied);
    begin_bars(model, state, system.blocks, system.bars);
    system.end_share = end_share(stage);
    add_body_accelerations(stage, h, end_time, system.blocks);
    begin_contacts(model, stage, h, contacts, system.blocks, system.contacts);
    system.relaxation.begin();
    system.local.begin();
    system.patches_of_rows.begin();

    const int rows = static_cast<int>(system.block_of_row.size());
    system.threads = is_large(system) ? stage.control.threads : 1;
    system.pairs.clear();
    for (const PatchStep<K>& patch : system.contacts.patches)
        if (patch.row_a >= 0 && patch.row_b >= 0)
            system.pairs.emplace_back(std::max(patch.row_a, patch.row_b), std::min(patch.row_a, patch.row_b));
    for (const Coupling<K>& coupling : system.applied.couplings) {
        const int row = system.blocks[coupling.block].row, column = system.blocks[coupling.other].row;
        if (coupling.mutual && row > column && column >= 0) system.pairs.emplace_back(row, column);
    }
    add_bar_pairs(system.blocks, system.bars, system.pairs);
    if (system.pairs != system.known_pairs || system.matrix.rows() != rows) {
        system.known_pairs = system.pairs;
        solve::set_pattern(system.matrix, K::unknowns, rows, system.pairs);
    }
    system.d.setZero(rows * K::unknowns);
    system.residual.setZero(rows * K::unknowns);
    system.contact_force.setZero(rows * K::unknowns);
    system.internal.resize(rows);
    system.load.assign(rows, 0.0);
    if (!system.solver || system.solver_kind != stage.control.linear_solver) {
        system.solver = solve::make_linear_solver(stage.control.linear_solver, stage.control.linear_tolerance);
        system.solver_kind = stage.control.linear_solver;
    }
    system.solver->use_threads(stage.control.threads);
    place_rows(system);
}

namespace
{

/// Force scale of a block: what it weighs, what its contacts press, what its own deformation and spin carry.
template <class K>
double load_of(const BlockStep<K>& block, const InternalForce<K>& internal, double pressing)
{
    double load =
        block.body_force.norm() + pressing + block.steady.tail(K::unknowns - K::dimension).norm() / block.size;
    if constexpr (K::deformable) load += internal.force.norm() / block.size;
    return load;
}

/// What the points of a patch press [N].
template <class K>
double pressing_of(const PatchStep<K>& patch, const ContactStep<K>& contacts)
{
    double pressing = 0;
    for (int i = patch.first; i < patch.first + patch.count; ++i) pressing += std::abs(contacts.points[i].normal);
    return pressing;
}

template <class K>
void add_contact_force(int row, const typename K::Unknowns& force, double pressing, StepSystem<K>& system)
{
    constexpr int n = K::unknowns;
    system.contact_force.template segment<n>(n * row) += force;
    system.load[row] += pressing;
}

template <class K>
void gather_contact_forces(StepSystem<K>& system)
{
    const ContactStep<K>& contacts = system.contacts;
    system.contact_force.setZero();
    system.load.assign(system.load.size(), 0.0);
    if (system.threads <= 1) {
        for (const PatchStep<K>& patch : contacts.patches) {
            const double pressing = pressing_of(patch, contacts);
            if (pressing == 0 && patch.force_a.isZero(0)) continue;
            if (patch.row_a >= 0) add_contact_force<K>(patch.row_a, patch.force_a, pressing, system);
            if (patch.row_b >= 0) add_contact_force<K>(patch.row_b, patch.force_b, pressing, system);
        }
        return;
    }
    // Row by row, in the same order.
    system.patches_of_rows.find(contacts.patches, system.block_of_row.size());
    in_parallel(system.block_of_row.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row)
            for (const int k : system.patches_of_rows.of(row)) {
                const PatchStep<K>& patch = contacts.patches[k];
                const double pressing = pressing_of(patch, contacts);
                if (pressing == 0 && patch.force_a.isZero(0)) continue;
                const auto& force = patch.row_a == row ? patch.force_a : patch.force_b;
                add_contact_force<K>(row, force, pressing, system);
            }
    });
}

/// What acts on blocks by itself, at the iterate d.
template <class K>
void gather_applied_forces(const VectorXd& d, StepSystem<K>& system)
{
    constexpr int n = K::unknowns;
    for (const AppliedForce<K>& applied : system.applied.own) {
        const int row = system.blocks[applied.block].row;
        if (row < 0) continue;
        const typename K::Unknowns force = system.applied.at(applied, system.blocks, d);
        system.contact_force.template segment<n>(n * row) += force;
        system.load[row] += force.template head<K::dimension>().norm();
    }
}

}  // namespace

template <class K>
bool evaluate_residual(const VectorXd& d, StepSystem<K>& system)
{
    constexpr int n = K::unknowns;
    gather_contact_forces(system);
    gather_applied_forces(d, system);
    add_bar_forces(d, system.end_share, system.blocks, system.bars, system.contact_force, system.load);
    std::atomic<bool> admissible = true;
    in_parallel(system.block_of_row.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t row = first; row < end; ++row) {
            const BlockStep<K>& block = system.blocks[system.block_of_row[row]];
            const typename K::Unknowns unknowns = d.segment<n>(n * row);
            InternalForce<K>& internal = system.internal[row];
            internal = internal_force(block, unknowns);
            if (!internal.admissible) admissible = false;
            auto residual = system.residual.template segment<n>(n * row);
            residual = block.inertia * unknowns + internal.force - block.steady -
                       system.contact_force.template segment<n>(n * row);
            for (int k = 0; k < n; ++k)
                if (block.held[k]) residual[k] = 0;
            system.load[row] = load_of(block, internal, system.load[row]);
        }
    });
    return admissible;
}

namespace
{

/// Held components keep their prescribed value: their rows and columns become those of the identity.
template <class K>
void hold_components(StepSystem<K>& system)
{
    constexpr int n = K::unknowns;
    using Block = Eigen::Map<typename K::Square>;
    solve::BlockMatrix& matrix = system.matrix;
    for (int row = 0; row < matrix.rows(); ++row) {
        const auto& held = system.blocks[system.block_of_row[row]].held;
        for (int p = matrix.row_start[row]; p < matrix.row_start[row + 1]; ++p) {
            const int column = matrix.columns[p];
            const auto& held_column = system.blocks[system.block_of_row[column]].held;
            Block block(matrix.block(p));
            for (int k = 0; k < n; ++k) {
                if (held[k]) block.row(k).setZero();
                if (held_column[k]) block.col(k).setZero();
                if (row == column && held[k]) block(k, k) = 1;
            }
        }
    }
}

}  // namespace

namespace
{

template <class K>
void assemble_contacts(StepSystem<K>& system)
{
    if (system.threads <= 1) {
        for (const PatchStep<K>& patch : system.contacts.patches)
            add_patch_stiffness(patch, patch.row_a, patch.row_b, patch.row_a >= 0, patch.row_b >= 0,
                                system.matrix);
        return;
    }
    system.patches_of_rows.find(system.contacts.patches, system.block_of_row.size());
    in_parallel(system.block_of_row.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row)
            for (const int k : system.patches_of_rows.of(row)) {
                const PatchStep<K>& patch = system.contacts.patches[k];
                add_patch_stiffness(patch, patch.row_a, patch.row_b, patch.row_a == row, patch.row_b == row,
                                    system.matrix);
            }
    });
}

}  // namespace

template <class K>
void assemble_matrix(bool published, int threads, StepSystem<K>& system)
{
    using Block = Eigen::Map<typename K::Square>;
    solve::BlockMatrix& matrix = system.matrix;
    contact_stiffness(published, threads, system.contacts);
    std::atomic<bool> any_held = false;
    in_parallel(system.block_of_row.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row) {
            std::fill(matrix.block(matrix.row_start[row]), matrix.block(matrix.row_start[row + 1]), 0.0);
            const BlockStep<K>& block = system.blocks[system.block_of_row[row]];
            Block(matrix.block(matrix.diagonal(row))) = block.base;
            for (const bool held : block.held)
                if (held) any_held = true;
        }
    });
    assemble_contacts(system);
    for (const Coupling<K>& coupling : system.applied.couplings) {
        const int row = system.blocks[coupling.block].row, column = system.blocks[coupling.other].row;
        if (coupling.mutual && row > column && column >= 0)
            Block(matrix.block(matrix.position(row, column))) -= coupling.matrix;
    }
    add_bar_stiffness(system.blocks, system.bars, matrix);
    if (any_held) hold_components(system);
}

template <class K>
bool solve_direction(const StepControl& control, bool published, double slack, StepSystem<K>& system,
                     StepReport& report)
{
    {
        const PartTimer timer(report.seconds, Part::assembly);
        assemble_matrix(published, control.threads, system);
    }
    const PartTimer timer(report.seconds, Part::linear_solve);
    system.solver->set_tolerance(slack * control.linear_tolerance);
    const solve::LinearReport linear = system.solver->solve(system.matrix, system.residual, system.direction);
    system.direction = -system.direction;
    report.factorisations += linear.factorisations;
    report.linear_iterations += linear.iterations;
    report.factor_entries = linear.factor_entries;
    return linear.solved && system.direction.allFinite();
}

#define VOUSSOIR_INSTANTIATE(K)                                                                                \
    template void assemble_blocks(const Model&, const Stage&, const State&, const ContactSetIn<K::dimension>&, \
                                  double, const std::vector<Jump<K>>&, StepSystem<K>&);                        \
    template void assemble_matrix(bool, int, StepSystem<K>&);                                                  \
    template bool evaluate_residual(const VectorXd&, StepSystem<K>&);                                          \
    template bool solve_direction(const StepControl&, bool, double, StepSystem<K>&, StepReport&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
