#include "libdda/limit/statics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace voussoir::limit
{

namespace
{

using Eigen::Vector3d;

constexpr double infinite = LinearProgram::infinite;
constexpr double rounding = 1e-12;  // of levers over the size of the scene, and of directions
// How far outside of a cone a force is cut off: of its bound, and over the dead load.
constexpr double too_far = 1e-4, outside = 1e-7;
constexpr int first_facets = 8, most_cuts = 60;

Vector3d direction_of_load(const LimitProblem& problem)
{
    Vector3d load = Vector3d::Zero();
    for (const LimitBlock& block : problem.blocks) load += block.live;
    return load;
}

double bounded(double force, double scale)
{
    return std::isfinite(force) ? force / scale : infinite;
}

}  // namespace

LimitScale::LimitScale(const LimitProblem& problem)
{
    for (const LimitBlock& block : problem.blocks) force += block.dead.norm();
    if (force == 0) force = 1;
    for (const LimitBlock& block : problem.blocks)
        middle += block.centroid / static_cast<double>(problem.blocks.size());
    for (const LimitContact& c : problem.contacts) length = std::max(length, (c.position - middle).norm());
    if (length == 0) length = 1;
}

Statics::Statics(const LimitProblem& problem, Friction friction, Sought sought)
    : problem_(problem),
      scale_(problem),
      contacts_of_(problem.blocks.size()),
      bars_of_(problem.blocks.size()),
      equations_(problem.blocks.size(), {-1, -1, -1, -1, -1, -1})
{
    for (std::size_t i = 0; i < problem.contacts.size(); ++i)
        for (const int block : {problem.contacts[i].block_a, problem.contacts[i].block_b})
            contacts_of_[static_cast<std::size_t>(block)].push_back(i);
    for (std::size_t i = 0; i < problem.bars.size(); ++i)
        for (const int block : {problem.bars[i].block_a, problem.bars[i].block_b})
            bars_of_[static_cast<std::size_t>(block)].push_back(i);
    add_variables(sought);
    add_equations(sought);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        Columns& columns = columns_[i];
        const LimitContact& contact = problem.contacts[i];
        columns.slope = friction == Friction::cone ? contact.friction : 0;
        columns.cohesion = (contact.cohesion - columns.slope * contact.tension) / scale_.force;
        const int count = problem.planar ? 2 : first_facets;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            add_facet(columns, problem.planar ? 1 - 2 * k : std::cos(angle), problem.planar ? 0 : std::sin(angle));
        }
    }
}

void Statics::add_variables(Sought sought)
{
    factor_ = program_.add_variable(1, 0, sought == Sought::whole_load ? 1 : infinite);
    const Vector3d load = direction_of_load(problem_);
    for (const LimitContact& contact : problem_.contacts) {
        Columns columns;
        columns.first = load - contact.normal * contact.normal.dot(load);
        if (problem_.planar)
            columns.first = contact.normal.cross(Vector3d::UnitY());
        else if (columns.first.norm() <= 1e-6 * load.norm())
            columns.first = contact.normal.unitOrthogonal();
        columns.first.normalize();
        columns.second = contact.normal.cross(columns.first);
        columns.pressure = program_.add_variable(0);
        columns.shear = program_.add_variable(0, -infinite);
        if (!problem_.planar) program_.add_variable(0, -infinite);
        columns_.push_back(std::move(columns));
    }
    for (const LimitBar& bar : problem_.bars) {
        const double shear = bounded(bar.shear, scale_.force);
        bars_.push_back(
            program_.add_variable(0, -bounded(bar.compression, scale_.force), bounded(bar.tension, scale_.force)));
        for (int k = 0; k < 2; ++k) program_.add_variable(0, -shear, shear);
    }
}

void Statics::add_equations(Sought sought)
{
    for (std::size_t b = 0; b < problem_.blocks.size(); ++b)
        for (int axis = 0; axis < 3; ++axis) {
            if (!problem_.blocks[b].held[static_cast<std::size_t>(axis)] && (!problem_.planar || axis != 1))
                add_equation(b, axis, false, sought);
            if (!problem_.blocks[b].turning_held && (!problem_.planar || axis == 1))
                add_equation(b, axis, true, sought);
        }
}

