#include "app/studies/verify/references/limit_analysis.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "app/studies/verify/references/linear_program.h"

namespace voussoir::app::studies::verify::references
{
namespace
{

using Eigen::Vector3d;

constexpr double infinite = std::numeric_limits<double>::max();
constexpr double rounding = 1e-12;  // of levers over the size of the scene, and of directions

/// Forces over the whole dead load, levers over the size of the scene.
struct Scale {
    double force = 0, length = 0;
    Vector3d middle = Vector3d::Zero();

    explicit Scale(const LimitProblem& problem)
    {
        for (const LimitBlock& block : problem.blocks) force += block.dead.norm();
        for (const LimitContact& c : problem.contacts)
            middle += c.position / static_cast<double>(problem.contacts.size());
        for (const LimitContact& c : problem.contacts) length = std::max(length, (c.position - middle).norm());
    }
};

Vector3d direction_of_load(const LimitProblem& problem)
{
    Vector3d load = Vector3d::Zero();
    for (const LimitBlock& block : problem.blocks) load += block.live;
    return load;
}

/// Directions in which a contact rubs: the edges of its pyramid.
std::vector<Vector3d> shear_directions(const LimitProblem& problem, const LimitContact& contact,
                                       const Vector3d& load)
{
    if (problem.planar) {
        const Vector3d along = contact.normal.cross(Vector3d::UnitY());
        return {along, -along};
    }
    Vector3d first = load - contact.normal * contact.normal.dot(load);
    if (first.norm() < 1e-6 * load.norm()) first = contact.normal.unitOrthogonal();
    first.normalize();
    const Vector3d second = contact.normal.cross(first);
    std::vector<Vector3d> directions;
    for (int k = 0; k < problem.sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / problem.sides;
        directions.push_back(std::cos(angle) * first + std::sin(angle) * second);
    }
    return directions;
}

/// The variables of a contact and the row that bounds its friction: sum of shears - slope N <= cohesion.
struct ContactColumns {
    int normal = 0, first_shear = 0, friction = 0;
    std::vector<Vector3d> directions;
};

/// Statics with friction by its cone, or as a cohesion that does not depend on the normal force.
enum class Friction { cone, cohesion };

class Statics
{
 public:
    Statics(const LimitProblem& problem, Friction friction) : problem_(problem), scale_(problem)
    {
        add_variables();
        add_equilibrium();
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            ContactColumns& columns = columns_[i];
            LinearProgram::Row row;
            if (friction == Friction::cone) row.push_back({columns.normal, -problem.contacts[i].friction});
            for (std::size_t k = 0; k < columns.directions.size(); ++k)
                row.push_back({columns.first_shear + static_cast<int>(k), 1});
            columns.friction = program_.add_row(row, -infinite, 0);
        }
    }
    void set_cohesion(std::size_t contact, double cohesion)
    {
        program_.set_upper(columns_[contact].friction, cohesion);
    }
    /// Seeks the least sum of weight x normal force under a given factor instead of the greatest factor.
    void seek_least_pressure(double factor, const std::vector<double>& weights)
    {
        program_.set_objective(factor_, 0);
        program_.fix(factor_, factor);
        for (std::size_t i = 0; i < columns_.size(); ++i) program_.set_objective(columns_[i].normal, -weights[i]);
    }
    bool solve() { return program_.maximise(); }
    double factor() const { return program_.value(factor_); }
    /// (contacts) over the scale of forces
    std::vector<double> normal_forces() const
    {
        std::vector<double> forces;
        for (const ContactColumns& columns : columns_) forces.push_back(program_.value(columns.normal));
        return forces;
    }
    double beyond_friction() const
    {
        double worst = 0;
        for (std::size_t i = 0; i < columns_.size(); ++i)
            worst = std::max(
                worst, shear_of(i).norm() - problem_.contacts[i].friction * program_.value(columns_[i].normal));
        return worst;
    }
    LimitState state() const
    {
        LimitState state;
        state.found = true;
        state.factor = factor();
        for (std::size_t i = 0; i < columns_.size(); ++i)
            state.forces.push_back(
                scale_.force * (program_.value(columns_[i].normal) * problem_.contacts[i].normal + shear_of(i)));
        state.beyond_friction = beyond_friction();
        return state;
    }

