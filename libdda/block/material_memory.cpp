#include "libdda/block/material_memory.h"

namespace voussoir::step
{

namespace
{

template <class Matrix>
Matrix strain_in_middle(const BranchStep<Matrix>& branch, const Matrix& change)
{
    return (branch.strain + 0.5 * change) / (1 + branch.half_step);
}

}  // namespace

template <class Matrix>
void begin_memory(const Model& model, const State& state, int block, bool dynamic, double h,
                  const Matrix& start_strain, MemoryStep<Matrix>& memory)
{
    memory.branches.clear();
    memory.blend = 0;
    memory.relaxes = !dynamic;
    if (state.branch_strains.empty()) return;
    memory.steady.setZero();
    int number = 0;
    for (const MaxwellBranch& branch : model.materials[model.blocks[block].material].branches) {
        BranchStep<Matrix> now{branch.share, h / (2 * branch.time), {}};
        now.strain = start_strain - branch_strain_in<Matrix::RowsAtCompileTime>(state, block, number++);
        if (dynamic) {
            const double weight = branch.share / (1 + now.half_step);
            memory.blend += weight;
            memory.steady += weight * now.strain;
        }
        memory.branches.push_back(now);
    }
}

template <class Matrix>
MemoryWork memory_work(const MemoryStep<Matrix>& memory, const Elasticity& elasticity, const Matrix& change)
{
    MemoryWork work;
    for (const BranchStep<Matrix>& branch : memory.branches) {
        const double before = branch.share * elasticity.energy(branch.strain);
        if (memory.relaxes) {
            work.stored -= before;
            work.lost += before;
            continue;
        }
        const Matrix middle = strain_in_middle(branch, change);
        const Matrix end = branch.strain + change - 2 * branch.half_step * middle;
        work.stored += branch.share * elasticity.energy(end) - before;
        work.lost += 4 * branch.half_step * branch.share * elasticity.energy(middle);
    }
    return work;
}

template <class Matrix>
void update_memory(const MemoryStep<Matrix>& memory, const Matrix& start_strain, const Matrix& end_strain,
                   int block, State& state)
{
    int number = 0;
    const Matrix change = end_strain - start_strain;
    for (const BranchStep<Matrix>& branch : memory.branches) {
        auto dashpot = branch_strain_in<Matrix::RowsAtCompileTime>(state, block, number++);
        if (memory.relaxes)
            dashpot = end_strain;
        else
            dashpot += 2 * branch.half_step * strain_in_middle(branch, change);
    }
}

#define VOUSSOIR_INSTANTIATE(M)                                                                          \
    template void begin_memory(const Model&, const State&, int, bool, double, const M&, MemoryStep<M>&); \
    template MemoryWork memory_work(const MemoryStep<M>&, const Elasticity&, const M&);                  \
    template void update_memory(const MemoryStep<M>&, const M&, const M&, int, State&)
VOUSSOIR_INSTANTIATE(Eigen::Matrix2d);
VOUSSOIR_INSTANTIATE(Eigen::Matrix3d);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
