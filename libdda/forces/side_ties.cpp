#include "libdda/forces/side_ties.h"

#include "libdda/block/block_face.h"

namespace voussoir::step
{

namespace
{

template <int D>
TieIn<D> tie_in(const Model& model, const SideTie& tie)
{
    const FaceIn<D> face = face_of(model, tie.a, MatrixIn<D>(MatrixIn<D>::Identity()));
    const Eigen::Vector3d period = middle_of<D>(model, tie.b) - middle_of<D>(model, tie.a);
    const VectorIn<D> apart = from_space<D>(Eigen::Vector3d(model.blocks[tie.a.block].moments.centroid + period -
                                                            model.blocks[tie.b.block].moments.centroid));
    const MatrixIn<D> springs = along_and_across<D>(tie.normal, tie.shear, face.normal);
    TieIn<D> result;
    result.block_a = tie.a.block;
    result.block_b = tie.b.block;
    result.period = from_space<D>(period);
    result.points.reserve(face.points.size());
    for (const auto& point : face.points)
        result.points.push_back({point.lever, point.lever + apart, point.weight * springs});
    return result;
}

/// How far a point of side a is from where side b says that it is [m].
template <int D>
VectorIn<D> opening(const TieIn<D>& tie, const typename TieIn<D>::Point& point, const PoseIn<D>& a,
                    const PoseIn<D>& b)
{
    return a.centroid + a.map * point.lever_a + tie.period - b.centroid - b.map * point.lever_b;
}

template <int D>
double energy_of(const Model& model, const State& state)
{
    double energy = 0;
    for (const SideTie& one : model.side_ties) {
        const TieIn<D> tie = tie_in<D>(model, one);
        const auto a = pose_in<D>(model.kinematics, state, one.a.block),
                   b = pose_in<D>(model.kinematics, state, one.b.block);
        for (const auto& point : tie.points) {
            const VectorIn<D> gap = opening<D>(tie, point, a, b);
            energy += 0.5 * gap.dot(point.springs * gap);
        }
    }
    return energy;
}

template <class K>
void add_tie(const TieIn<K::dimension>& tie, double end, const std::vector<BlockStep<K>>& blocks,
             AppliedForces<K>& forces)
{
    using Vector = typename K::Vector;
    const BlockStep<K>&a = blocks[tie.block_a], &b = blocks[tie.block_b];
    AppliedForce<K> on_a, on_b;
    on_a.kind = on_b.kind = AppliedForce<K>::Kind::tie;
    on_a.block = tie.block_a;
    on_b.block = tie.block_b;
    typename K::Square across = K::Square::Zero();
    for (const auto& point : tie.points) {
        const Vector lever_a = a.predicted.map * point.lever_a, lever_b = b.predicted.map * point.lever_b;
        const Vector blended = 0.5 * (1 - end) * opening<K::dimension>(tie, point, a.start, b.start) +
                               0.5 * (1 + end) * opening<K::dimension>(tie, point, a.predicted, b.predicted);
        const Vector pull = -(point.springs * blended);
        const typename K::Matrix springs = 0.5 * (1 + end) * point.springs;
        K::add_force(on_a.constant, lever_a, pull);
        K::add_force(on_b.constant, lever_b, Vector(-pull));
        K::add_stiffness(on_a.resistance, lever_a, lever_a, springs);
        K::add_stiffness(on_b.resistance, lever_b, lever_b, springs);
        K::add_stiffness(across, lever_a, lever_b, springs);
    }
    on_a.coupling = static_cast<int>(forces.couplings.size());
    forces.couplings.push_back({tie.block_a, tie.block_b, true, across});
    on_b.coupling = static_cast<int>(forces.couplings.size());
    forces.couplings.push_back({tie.block_b, tie.block_a, true, across.transpose()});
    forces.own.push_back(on_a);
    forces.own.push_back(on_b);
}

}  // namespace

template <class K>
void add_side_ties(const Model& model, const Stage& stage, const std::vector<BlockStep<K>>& blocks,
                   AppliedForces<K>& forces)
{
    if (model.side_ties.empty()) return;
    forces.end_share = end_share(stage);
    forces.ties.reserve(model.side_ties.size());
    for (const SideTie& one : model.side_ties) {
        forces.ties.push_back(tie_in<K::dimension>(model, one));
        add_tie<K>(forces.ties.back(), forces.end_share, blocks, forces);
    }
}

double side_tie_energy(const Model& model, const State& state)
{
    return is_planar(model.kinematics) ? energy_of<2>(model, state) : energy_of<3>(model, state);
}

template <class K>
void book_side_ties(const State& state, const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& forces,
                    EnergyLedger& energy)
{
    constexpr int D = K::dimension;
    for (const TieIn<D>& tie : forces.ties) {
        const auto a = pose_in<D>(K::kinematics, state, tie.block_a),
                   b = pose_in<D>(K::kinematics, state, tie.block_b);
        for (const auto& point : tie.points) {
            const VectorIn<D> gap = opening<D>(tie, point, a, b);
            const VectorIn<D> change =
                gap - opening<D>(tie, point, blocks[tie.block_a].start, blocks[tie.block_b].start);
            energy.strain += 0.5 * gap.dot(point.springs * gap);
            energy.algorithmic += 0.5 * forces.end_share * change.dot(point.springs * change);
        }
    }
}

#define VOUSSOIR_INSTANTIATE(K)                                                                                   \
    template void add_side_ties(const Model&, const Stage&, const std::vector<BlockStep<K>>&, AppliedForces<K>&); \
    template void book_side_ties(const State&, const std::vector<BlockStep<K>>&, const AppliedForces<K>&,         \
                                 EnergyLedger&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