 private:
    void add_variables()
    {
        factor_ = program_.add_variable(1);
        const Vector3d load = direction_of_load(problem_);
        for (const LimitContact& contact : problem_.contacts) {
            ContactColumns columns;
            columns.directions = shear_directions(problem_, contact, load);
            columns.normal = program_.add_variable(0);
            columns.first_shear = columns.normal + 1;
            for (std::size_t k = 0; k < columns.directions.size(); ++k) program_.add_variable(0);
            columns_.push_back(columns);
        }
    }
    void add_equilibrium()
    {
        std::vector<std::vector<std::size_t>> of_block(problem_.blocks.size());
        for (std::size_t i = 0; i < problem_.contacts.size(); ++i)
            for (const int block : {problem_.contacts[i].block_a, problem_.contacts[i].block_b})
                of_block[static_cast<std::size_t>(block)].push_back(i);
        for (std::size_t b = 0; b < problem_.blocks.size(); ++b) {
            if (problem_.blocks[b].held) continue;
            for (int axis = 0; axis < 3; ++axis) {
                if (!problem_.planar || axis != 1) add_equation(b, of_block[b], axis, false);
                if (!problem_.planar || axis == 1) add_equation(b, of_block[b], axis, true);
            }
        }
    }
    /// Balance of forces along an axis, or of moments about it through the block's centroid.
    void add_equation(std::size_t block, const std::vector<std::size_t>& contacts, int axis, bool moment)
    {
        const LimitBlock& own = problem_.blocks[block];
        LinearProgram::Row row;
        for (const std::size_t i : contacts) {
            const LimitContact& contact = problem_.contacts[i];
            const double sign = contact.block_a == static_cast<int>(block) ? 1 : -1;
            const Vector3d lever = (contact.position - own.centroid) / scale_.length;
            const auto add = [&](int variable, const Vector3d& force) {
                const double part = sign * (moment ? lever.cross(force)[axis] : force[axis]);
                if (std::abs(part) > rounding) row.push_back({variable, part});
            };
            add(columns_[i].normal, contact.normal);
            for (std::size_t k = 0; k < columns_[i].directions.size(); ++k)
                add(columns_[i].first_shear + static_cast<int>(k), columns_[i].directions[k]);
        }
        if (!moment && own.live[axis] != 0) row.push_back({factor_, own.live[axis] / scale_.force});
        const double load = moment ? 0 : -own.dead[axis] / scale_.force;
        program_.add_row(row, load, load);
    }
    Vector3d shear_of(std::size_t contact) const
    {
        Vector3d shear = Vector3d::Zero();
        const ContactColumns& columns = columns_[contact];
        for (std::size_t k = 0; k < columns.directions.size(); ++k)
            shear += program_.value(columns.first_shear + static_cast<int>(k)) * columns.directions[k];
        return shear;
    }
    const LimitProblem& problem_;
    Scale scale_;
    LinearProgram program_;
    std::vector<ContactColumns> columns_;
    int factor_ = 0;
};

/// Normal forces of a random state of equilibrium under a factor; none when it is not found.
std::vector<double> random_normal_forces(const LimitProblem& problem, double factor, std::mt19937_64& random)
{
    std::vector<double> weights(problem.contacts.size());
    for (double& weight : weights) weight = static_cast<double>(random() >> 11) * 0x1p-53;
    Statics statics(problem, Friction::cone);
    statics.seek_least_pressure(factor, weights);
    if (!statics.solve()) return {};
    return statics.normal_forces();
}

/// Iterates from the normal forces `first`. @returns what it converges to, if it does
LimitState slide_without_opening(const LimitProblem& problem, const std::vector<double>& first)
{
    constexpr int most_programs = 300, enough = 5;
    constexpr double same = 1e-6, admissible = 3e-3;  // of the factor; of the dead load, beyond friction
    constexpr double slack = 1e-7;                    // of the dead load: the first forces must not be at the edge
    Statics statics(problem, Friction::cohesion);
    std::vector<double> normal = first;
    double last = 0;
    int quiet = 0, programs = 0;
    while (quiet < enough) {
        if (++programs > most_programs) return {};
        for (std::size_t i = 0; i < normal.size(); ++i)
            statics.set_cohesion(i, problem.contacts[i].friction * normal[i] + slack);
        const bool solved = statics.solve();
        const std::vector<double> next = solved ? statics.normal_forces() : first;  // these bear the dead load
        for (std::size_t i = 0; i < normal.size(); ++i) normal[i] = (normal[i] + next[i]) / 2;
        const bool settled = solved && std::abs(statics.factor() - last) <= same * last;
        quiet = settled && statics.beyond_friction() <= admissible ? quiet + 1 : 0;
        last = solved ? statics.factor() : 0;
    }
    LimitState state = statics.state();
    state.programs = programs;
    return state;
}

}  // namespace

LimitState associated_limit(const LimitProblem& problem)
{
    Statics statics(problem, Friction::cone);
    if (!statics.solve()) return {};
    LimitState state = statics.state();
    state.programs = 1;
    return state;
}

LimitState non_associated_limit(const LimitProblem& problem, int starts)
{
    constexpr double share = 0.8;
    Statics dilating(problem, Friction::cone);
    if (!dilating.solve()) return {};
    std::mt19937_64 random(1);
    LimitState lowest;
    int programs = 1;
    for (int start = 0; start <= starts; ++start) {
        const std::vector<double> first = start == 0
                                              ? dilating.normal_forces()
                                              : random_normal_forces(problem, share * dilating.factor(), random);
        if (first.empty()) continue;
        LimitState state = slide_without_opening(problem, first);
        programs += state.programs + (start > 0);
        if (state.found && (!lowest.found || state.factor < lowest.factor)) lowest = std::move(state);
    }
    lowest.programs = programs;
    return lowest;
}

}  // namespace voussoir::app::studies::verify::references
