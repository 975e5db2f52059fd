#include "libdda/analysis/energies.h"

#include "libdda/block/block_step.h"
#include "libdda/contact/find_contacts.h"
#include "libdda/forces/bar_law.h"
#include "libdda/forces/side_ties.h"

namespace voussoir
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{

const Foundation* foundation_of(const Model& model, int block)
{
    for (const Foundation& foundation : model.foundations)
        if (foundation.block == block) return &foundation;
    return nullptr;
}

}  // namespace

double kinetic_energy(const Model& model, const State& state)
{
    double twice = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        const Foundation* foundation = foundation_of(model, b);
        const Vector3d v = velocity_of(model.kinematics, state, b);
        for (int k = 0; k < 3; ++k)
            if (!foundation || !foundation->translation_held[k]) twice += model.mass(b) * v[k] * v[k];
        if (foundation && foundation->rotation_held) continue;
        const Matrix3d rate = map_rate_of(model.kinematics, state, b);
        twice += (rate * model.mass_second(b)).cwiseProduct(rate).sum();
    }
    return twice / 2;
}

double strain_energy(const Model& model, const State& state)
{
    if (!is_deformable(model.kinematics)) return 0;
    double sum = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        const Foundation* foundation = foundation_of(model, b);
        if (foundation && foundation->rotation_held) continue;
        const Elasticity elasticity = elasticity_of(model, b);
        const auto add = [&](const auto& strain) {
            sum += elasticity.energy(strain);
            const auto& branches = model.materials[model.blocks[b].material].branches;
            if (!branches.empty()) sum += step::stored_in(branches, state, b, elasticity, strain);
        };
        if (is_planar(model.kinematics))
            add(green_strain_of(pose_in<2>(model.kinematics, state, b).map));
        else
            add(green_strain_of(pose_in<3>(model.kinematics, state, b).map));
    }
    return sum;
}

EnergyLedger open_ledger(const Model& model, const State& state)
{
    EnergyLedger ledger;
    ledger.kinetic = ledger.start_kinetic = kinetic_energy(model, state);
    ledger.strain = ledger.start_strain =
        strain_energy(model, state) + step::side_tie_energy(model, state) + step::bars_energy(model, state);
    ledger.contact = ledger.start_contact = is_planar(model.kinematics)
                                                ? contact::spring_energy(model, state.planar_contacts)
                                                : contact::spring_energy(model, state.contacts);
    return ledger;
}

Vector3d angular_momentum(const Model& model, const State& state, int block)
{
    const Matrix3d map = pose_of(model.kinematics, state, block).map;
    return step::axial(
        Matrix3d(map_rate_of(model.kinematics, state, block) * model.mass_second(block) * map.transpose()));
}

}  // namespace voussoir