// Balance of forces along an axis, or of moments about it through the block's centroid.
void Statics::add_equation(std::size_t block, int axis, bool moment, Sought sought)
{
    const LimitBlock& own = problem_.blocks[block];
    LinearProgram::Row row;
    double pull = 0;  // of contacts without pressure, p = 0: their tensile strength
    const auto part_of = [&](bool on_a, const Vector3d& point, const Vector3d& force) {
        const Vector3d lever = (point - own.centroid) / scale_.length;
        const double part = (on_a ? 1 : -1) * (moment ? lever.cross(force)[axis] : force[axis]);
        return std::abs(part) > rounding ? part : 0;
    };
    const auto add = [&](int variable, double part) {
        if (part != 0) row.push_back({variable, part});
    };
    for (const std::size_t i : contacts_of_[block]) {
        const LimitContact& contact = problem_.contacts[i];
        const bool on_a = contact.block_a == static_cast<int>(block);
        const double pressure = part_of(on_a, contact.position, contact.normal);
        add(columns_[i].pressure, pressure);
        pull -= pressure * contact.tension / scale_.force;
        add(columns_[i].shear, part_of(on_a, contact.position, columns_[i].first));
        if (!problem_.planar) add(columns_[i].shear + 1, part_of(on_a, contact.position, columns_[i].second));
    }
    for (const std::size_t i : bars_of_[block]) {
        const LimitBar& bar = problem_.bars[i];
        const bool on_a = bar.block_a == static_cast<int>(block);
        const Vector3d& end = on_a ? bar.end_a : bar.end_b;
        const Vector3d across = bar.axis.unitOrthogonal();
        add(bars_[i], part_of(on_a, end, bar.axis));
        add(bars_[i] + 1, part_of(on_a, end, across));
        add(bars_[i] + 2, part_of(on_a, end, bar.axis.cross(across)));
    }
    const bool whole = sought == Sought::whole_load;
    if (!moment) add(factor_, (whole ? own.dead : own.live)[axis] / scale_.force);
    const double stays = -pull - (moment || whole ? 0 : own.dead[axis] / scale_.force);
    const std::size_t place = static_cast<std::size_t>(axis) + (moment ? 3 : 0);
    equations_[block][place] = program_.add_row(row, stays, stays);
}

void Statics::add_facet(Columns& columns, double cosine, double sine)
{
    LinearProgram::Row row;
    if (std::abs(cosine) > rounding) row.push_back({columns.shear, cosine});
    if (std::abs(sine) > rounding) row.push_back({columns.shear + 1, sine});
    if (columns.slope != 0) row.push_back({columns.pressure, -columns.slope});
    columns.facets.push_back(program_.add_row(row, -infinite, columns.cohesion));
}

void Statics::set_cohesion(std::size_t contact, double cohesion)
{
    columns_[contact].cohesion = cohesion;
    for (const int facet : columns_[contact].facets) program_.set_upper(facet, cohesion);
}

void Statics::seek_least_pressure(double factor, const std::vector<double>& weights)
{
    program_.set_objective(factor_, 0);
    program_.fix(factor_, factor);
    for (std::size_t i = 0; i < columns_.size(); ++i) program_.set_objective(columns_[i].pressure, -weights[i]);
}

bool Statics::solve()
{
    for (int cuts = 0; cuts <= most_cuts; ++cuts) {
        ++programs_;
        if (!program_.maximise()) return false;
        if (problem_.planar || !cut()) return true;
    }
    return false;
}

// Cuts every cone whose force lies outside, there; whether any did.
bool Statics::cut()
{
    std::vector<std::pair<std::size_t, Vector3d>> wrong;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Vector3d force = shear(columns_[i]);
        const double bound = columns_[i].slope * program_.value(columns_[i].pressure) + columns_[i].cohesion;
        if (force.norm() > (1 + too_far) * bound + outside) wrong.emplace_back(i, force.normalized());
    }
    for (const auto& [i, direction] : wrong)
        add_facet(columns_[i], direction.dot(columns_[i].first), direction.dot(columns_[i].second));
    return !wrong.empty();
}

double Statics::normal_force(std::size_t contact) const
{
    return program_.value(columns_[contact].pressure) - problem_.contacts[contact].tension / scale_.force;
}

Vector3d Statics::shear(const Columns& columns) const
{
    Vector3d force = program_.value(columns.shear) * columns.first;
    if (!problem_.planar) force += program_.value(columns.shear + 1) * columns.second;
    return force;
}

std::vector<double> Statics::normal_forces() const
{
    std::vector<double> forces;
    for (std::size_t i = 0; i < columns_.size(); ++i) forces.push_back(normal_force(i));
    return forces;
}

std::vector<Vector3d> Statics::forces() const
{
    std::vector<Vector3d> forces;
    for (std::size_t i = 0; i < columns_.size(); ++i)
        forces.emplace_back(scale_.force * (normal_force(i) * problem_.contacts[i].normal + shear(columns_[i])));
    return forces;
}

double Statics::beyond_friction() const
{
    double worst = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i)
        worst = std::max(worst, shear(columns_[i]).norm() - problem_.contacts[i].friction * normal_force(i));
    return worst;
}

Vector3d Statics::velocity(std::size_t block) const
{
    Vector3d velocity = Vector3d::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (equations_[block][axis] >= 0)
            velocity[static_cast<int>(axis)] = program_.price(equations_[block][axis]);
    return velocity;
}

Vector3d Statics::spin(std::size_t block) const
{
    Vector3d spin = Vector3d::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (equations_[block][axis + 3] >= 0)
            spin[static_cast<int>(axis)] = program_.price(equations_[block][axis + 3]) / scale_.length;
    return spin;
}

}  // namespace voussoir::limit
