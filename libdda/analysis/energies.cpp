#include "libdda/analysis/energies.h"

#include "libdda/contact/find_contacts.h"
#include "libdda/step/block_step.h"

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

Matrix3d rate_of(const Model& model, const State& state, int block)
{
    const double* v = state.velocities.data() + block * unknowns_per_block(model.kinematics);
    if (is_deformable(model.kinematics)) return Matrix3d(v + 3);
    return skew(Vector3d(v + 3)) * pose_of(model.kinematics, state, block).map;
}

Matrix3d density_second(const Model& model, int block)
{
    return model.materials[model.blocks[block].material].density * model.blocks[block].moments.second;
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
        const Matrix3d rate = rate_of(model, state, b);
        twice += (rate * density_second(model, b)).cwiseProduct(rate).sum();
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
        const BlockMaterial& m = model.materials[model.blocks[b].material];
        const Elasticity elasticity{m.young * m.poisson / ((1 + m.poisson) * (1 - 2 * m.poisson)),
                                    m.young / (2 * (1 + m.poisson)), model.blocks[b].moments.volume};
        const Matrix3d map = pose_of(model.kinematics, state, b).map;
        sum += elasticity.energy(0.5 * (map.transpose() * map - Matrix3d::Identity()));
    }
    return sum;
}

EnergyLedger open_ledger(const Model& model, const State& state)
{
    EnergyLedger ledger;
    ledger.kinetic = ledger.start_kinetic = kinetic_energy(model, state);
    ledger.strain = ledger.start_strain = strain_energy(model, state);
    ledger.contact = ledger.start_contact = spring_energy(model, state.patches, state.contact_points);
    return ledger;
}

Vector3d angular_momentum(const Model& model, const State& state, int block)
{
    const Matrix3d map = pose_of(model.kinematics, state, block).map;
    return axial(rate_of(model, state, block) * density_second(model, block) * map.transpose());
}

}  // namespace voussoir
