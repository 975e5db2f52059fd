#include "libdda/step/relaxation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "libdda/model/parallel.h"
#include "libdda/step/contact_stiffness.h"
#include "libdda/step/row_moves.h"
#include "libdda/step/step_system.h"

namespace voussoir::step
{

namespace
{

constexpr double worth_relaxing = 0.02;  // of the worst unbalance: blocks with less are left alone
constexpr int newton_iterations = 2;     // of a block in a sweep
constexpr int sweeps_over_all = 2;
constexpr int most_sweeps = 40;
constexpr double few = 0.2;  // of the rows: so many may be due in a sweep beyond those over all
constexpr std::size_t rows_for_threads = 32;
// Few rows are due in most sweeps, and near one another: domains are small, so that they lie in several.
constexpr int rows_in_domain = 32;  // some
constexpr int most_domains = 1024;  // some
constexpr int line_evaluations = 8;
constexpr int bisected = 3;  // every so many of them, where the secant stalls

/// Threads for so many rows: over few of them waiting for one another takes longer than the work.
template <class K>
int threads_for(std::size_t rows, const StepSystem<K>& system)
{
    return rows < rows_for_threads ? 1 : system.threads;
}

}  // namespace

template <class K>
void Relaxation<K>::gather(StepSystem<K>& system)
{
    const std::size_t rows = system.block_of_row.size();
    system.patches_of_rows.find(system.contacts.patches, rows);
    find_tied_rows(system, tied_);
    has_moved_.assign(system.contacts.patches.size(), false);
    if (columns_ != system.matrix.columns || row_start_ != system.matrix.row_start) divide(system.matrix);
    is_ready_ = true;
}

template <class K>
void Relaxation<K>::divide(const solve::BlockMatrix& pattern)
{
    columns_ = pattern.columns;
    row_start_ = pattern.row_start;
    domains_ = solve::divide_into_domains(pattern, rows_in_domain, most_domains);
    inside_.resize(domains_.count);
    border_.resize(domains_.count);
    const int rows = pattern.rows();
    const std::vector<int>& of = domains_.of_row;
    is_at_border_.assign(rows, false);
    turns_.clear();
    if (domains_.count == 1) return;
    const auto for_pairs = [&](auto&& visit) {
        for (int row = 0; row < rows; ++row)
            for (int p = row_start_[row]; p < row_start_[row + 1]; ++p) visit(row, columns_[p]);
    };
    for_pairs([&](int row, int other) {
        if (of[row] != of[other]) is_at_border_[row] = is_at_border_[other] = true;
    });
    // The domains whose border rows touch a row, by being it or by moving it.
    std::vector<std::vector<int>> touched_by(rows);
    const auto touch = [&](int border, int row) {
        if (is_at_border_[border]) touched_by[row].push_back(of[border]);
    };
    for_pairs([&](int row, int other) { touch(row, other), touch(other, row); });
    std::vector<std::vector<char>> meet(domains_.count, std::vector<char>(domains_.count, false));
    for (const std::vector<int>& domains : touched_by)
        for (const int one : domains)
            for (const int other : domains) meet[one][other] = true;
    for (int domain = 0; domain < domains_.count; ++domain) {
        const auto is_free = [&](const std::vector<int>& turn) {
            return std::none_of(turn.begin(), turn.end(), [&](int other) { return meet[domain][other]; });
        };
        auto turn = std::find_if(turns_.begin(), turns_.end(), is_free);
        if (turn == turns_.end()) turn = turns_.insert(turn, std::vector<int>());
        turn->push_back(domain);
    }
}

template <class K>
void Relaxation<K>::share_out()
{
    for (Moves& moves : inside_) moves.due.clear();
    for (Moves& moves : border_) moves.due.clear();
    for (const int row : due_)
        if (!tied_[row]) (is_at_border_[row] ? border_ : inside_)[domains_.of_row[row]].due.push_back(row);
}

template <class K>
template <class Work>
void Relaxation<K>::everywhere(bool back, int threads, const Work& work)
{
    // In most sweeps most domains have nothing to do.
    const auto take = [&](Moves& moves) {
        if (!moves.due.empty() || !moves.patches.empty()) busy_.push_back(&moves);
    };
    const auto side_by_side = [&] {
        each_in_parallel(busy_.size(), threads, [&](std::size_t i) { work(*busy_[i]); });
        busy_.clear();
    };
    const auto inside = [&] {
        for (Moves& moves : inside_) take(moves);
        side_by_side();
    };
    const auto at_borders = [&](const std::vector<int>& turn) {
        for (const int domain : turn) take(border_[domain]);
        side_by_side();
    };
    if (!back) inside();
    if (back)
        std::for_each(turns_.rbegin(), turns_.rend(), at_borders);
    else
        std::for_each(turns_.begin(), turns_.end(), at_borders);
    if (back) inside();
}

template <class K>
typename K::Square Relaxation<K>::tangent_of(int row, const StepSystem<K>& system) const
{
    const BlockStep<K>& block = system.blocks[system.block_of_row[row]];
    typename K::Square tangent = block.base;
    for (const int k : system.patches_of_rows.of(row)) {
        const PatchStep<K>& patch = system.contacts.patches[k];
        add_block_stiffness(patch, system.contacts.points, patch.row_a == row, tangent);
    }
    for (int k = 0; k < K::unknowns; ++k) {
        if (!block.held[k]) continue;
        tangent.row(k).setZero();
        tangent.col(k).setZero();
        tangent(k, k) = 1;
    }
    return tangent;
}

template <class K>
void Relaxation<K>::move(int row, const Unknowns& to, Moves& moves, StepSystem<K>& system)
{
    move_row(row, to, system);
    for (const int k : system.patches_of_rows.of(row)) {
        PatchStep<K>& patch = system.contacts.patches[k];
        if (!has_moved_[k]) moves.patches.push_back(k);
        has_moved_[k] = true;
        add_patch_forces(patch, 1, system);
        evaluate_patch(system.d, FrictionBound::frozen, patch, system.contacts.points);
        add_patch_forces(patch, -1, system);
    }
}

template <class K>
bool Relaxation<K>::is_balanced(int row, double unbalanced, const StepSystem<K>& system) const
{
    constexpr int n = K::unknowns, dimension = K::dimension;
    const double allowed = unbalanced * system.load[row];
    const auto residual = system.residual.template segment<n>(n * row);
    return residual.template head<dimension>().norm() <= allowed &&
           residual.template tail<n - dimension>().norm() <=
               allowed * system.blocks[system.block_of_row[row]].size;
}

template <class K>
void Relaxation<K>::relax(int row, double unbalanced, Moves& moves, StepSystem<K>& system)
{
    constexpr int n = K::unknowns;
    for (int iteration = 0; iteration < newton_iterations; ++iteration) {
        if (is_balanced(row, unbalanced, system)) return;
        const Unknowns residual = system.residual.template segment<n>(n * row);
        const Unknowns from = system.d.template segment<n>(n * row);
        const Unknowns step = -tangent_of(row, system).llt().solve(residual);
        const double slope_0 = residual.dot(step);
        if (!step.allFinite() || !(slope_0 < 0)) return;
        const auto slope_at = [&](double s) {
            move(row, from + s * step, moves, system);
            return system.internal[row].admissible ? system.residual.template segment<n>(n * row).dot(step)
                                                   : std::numeric_limits<double>::infinity();
        };
        double low = 0, slope_low = slope_0, high = 1, slope_high = slope_at(1), s = 1;
        bool is_there = slope_high <= 0.5 * std::abs(slope_0);
        for (int evaluation = 1; evaluation <= line_evaluations && !is_there; ++evaluation) {
            s = evaluation % bisected == 0 || !std::isfinite(slope_high)
                    ? 0.5 * (low + high)
                    : low - slope_low * (high - low) / (slope_high - slope_low);
            const double slope = slope_at(s);
            is_there = std::abs(slope) <= 0.5 * std::abs(slope_0);
            (slope > 0 ? high : low) = s;
            (slope > 0 ? slope_high : slope_low) = slope;
        }
        if (!is_there && s != low) slope_at(low);  // where the potential has only fallen
    }
}

template <class K>
void Relaxation<K>::relax_all(bool back, double unbalanced, Moves& moves, StepSystem<K>& system)
{
    if (back) std::reverse(moves.due.begin(), moves.due.end());
    for (const int row : moves.due) relax(row, unbalanced, moves, system);
}

template <class K>
void Relaxation<K>::follow(Moves& moves, StepSystem<K>& system)
{
    moves.due.clear();
    for (const int k : moves.patches) {
        PatchStep<K>& patch = system.contacts.patches[k];
        add_patch_forces(patch, 1, system);
        follow_bound(patch, system.contacts.points);
        add_patch_forces(patch, -1, system);
        has_moved_[k] = false;
        for (const int row : {patch.row_a, patch.row_b})
            if (row >= 0) moves.due.push_back(row);
    }
    moves.patches.clear();
}

template <class K>
void Relaxation<K>::follow_moves(double unbalanced, StepSystem<K>& system)
{
    everywhere(false, threads_for(due_.size(), system), [&](Moves& moves) { follow(moves, system); });
    is_due_.assign(system.block_of_row.size(), false);
    for (const std::vector<Moves>* all : {&inside_, &border_})
        for (const Moves& moves : *all)
            for (const int row : moves.due) is_due_[row] = !tied_[row];
    in_parallel(is_due_.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t row = first; row < end; ++row)
            if (is_due_[row]) is_due_[row] = !is_balanced(static_cast<int>(row), unbalanced, system);
    });
    due_.clear();
    for (std::size_t row = 0; row < is_due_.size(); ++row)
        if (is_due_[row]) due_.push_back(static_cast<int>(row));
}

template <class K>
void Relaxation<K>::sweep(double tolerance, double worst, StepSystem<K>& system)
{
    const double unbalanced = tolerance * std::max(1.0, worth_relaxing * worst);
    if (!is_ready_) gather(system);
    const std::size_t rows = system.block_of_row.size();
    for (int i = 0; i < most_sweeps; ++i) {
        if (i < sweeps_over_all) {
            due_.resize(rows);
            std::iota(due_.begin(), due_.end(), 0);
        } else if (due_.empty() || static_cast<double>(due_.size()) > few * static_cast<double>(rows)) {
            break;
        }
        share_out();
        const bool back = i % 2 == 1;
        everywhere(back, threads_for(due_.size(), system),
                   [&](Moves& moves) { relax_all(back, unbalanced, moves, system); });
        follow_moves(unbalanced, system);
    }
    evaluate_residual(system.d, system);
}

#define VOUSSOIR_INSTANTIATE(K) template class Relaxation<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
