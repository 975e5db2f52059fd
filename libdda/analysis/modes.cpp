#include "libdda/analysis/modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdda/analysis/ground.h"
#include "libdda/analysis/vibration.h"
#include "libdda/model/elasticity.h"
#include "libdda/solve/lowest_modes.h"

namespace voussoir
{

namespace
{

// The search solves for some fifty right-hand sides, each with two operations per entry of the factor and
// triangle.
constexpr double solves_of_a_search = 50;
// Springs at the corners of a rectangle resist its rotation three times as much as springs all over it.
constexpr double corners_to_face = 3;
constexpr double work_of_ordering = 50;  // the unknowns, for each entry of the matrix

/// Twice the strain energies of a mode [J].
struct ModeEnergies {
    double measured = 0, ruled = 0;  // in joints whose stiffness was measured, or follows from a rule
    double dashpots = 0;             // in joints, times their relaxation time
    double stones = 0;               // in the half stones beside the joints, were they strained as the joints are
    double turned_corners = 0;       // in joints that turn on springs at their corners
};

template <class K>
typename K::Vector displacement_at(const Eigen::VectorXd& shape, int row, const typename K::Vector& lever)
{
    if (row < 0) return K::Vector::Zero();
    return K::displacement(shape.segment<K::unknowns>(K::unknowns * row), lever);
}

/// Of block a relative to block b [m].
template <class K>
typename K::Vector moved_apart(const VibratingPoint<K>& p, const Eigen::VectorXd& shape)
{
    return displacement_at<K>(shape, p.row_a, p.lever_a) - displacement_at<K>(shape, p.row_b, p.lever_b);
}

/// By how much the stones beside a face are bent and twisted.
template <class K>
typename BentFace<K>::Turns turns_of(const BentFace<K>& face, const Eigen::VectorXd& shape,
                                     const Vibration<K>& vibration)
{
    typename BentFace<K>::Turns moment = BentFace<K>::Turns::Zero();
    for (int i = face.first; i < face.end; ++i) {
        const VibratingPoint<K>& p = vibration.points[i];
        const typename K::Vector moved = moved_apart(p, shape);
        moment.template head<K::dimension>() += p.normal_stiffness * p.normal.dot(moved) * face.place(p);
        moment[K::dimension] += p.shear_stiffness * face.around(p).dot(moved);
    }
    return -face.give * moment;
}

/// Adds one point. @param moved of its block a relative to b, as its spring feels it [m] @returns its opening [m]
template <class K>
double add_point(const VibratingPoint<K>& p, const typename K::Vector& moved, ModeEnergies& sum)
{
    const double opening = p.normal.dot(moved);
    const double normal = p.normal_stiffness * opening * opening;
    const double shear = p.shear_stiffness * (moved - opening * p.normal).squaredNorm();
    (p.measured ? sum.measured : sum.ruled) += normal + shear;
    sum.dashpots += p.relaxation_time * (normal + shear);
    sum.stones += p.stone_shear * shear;
    return opening;
}

template <class K>
ModeEnergies energies_of(const Eigen::VectorXd& shape, const Vibration<K>& vibration)
{
    ModeEnergies sum;
    const std::vector<VibratingPoint<K>>& points = vibration.points;
    auto bent = vibration.bent.begin();
    for (std::size_t first = 0, end = 0; first < points.size(); first = end) {
        double stiffness = 0, force = 0, twice = 0;
        const bool bends = bent != vibration.bent.end() && bent->first == static_cast<int>(first);
        const BentFace<K> face = bends ? *bent++ : BentFace<K>{};
        const typename BentFace<K>::Turns turns = turns_of(face, shape, vibration);
        for (end = first; end < points.size() && points[end].patch == points[first].patch; ++end) {
            const VibratingPoint<K>& p = points[end];
            typename K::Vector moved = moved_apart(p, shape);
            if (bends)
                moved += turns.template head<K::dimension>().dot(face.place(p)) * p.normal +
                         turns[K::dimension] * face.around(p);
            const double opening = add_point(p, moved, sum);
            stiffness += points[end].normal_stiffness;
            force += points[end].normal_stiffness * opening;
            twice += points[end].normal_stiffness * opening * opening;
        }
        const double uniform = force * force / stiffness;
        const double too_stiff = points[first].at_corners ? corners_to_face : 1;
        sum.stones += points[first].stone_normal * (uniform + too_stiff * (twice - uniform));
        if (points[first].at_corners) sum.turned_corners += twice - uniform;
    }
    return sum;
}

template <class K>
Eigen::Vector3d mass_share_of(const Eigen::VectorXd& shape, const Vibration<K>& vibration)
{
    constexpr int D = K::dimension;
    VectorIn<D> moved = VectorIn<D>::Zero(), whole = VectorIn<D>::Zero();
    for (int row = 0; row < vibration.stiffness.rows(); ++row)
        for (int k = 0; k < D; ++k) {
            const double mass = vibration.translating_mass[row * D + k];
            moved[k] += mass * shape[K::unknowns * row + k];
            whole[k] += mass;
        }
    VectorIn<D> share = VectorIn<D>::Zero();
    for (int k = 0; k < D; ++k)
        if (whole[k] > 0) share[k] = moved[k] * moved[k] / whole[k];
    return to_space(share);
}

/// How much too stiff stones of uniform strain are in a mode, against stones that are strained as their joints
/// are.
double raised_by(double stored_in_stones, double would_be_stored, double joints)
{
    const double softer = joints + std::max(stored_in_stones, would_be_stored);
    return std::sqrt(softer / (joints + stored_in_stones)) - 1;
}

/// By how much joints of a rule lower the frequency, against that of stones and measured joints alone. The joints
/// of rigid stones stand for the elasticity of these: they lower nothing unless they yield more than it would.
/// @param would_be_stored in stones and ground
double lowered_by(const ModeEnergies& twice, double stored_in_stones, double would_be_stored, bool rigid)
{
    const double stones = std::max(stored_in_stones, would_be_stored), real = twice.measured + stones;
    const double computed = twice.measured + twice.ruled + (rigid ? 0 : stones);
    return computed > real ? 1 - std::sqrt(real / computed) : 0;
}

/// What the Rayleigh damping of blocks is to a mode. Joints have none, but their share of the energy counts.
template <class K>
RayleighDamping rayleigh_of(const Model& model, double eigenvalue, const Eigen::VectorXd& shape,
                            const Vibration<K>& vibration)
{
    constexpr int n = K::unknowns;
    RayleighDamping mean;
    for (int row = 0; row < vibration.stiffness.rows(); ++row) {
        const int b = vibration.block_of_row[row];
        const RayleighDamping& own = model.materials[model.blocks[b].material].rayleigh;
        const typename K::Unknowns moved = shape.segment<n>(n * row);
        const Eigen::Map<const typename K::Square> mass(vibration.mass.data() + n * n * row);
        mean.of_mass += own.of_mass * moved.dot(mass * moved);
        if constexpr (K::deformable) {
            const typename K::Matrix l = K::gradient(moved), strain = 0.5 * (l + l.transpose());
            mean.of_stiffness += own.of_stiffness * 2 * elasticity_of(model, b).energy(strain) / eigenvalue;
        }
    }
    return mean;
}

/// What the branches of blocks are to it: their damping ratio at its frequency.
template <class K>
double hysteretic_ratio_of(const Model& model, double eigenvalue, const Eigen::VectorXd& shape,
                           const Vibration<K>& vibration)
{
    constexpr int n = K::unknowns;
    double mean = 0;
    if constexpr (K::deformable) {
        for (int row = 0; row < vibration.stiffness.rows(); ++row) {
            const int b = vibration.block_of_row[row];
            const auto& branches = model.materials[model.blocks[b].material].branches;
            if (branches.empty()) continue;
            const typename K::Matrix l = K::gradient(shape.segment<n>(n * row)),
                                     strain = 0.5 * (l + l.transpose());
            mean += damping_ratio_of(branches, std::sqrt(eigenvalue)) * 2 *
                    elasticity_of(model, b).energy(strain) / eigenvalue;
        }
    }
    return mean;
}

/// Twice what the ground stores in itself.
template <class K>
double stored_in_ground(const Model& model, const Eigen::VectorXd& shape, const Vibration<K>& vibration)
{
    constexpr int n = K::unknowns;
    double stored = 0;
    if constexpr (K::deformable) {
        const std::vector<bool> ground = ground_marks(model);
        for (int row = 0; row < vibration.stiffness.rows(); ++row) {
            const int b = vibration.block_of_row[row];
            if (!ground[b]) continue;
            const typename K::Matrix l = K::gradient(shape.segment<n>(n * row)),
                                     strain = 0.5 * (l + l.transpose());
            stored += 2 * elasticity_of(model, b).energy(strain);
        }
    }
    return stored;
}

/// @param eigenvalue omega^2 of a shape with unit modal mass
template <class K>
NaturalMode mode_of(const Model& model, double eigenvalue, const Eigen::VectorXd& shape,
                    const Vibration<K>& vibration)
{
    NaturalMode mode;
    mode.frequency = std::sqrt(eigenvalue) / (2 * std::numbers::pi);
    mode.mass_share = mass_share_of(shape, vibration);
    const ModeEnergies twice = energies_of(shape, vibration);
    const double joints = twice.measured + twice.ruled;
    mode.joint_share = std::min(1.0, joints / eigenvalue);
    // Stones bend less than a continuum does, and rigid ones not at all: their joints tell what they would store.
    const double stored = K::deformable ? std::max(0.0, eigenvalue - joints) : 0;
    const double would_be_stored = twice.stones + stored_in_ground(model, shape, vibration);
    mode.lowered_by_joints = lowered_by(twice, stored, would_be_stored, !K::deformable);
    if (K::deformable) mode.raised_by_stones = raised_by(stored, would_be_stored, joints);
    mode.raised_by_corners = raised_by(eigenvalue, eigenvalue + (corners_to_face - 1) * twice.turned_corners, 0);
    mode.dashpot_time = twice.dashpots / eigenvalue;
    if (std::any_of(model.materials.begin(), model.materials.end(),
                    [](const auto& m) { return m.rayleigh.any(); }))
        mode.rayleigh = rayleigh_of(model, eigenvalue, shape, vibration);
    if (most_branches(model) > 0) mode.hysteretic = hysteretic_ratio_of(model, eigenvalue, shape, vibration);
    return mode;
}

/// Whether the work of a search is more than allowed. The factor is analysed only if that itself is not.
bool is_too_costly(const solve::BlockMatrix& stiffness, double most_work, solve::CholmodFactor& factor)
{
    const double ordering = work_of_ordering * static_cast<double>(stiffness.values.size());
    if (ordering > most_work) return true;
    const solve::FactorCost cost = factor.analyse(stiffness);
    return ordering + cost.flops + 4 * solves_of_a_search * cost.entries > most_work;
}

template <class K>
NaturalModes modes_about(const Model& model, const State& state, const ModesSearch& search)
{
    NaturalModes found;
    found.rigid = !K::deformable;
    const Vibration<K> vibration = vibration_about<K>(model, state);
    if (vibration.stiffness.rows() == 0) return found;
    solve::CholmodFactor factor;
    if (is_too_costly(vibration.stiffness, search.most_work, factor)) {
        found.outcome = ModesOutcome::too_costly;
        return found;
    }
    solve::LowestModes lowest;
    // Loose stones come first, with frequency 0; what vibrates comes after them.
    for (int wanted = search.count; wanted <= 4 * search.count; wanted += search.count + found.loose) {
        lowest = solve::lowest_modes(vibration.stiffness, vibration.mass, wanted, factor);
        found.loose = static_cast<int>((lowest.eigenvalues.array() == 0).count());
        if (!lowest.converged || wanted - found.loose >= search.count || lowest.eigenvalues.size() < wanted) break;
    }
    if (!lowest.converged) {
        found.outcome = ModesOutcome::failed;
        return found;
    }
    for (auto i = 0; i < lowest.eigenvalues.size() && static_cast<int>(found.modes.size()) < search.count; ++i)
        if (lowest.eigenvalues[i] > 0)
            found.modes.push_back(mode_of<K>(model, lowest.eigenvalues[i], lowest.shapes.col(i), vibration));
    if (!found.modes.empty()) found.outcome = ModesOutcome::found;
    return found;
}

}  // namespace

NaturalModes natural_modes(const Model& model, const State& state, const ModesSearch& search)
{
    switch (model.kinematics) {
        case Kinematics::spatial_rigid:
            return modes_about<step::SpatialRigid>(model, state, search);
        case Kinematics::planar_deformable:
            return modes_about<step::PlanarDeformable>(model, state, search);
        case Kinematics::planar_rigid:
            return modes_about<step::PlanarRigid>(model, state, search);
        case Kinematics::spatial_deformable:
            break;
    }
    return modes_about<step::SpatialDeformable>(model, state, search);
}

}  // namespace voussoir
