// What the time integration does to a free vibration: the damping that nobody asked for, and the period.
#pragma once

namespace voussoir
{

/// What an integrator does to one mode.
struct IntegratorAccuracy {
    double damping = 0;       // -, share of critical
    double period_error = 0;  // -, > 0: the computed period is too long
};

/// Of a linear mode, exactly, from the eigenvalues of the matrix that takes (q, h v) through a step: no expansion
/// in omega h. For small omega h the damping is end_share x omega h / 4 and the period error (omega h)^2 / 12.
/// Beyond omega h = 4 Newmark's vibration is gone after a step; its damping is then given as 1 or more.
/// @param angle omega h, > 0: of the mode and the time step
/// @param end_share of the end-of-step force in the step: 1 for newmark, `dissipation` for energy_decaying
IntegratorAccuracy integrator_accuracy(double angle, double end_share);

}  // namespace voussoir
