// What the friction bound adds to the tangent of a step: it follows the normal force, and the matrix is not
// symmetric.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/model/report.h"
#include "libdda/model/step_control.h"
#include "libdda/solve/gmres.h"
#include "libdda/step/friction_tangent.h"

namespace voussoir::step
{

template <class K>
struct StepSystem;

/// The part of the tangent that is left out while the bound is frozen: what shear forces gain with mu N, and how
/// those of points that turn round bend. Source: docs/numerics.md 3.
template <class K>
class FrictionCoupling
{
 public:
    /// From the contacts as they were last evaluated, with the exact bound. @returns whether there is anything
    bool gather(const StepSystem<K>& system);
    /// y += C x, (rows x unknowns) each.
    void add_product(StepSystem<K>& system, const Eigen::VectorXd& x, Eigen::VectorXd& y);
    /// Solves, as last gathered, (K + C) direction = -residual at the last evaluation, K the stiffness with the
    /// bound frozen. @param tolerance of what is left of the residual, as a share of it
    /// @returns false if there is no solution, or in a scene that is not large none to this tolerance
    bool solve_direction(const StepControl& control, double tolerance, StepSystem<K>& system, StepReport& report);

 private:
    /// @param count_of gives how many parts a patch has; @param make makes them: make(patch, first of them)
    template <class Part, class CountOf, class Make>
    void gather_parts(const StepSystem<K>& system, const CountOf& count_of, const Make& make,
                      std::vector<Part>& parts);
    template <class Part, class Shear>
    void add_parts(const std::vector<Part>& parts, std::vector<Shear>& shears, StepSystem<K>& system,
                   const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
    void add_to_free(const StepSystem<K>& system, int row, const typename K::Unknowns& force,
                     Eigen::VectorXd& y) const;

    // Point by point; in a large scene of rigid blocks patch by patch, which is quicker and rounds in another way.
    bool by_patches_ = false;
    std::vector<FrictionTangent<K>> points_;
    std::vector<typename K::Vector> shears_;  // N, scratch
    std::vector<PatchTangent<K>> patches_;
    std::vector<typename K::Unknowns> patch_shears_;  // N, Nm, scratch
    std::vector<int> first_of_patch_;                 // (patches + 1) index into either
    std::vector<char> has_held_;                      // (rows) whether unknowns are held
    solve::Gmres gmres_;
};

}  // namespace voussoir::step
