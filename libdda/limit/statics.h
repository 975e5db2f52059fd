// The linear program of limit analysis: forces within friction that balance the loads of every block.
#pragma once

#include <vector>

#include "libdda/limit/limit_problem.h"
#include "libdda/limit/linear_program.h"

namespace voussoir::limit
{

/// Friction by its cone, or as a cohesion that does not depend on the normal force.
enum class Friction { cone, cohesion };

/// What the factor multiplies that is made as large as it can be.
enum class Sought {
    live_load,   // beside the dead load, without end
    whole_load,  // the dead load alone, up to the whole of it
};

/// Forces over the whole dead load, levers over the size of the scene.
struct LimitScale {
    double force = 0, length = 0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();

    explicit LimitScale(const LimitProblem& problem);
};

/// Forces of contacts and bars. In space the cone of friction is cut out by planes that touch it where the forces
/// found lie outside of it, until they lie in it to 1e-7 of the dead load.
class Statics
{
 public:
    Statics(const LimitProblem& problem, Friction friction, Sought sought = Sought::live_load);

    /// @param cohesion over the scale of forces
    void set_cohesion(std::size_t contact, double cohesion);
    /// Seeks the least sum of weight x normal force under a given factor instead of the greatest factor.
    void seek_least_pressure(double factor, const std::vector<double>& weights);
    bool solve();

    double factor() const { return program_.value(factor_); }
    /// (contacts) over the scale of forces
    std::vector<double> normal_forces() const;
    /// (contacts) N, on block a
    std::vector<Eigen::Vector3d> forces() const;
    /// Largest |shear| - friction x normal force of a contact, over the scale of forces.
    double beyond_friction() const;
    /// Velocities that the prices of the equations are: how fast a block moves and turns where all take part in
    /// the mechanism that ends the growth of the factor; the work of the loads on it is positive.
    Eigen::Vector3d velocity(std::size_t block) const;
    Eigen::Vector3d spin(std::size_t block) const;
    const LimitScale& scale() const { return scale_; }
    int programs() const { return programs_; }  // linear programs solved so far

 private:
    /// The variables of a contact, and the rows that bound its friction: d . shear - slope p <= cohesion, where
    /// p = N + tension >= 0.
    struct Columns {
        int pressure = 0, shear = 0;  // the first of one or two
        double slope = 0, cohesion = 0;
        Eigen::Vector3d first, second;  // unit, directions of shear
        std::vector<int> facets;
    };
    void add_variables(Sought sought);
    void add_equations(Sought sought);
    void add_equation(std::size_t block, int axis, bool moment, Sought sought);
    void add_facet(Columns& columns, double cosine, double sine);
    bool cut();
    double normal_force(std::size_t contact) const;
    Eigen::Vector3d shear(const Columns& columns) const;

    const LimitProblem& problem_;
    LimitScale scale_;
    LinearProgram program_;
    std::vector<Columns> columns_;
    std::vector<int> bars_;                              // the first of three variables each
    std::vector<std::vector<std::size_t>> contacts_of_;  // (blocks)
    std::vector<std::vector<std::size_t>> bars_of_;      // (blocks)
    std::vector<std::array<int, 6>> equations_;          // (blocks) -1: none
    int factor_ = 0, programs_ = 0;
};

}  // namespace voussoir::limit
