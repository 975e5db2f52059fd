#include "libdda/model/friction_law.h"

namespace voussoir
{

FrictionLaw friction_between(const Model& model, int block_a, int block_b, bool has_speeds)
{
    const JointMaterial& joint = model.joint_between(block_a, block_b);
    FrictionLaw law;
    law.factor = model.friction_factor(block_a, block_b);
    law.at_rest = law.factor * friction_coefficient(joint, 0);
    if (has_speeds && !joint.friction_at_speed.empty()) law.joint = &joint;
    return law;
}

}  // namespace voussoir
