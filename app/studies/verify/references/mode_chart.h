// First motion of a rigid block on an incline: the chart of its four modes.
#pragma once

namespace voussoir::app::studies::verify::references
{

enum class Mode { stable, sliding, toppling, both };
const char* name_of(Mode mode);

/// The three angles of the chart [rad].
struct ChartPoint {
    double psi = 0;    // of the resultant force from the plane's normal: slope angle, plus beta of the earthquake
    double delta = 0;  // of the block: tan = width along the slope / height
    double phi = 0;    // friction
};

/// Friction angle that just keeps the lower edge of a toppling block from sliding at its first motion.
///
/// The block turns about its lower edge: theta'' = (3 g' / 4R) sin(psi - delta), R half the diagonal. Its centroid
/// accelerates by R theta'' (cos delta downslope, sin delta away from the plane), so the edge must carry
/// T = m g' [sin psi - 3/4 cos delta sin(psi - delta)], N = m g' [cos psi + 3/4 sin delta sin(psi - delta)],
/// and tan phi = T / N. Source: [Yeung1991], the dynamic boundary. @returns [rad]
double dynamic_friction_angle(double psi, double delta);

/// Mode of the first motion from rest. Stable: psi < delta and psi < phi. Sliding: psi > phi and phi < delta (the
/// friction passes inside the base). Toppling: psi > delta and phi above the dynamic boundary. Else both.
/// Source: [Ashby1971], [BrayGoodman1981], [Yeung1991], [YagodaBiranHatzor2013] (psi for alpha)
Mode mode_of(const ChartPoint& point);

/// Whether changing any one of the three angles by up to `angle` [rad] changes the mode.
bool within_of_a_boundary(const ChartPoint& point, double angle);

/// Accelerations of the first motion per unit of force / mass: of the lower edge along the slope, and of rotation
/// times half the diagonal, by solving the equations of the mode. @returns through the arguments [-]
void first_accelerations(const ChartPoint& point, Mode mode, double& slip, double& turn);

}  // namespace voussoir::app::studies::verify::references
