// What the stones beside a face bend and twist by when a step ends.
#include <span>

#include "libdda/forces/contact_step.h"
#include "libdda/model/parallel.h"

namespace voussoir::step
{

namespace
{

/// Twists the stones by the slips, which stay: what the springs have done counts to the twist that was solved for.
template <class K>
void settle_twist(PatchStep<K>& patch, std::span<const PointStep<K::dimension>> points)
{
    YieldIn<1>& twist = patch.stones.twist;
    twist.work = twist.acting().dot(twist.turn());
    if constexpr (contact::twists<K::dimension>) {
        double couple = 0;
        for (const PointStep<K::dimension>& p : points)
            couple +=
                p.shear_stiffness * patch.normal.cross(p.lever - patch.stones.centre).dot(slip_at_end(patch, p));
        twist.moment[0] = couple;
    }
}

}  // namespace

template <class K>
void settle_stones(int threads, ContactStep<K>& step)
{
    if constexpr (K::deformable)
        in_parallel(step.patches.size(), threads, [&](std::size_t first, std::size_t end) {
            for (std::size_t k = first; k < end; ++k) {
                PatchStep<K>& patch = step.patches[k];
                if (!patch.stones.acts) continue;
                patch.stones.bending.work = patch.stones.bending.acting().dot(patch.stones.bending.turn());
                settle_twist<K>(patch, std::span(step.points).subspan(patch.first, patch.count));
            }
        });
}

#define VOUSSOIR_INSTANTIATE(K) template void settle_stones(int, ContactStep<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
