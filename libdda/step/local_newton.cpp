#include "libdda/step/local_newton.h"

#include <algorithm>
#include <utility>

#include "libdda/model/parallel.h"
#include "libdda/step/contact_stiffness.h"
#include "libdda/step/row_moves.h"
#include "libdda/step/step_system.h"
#include "libdda/step/unbalance.h"

namespace voussoir::step
{

namespace
{

constexpr int most_steps = 4;
constexpr double most_rows = 0.05;      // of all, that may be out of balance
constexpr double out_of_balance = 0.3;  // of the tolerance: who is left with more is moved
constexpr int rings = 2;                // of stones around them
constexpr double linear_tolerance = 1e-2;
constexpr int max_vectors = 60;  // of the Krylov space

}  // namespace

template <class K>
bool LocalNewton<K>::gather(double tolerance, StepSystem<K>& system)
{
    const std::size_t rows = system.block_of_row.size();
    if (!is_ready_) {
        system.patches_of_rows.find(system.contacts.patches, rows);
        find_tied_rows(system, stays_);
        for (std::size_t row = 0; row < rows; ++row)
            for (const bool held : system.blocks[system.block_of_row[row]].held)
                if (held) stays_[row] = true;
        is_ready_ = true;
    }
    rows_.clear();
    place_.assign(rows, -1);
    for (std::size_t row = 0; row < rows; ++row)
        if (!stays_[row] && unbalance_of(row, tolerance, system) > out_of_balance) {
            place_[row] = 0;
            rows_.push_back(static_cast<int>(row));
        }
    if (rows_.empty() || static_cast<double>(rows_.size()) > most_rows * static_cast<double>(rows)) return false;
    for (int ring = 0; ring < rings; ++ring) add_ring(system);
    std::sort(rows_.begin(), rows_.end());
    for (std::size_t i = 0; i < rows_.size(); ++i) place_[rows_[i]] = static_cast<int>(i);
    find_patches(system);
    return true;
}

template <class K>
void LocalNewton<K>::find_patches(const StepSystem<K>& system)
{
    is_marked_.assign(system.contacts.patches.size(), false);
    patches_.clear();
    around_.clear();
    for (const int row : rows_)
        for (const int k : system.patches_of_rows.of(row)) {
            if (is_marked_[k]) continue;
            is_marked_[k] = true;
            patches_.push_back(k);
            for (const int other : {system.contacts.patches[k].row_a, system.contacts.patches[k].row_b})
                if (other >= 0 && place_[other] < 0) around_.push_back(other);
        }
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
}

template <class K>
void LocalNewton<K>::add_ring(const StepSystem<K>& system)
{
    const std::size_t before = rows_.size();
    for (std::size_t i = 0; i < before; ++i)
        for (const int k : system.patches_of_rows.of(rows_[i]))
            for (const int other : {system.contacts.patches[k].row_a, system.contacts.patches[k].row_b})
                if (other >= 0 && place_[other] < 0 && !stays_[other]) {
                    place_[other] = 0;
                    rows_.push_back(other);
                }
}

template <class K>
void LocalNewton<K>::assemble(StepSystem<K>& system)
{
    using Block = Eigen::Map<typename K::Square>;
    std::vector<PatchStep<K>>& patches = system.contacts.patches;
    in_parallel(patches_.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            patch_stiffness(false, 0, system.contacts.points, patches[patches_[i]]);
    });
    const auto place_of = [&](int row) { return row < 0 ? -1 : place_[row]; };
    pairs_.clear();
    left_out_.clear();
    for (const int k : patches_) {
        const int a = place_of(patches[k].row_a), b = place_of(patches[k].row_b);
        if (a >= 0 && b >= 0) pairs_.emplace_back(std::max(a, b), std::min(a, b));
        for (int i = patches[k].first; i < patches[k].first + patches[k].count; ++i) {
            if (!follows_its_bound(system.contacts.points[i])) continue;
            left_out_.push_back(friction_tangent(patches[k], system.contacts.points[i]));
            left_out_.back().row_a = a;
            left_out_.back().row_b = b;
        }
    }
    solve::set_pattern(matrix_, K::unknowns, static_cast<int>(rows_.size()), pairs_);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        Block(matrix_.block(matrix_.diagonal(static_cast<int>(i)))) =
            system.blocks[system.block_of_row[rows_[i]]].base;
    for (const int k : patches_) {
        const PatchStep<K>& patch = patches[k];
        const int a = place_of(patch.row_a), b = place_of(patch.row_b);
        add_patch_stiffness(patch, a, b, a >= 0, b >= 0, matrix_);
    }
}

