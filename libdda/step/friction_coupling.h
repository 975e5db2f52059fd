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
    std::vector<FrictionTangent<K>> points_;
    std::vector<int> first_of_patch_;         // (patches + 1) index into points_
    std::vector<typename K::Vector> shears_;  // N, scratch
    solve::Gmres gmres_;
};

}  // namespace voussoir::step
