#include "app/results/friction_use.h"

#include <algorithm>

namespace voussoir::app::results
{

std::optional<double> friction_use(const JointBound& bound, bool bonded, const JointNow& now)
{
    if (!(now.area_in_use > 0)) return std::nullopt;
    const bool holds = bonded && !now.broken;
    // A bond also carries tension, which lowers what is left for shear.
    const double normal = holds ? now.normal_force : std::max(0.0, now.normal_force);
    const double most = bound.friction * normal + (holds ? bound.cohesion * now.area_in_use : 0);
    if (!(most > 0)) return std::nullopt;
    return std::min(1.0, now.shear_force / most);
}

}  // namespace voussoir::app::results