template <class K>
bool LocalNewton<K>::solve_direction(const StepSystem<K>& system)
{
    using Eigen::VectorXd;
    using Vector = typename K::Vector;
    constexpr int n = K::unknowns;
    if (!solver_) solver_ = solve::make_linear_solver(LinearSolverKind::conjugate_gradients, linear_tolerance);
    if (!solver_->prepare(matrix_)) return false;
    residual_.resize(n * static_cast<Eigen::Index>(rows_.size()));
    from_.resize(residual_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        residual_.segment<n>(n * i) = system.residual.template segment<n>(n * rows_[i]);
        from_.segment<n>(n * i) = system.d.template segment<n>(n * rows_[i]);
    }
    const auto add = [](int place, const Vector& lever, const Vector& f, VectorXd& y) {
        if (place < 0) return;
        typename K::Unknowns force = K::Unknowns::Zero();
        K::add_force(force, lever, f);
        y.segment<n>(n * place) += force;
    };
    const auto multiply = [&](const VectorXd& x, VectorXd& y) {
        solver_->multiply(matrix_, x, y);
        for (const FrictionTangent<K>& p : left_out_) {
            const Vector shear = shear_of(p, x);
            add(p.row_a, p.lever_a, shear, y);
            add(p.row_b, p.lever_b, -shear, y);
        }
    };
    const auto precondition = [&](const VectorXd& r, VectorXd& z) { solver_->precondition(r, z); };
    const solve::Pieces pieces(static_cast<int>(rows_.size()), n, 1);
    gmres_.solve(multiply, precondition, residual_, linear_tolerance, max_vectors, pieces, direction_);
    direction_ = -direction_;
    return direction_.allFinite();
}

template <class K>
bool LocalNewton<K>::move(const Eigen::VectorXd& to, StepSystem<K>& system)
{
    constexpr int n = K::unknowns;
    std::vector<PatchStep<K>>& patches = system.contacts.patches;
    for (const int k : patches_) add_patch_forces(patches[k], 1, system);
    bool is_admissible = true;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        move_row<K>(rows_[i], to.segment<n>(n * i), system);
        if (!system.internal[rows_[i]].admissible) is_admissible = false;
    }
    in_parallel(patches_.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            evaluate_patch(system.d, FrictionBound::exact, patches[patches_[i]], system.contacts.points);
    });
    for (const int k : patches_) add_patch_forces(patches[k], -1, system);
    return is_admissible;
}

template <class K>
double LocalNewton<K>::unbalanced(double tolerance, const StepSystem<K>& system) const
{
    double sum = 0;
    for (const std::vector<int>* rows : {&rows_, &around_})
        for (const int row : *rows) {
            const double ratio = unbalance_of(static_cast<std::size_t>(row), tolerance, system);
            sum += ratio * ratio;
        }
    return sum;
}

template <class K>
bool LocalNewton<K>::improve(double tolerance, StepSystem<K>& system)
{
    if (!is_large(system)) return false;
    int taken = 0;
    bool has_moved = false;
    while (taken < most_steps && gather(tolerance, system)) {
        assemble(system);
        if (!solve_direction(system)) break;
        const double before = unbalanced(tolerance, system);
        has_moved = true;
        if (!move(from_ + direction_, system) || !(unbalanced(tolerance, system) < before)) {
            move(from_, system);
            break;
        }
        ++taken;
    }
    // Loads follow, and of a block that was inverted on the way nothing is left.
    if (has_moved) evaluate_residual(system.d, system);
    return taken > 0;
}

#define VOUSSOIR_INSTANTIATE(K) template class LocalNewton<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
