// What the friction bound adds to the tangent of a step: it follows the normal force, and the matrix is not
// symmetric.
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <vector>

#include "libdda/forces/friction_tangent.h"
#include "libdda/problem/step_problem.h"

namespace voussoir::step
{

/// The part of the tangent that is left out while the bound is held: what shear forces gain with mu N, and how
/// those of points that turn round bend. Source: docs/numerics.md 3.
template <class K>
class FrictionCoupling
{
 public:
    /// From the contacts as they were last evaluated, with the exact bound. @returns whether there is anything
    bool gather(const StepProblem<K>& problem);
    /// y += C x, (rows x unknowns) each.
    void add_product(StepProblem<K>& problem, const Eigen::VectorXd& x, Eigen::VectorXd& y);

 private:
    void add_to_free(const StepProblem<K>& problem, int row, const typename K::Unknowns& force,
                     Eigen::VectorXd& y) const;

    using Part = PatchTangent<K>;  // all points of a patch
    std::vector<Part> parts_;
    std::vector<typename K::Unknowns> shears_;  // N, Nm, scratch
    std::vector<int> first_of_patch_;           // (patches + 1) index into parts_
    std::vector<char> has_held_;                // (rows) whether unknowns are held
};

}  // namespace voussoir::step
