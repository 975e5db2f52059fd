#include "libdda/analysis/mechanism.h"

#include <algorithm>

namespace voussoir
{

namespace
{

constexpr double takes_part = 0.05;  // of the farthest motion of a stone

}  // namespace

Diagnosis mechanism_of(const Model& model, int stage, const std::vector<BlockShift>& gone,
                       const std::vector<BlockShift>& last)
{
    double farthest = 0;
    for (const BlockShift& shift : last) farthest = std::max(farthest, shift.farthest);
    Diagnosis diagnosis{DiagnosisKind::mechanism, stage, {}, {}};
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (last[b].farthest > 0 && last[b].farthest >= takes_part * farthest) diagnosis.blocks.push_back(b);
    std::stable_sort(diagnosis.blocks.begin(), diagnosis.blocks.end(),
                     [&](int one, int other) { return gone[one].farthest > gone[other].farthest; });
    for (const int block : diagnosis.blocks) {
        const Eigen::Vector3d direction = gone[block].centroid.stableNormalized();
        diagnosis.values.insert(diagnosis.values.end(),
                                {gone[block].farthest, direction.x(), direction.y(), direction.z()});
    }
    return diagnosis;
}

}  // namespace voussoir
