#include "libdda/block/ground_velocity.h"

#include <algorithm>
#include <vector>

namespace voussoir::step
{

using Eigen::Vector3d;

Vector3d ground_velocity(const Model& model, const Stage& stage, double time)
{
    Vector3d velocity = Vector3d::Zero();
    for (int component = 0; component < velocity.size(); ++component) {
        std::vector<const GroundMotion*> different;  // a motion shared by many foundations counts once
        std::size_t moved = 0, held = 0;
        for (const FoundationMotion& motion : stage.motions) {
            if (motion.component != component) continue;
            ++moved;
            if (std::find(different.begin(), different.end(), motion.motion.get()) == different.end())
                different.push_back(motion.motion.get());
        }
        for (const Foundation& foundation : model.foundations) held += foundation.translation_held[component];
        const std::size_t motions = different.size() + (held > moved);
        for (const GroundMotion* motion : different)
            velocity[component] += motion->velocity(time) / static_cast<double>(motions);
    }
    return velocity;
}

}  // namespace voussoir::step
