#include "libdda/model/elasticity.h"

namespace voussoir
{

Elasticity elasticity_of(const Model& model, int block)
{
    const BlockMaterial& material = model.materials[model.blocks[block].material];
    Elasticity elasticity;
    elasticity.lambda = material.young * material.poisson / ((1 + material.poisson) * (1 - 2 * material.poisson));
    elasticity.mu = material.young / (2 * (1 + material.poisson));
    elasticity.volume = model.blocks[block].moments.volume;
    if (is_planar(model.kinematics) && model.plane == PlaneCondition::stress)
        elasticity.lambda *= 2 * elasticity.mu / (elasticity.lambda + 2 * elasticity.mu);
    return elasticity;
}

}  // namespace voussoir
