#include "app/studies/verify/references/vault_thrust.h"

#include <cmath>
#include <numbers>

namespace voussoir::app::studies::verify::references
{

double dome_thrust(const SphericalShell& shell)
{
    const double cubes = std::pow(shell.radius + shell.thickness, 3) - std::pow(shell.radius, 3);
    const double weight = shell.unit_weight * 2 * std::numbers::pi / 3 * cubes *
                          (std::cos(shell.oculus) - std::cos(shell.springing));
    return weight / std::tan(shell.springing);
}

}  // namespace voussoir::app::studies::verify::references
