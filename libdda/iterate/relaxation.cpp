#include "libdda/iterate/relaxation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <numeric>

#include "libdda/forces/contact_stiffness.h"
#include "libdda/iterate/line_search.h"
#include "libdda/model/parallel.h"
#include "libdda/problem/row_moves.h"
#include "libdda/problem/unbalance.h"

namespace voussoir::step
{

namespace
{

constexpr int newton_steps = 2;     // of a stone in a sweep
constexpr int sweeps_over_all = 2;  // there and back

/// Threads for so many rows: over few of them waiting for one another takes longer than the work.
template <class K>
int threads_for(std::size_t rows, const IterationRules& rules, const StepProblem<K>& problem)
{
    return rows < static_cast<std::size_t>(rules.rows_in_domain) ? 1 : problem.threads;
}

}  // namespace

template <class K>
void Relaxation<K>::gather(const IterationRules& rules, StepProblem<K>& problem)
{
    const std::size_t rows = problem.block_of_row.size();
    problem.patches_of_rows.find(problem.contacts.patches, rows);
    find_tied_rows(problem, tied_);
    has_moved_.assign(problem.contacts.patches.size(), false);
    if (columns_ != problem.matrix.columns || row_start_ != problem.matrix.row_start)
        divide(rules, problem.matrix);
    is_ready_ = true;
}

template <class K>
void Relaxation<K>::divide(const IterationRules& rules, const solve::BlockMatrix& pattern)
{
    columns_ = pattern.columns;
    row_start_ = pattern.row_start;
    domains_ = solve::divide_into_domains(pattern, rules.rows_in_domain, rules.most_domains);
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
typename K::Square Relaxation<K>::tangent_of(int row, const StepProblem<K>& problem) const
{
    const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
    typename K::Square tangent = block.base;
    for (const int k : problem.patches_of_rows.of(row)) {
        const PatchStep<K>& patch = problem.contacts.patches[k];
        add_block_stiffness(patch, problem.contacts.points, patch.row_a == row, tangent);
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
void Relaxation<K>::move(int row, const Unknowns& to, Moves& moves, StepProblem<K>& problem)
{
    move_row(row, to, problem);
    for (const int k : problem.patches_of_rows.of(row)) {
        PatchStep<K>& patch = problem.contacts.patches[k];
        if (!has_moved_[k]) moves.patches.push_back(k);
        has_moved_[k] = true;
        add_patch_forces(patch, 1, problem);
        evaluate_patch(problem.d, patch, problem.contacts.points);
        add_patch_forces(patch, -1, problem);
    }
}

template <class K>
void Relaxation<K>::relax(int row, double unbalanced, const IterationRules& rules, Moves& moves,
                          StepProblem<K>& problem)
{
    constexpr int n = K::unknowns;
    for (int i = 0; i < newton_steps; ++i) {
        if (unbalance_of(row, unbalanced, problem) <= 1) return;
        const Unknowns residual = problem.residual.template segment<n>(n * row);
        const Unknowns from = problem.d.template segment<n>(n * row);
        const Unknowns direction = -tangent_of(row, problem).llt().solve(residual);
        const double slope_0 = residual.dot(direction);
        if (!direction.allFinite() || !(slope_0 < 0)) return;
        const auto slope_at = [&](double s) {
            move(row, from + s * direction, moves, problem);
            return problem.internal[row].admissible ? problem.residual.template segment<n>(n * row).dot(direction)
                                                    : std::numeric_limits<double>::infinity();
        };
        const Reach reach = line_search(slope_0, rules.of_one, slope_at);
        // Left beyond a corner, one stone in a thousand that is pushed deep into another undoes the sweep.
        if (!reach.is_found) slope_at(reach.low);
    }
}

template <class K>
void Relaxation<K>::relax_all(bool back, double unbalanced, const IterationRules& rules, Moves& moves,
                              StepProblem<K>& problem)
{
    if (back) std::reverse(moves.due.begin(), moves.due.end());
    for (const int row : moves.due) relax(row, unbalanced, rules, moves, problem);
}

template <class K>
void Relaxation<K>::note_neighbours(Moves& moves, const StepProblem<K>& problem)
{
    moves.due.clear();
    for (const int k : moves.patches) {
        const PatchStep<K>& patch = problem.contacts.patches[k];
        has_moved_[k] = false;
        for (const int row : {patch.row_a, patch.row_b})
            if (row >= 0) moves.due.push_back(row);
    }
    moves.patches.clear();
}

template <class K>
void Relaxation<K>::find_due(double unbalanced, const StepProblem<K>& problem)
{
    for (std::vector<Moves>* all : {&inside_, &border_})
        for (Moves& moves : *all) note_neighbours(moves, problem);
    is_due_.assign(problem.block_of_row.size(), false);
    for (const std::vector<Moves>* all : {&inside_, &border_})
        for (const Moves& moves : *all)
            for (const int row : moves.due) is_due_[row] = !tied_[row];
    in_parallel(is_due_.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t row = first; row < end; ++row)
            if (is_due_[row]) is_due_[row] = unbalance_of(static_cast<int>(row), unbalanced, problem) > 1;
    });
    due_.clear();
    for (std::size_t row = 0; row < is_due_.size(); ++row)
        if (is_due_[row]) due_.push_back(static_cast<int>(row));
}

template <class K>
void Relaxation<K>::sweep(double tolerance, double worst, const IterationRules& rules, StepProblem<K>& problem)
{
    const double unbalanced = tolerance * std::max(1.0, rules.worth_relaxing * worst);
    if (!is_ready_) gather(rules, problem);
    const std::size_t rows = problem.block_of_row.size();
    const double few = rules.few_stones * static_cast<double>(rows);
    for (int i = 0; i < rules.sweeps; ++i) {
        if (i < sweeps_over_all) {
            due_.resize(rows);
            std::iota(due_.begin(), due_.end(), 0);
        } else if (due_.empty() || static_cast<double>(due_.size()) > few) {
            break;
        }
        share_out();
        const bool back = i % 2 == 1;
        everywhere(back, threads_for(due_.size(), rules, problem),
                   [&](Moves& moves) { relax_all(back, unbalanced, rules, moves, problem); });
        find_due(unbalanced, problem);
    }
    evaluate_residual(problem.d, problem);
}

#define VOUSSOIR_INSTANTIATE(K) template class Relaxation<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
