// One component of a ground motion as functions of time that belong together: displacement, velocity,
// acceleration.
#pragma once

#include <string>
#include <vector>

namespace voussoir
{

/// A motion along one axis, starting at rest and at zero displacement at t = 0 (unless given as displacement).
///
/// A sampled acceleration is linear between its samples and is integrated exactly, once: velocity is a quadratic
/// and displacement a cubic in each sample interval, so that the ground is the same whatever the time step and the
/// cuts. A sampled velocity is linear between samples (displacement quadratic). A sampled displacement is a C1
/// cubic (Hermite, central-difference slopes; zero slope at t = 0, from rest), for a jump of velocity would leave
/// an undamped flip in stiff contacts. Before t = 0 the ground rests where it starts. After the last sample the
/// acceleration is zero: the residual velocity goes on. No baseline is touched.
class GroundMotion
{
 public:
    /// @param samples (n >= 2) [m/s2]; @param time_step [s] > 0. @throws InputError on NaN, too few samples, bad
    /// step
    static GroundMotion from_acceleration(std::vector<double> samples, double time_step, std::string source);
    /// @param samples (n >= 2) [m/s]
    static GroundMotion from_velocity(std::vector<double> samples, double time_step, std::string source);
    /// @param samples (n >= 2) [m]
    static GroundMotion from_displacement(std::vector<double> samples, double time_step, std::string source);
    /// a(t) = amplitude sin(2 pi frequency t + phase) from t = 0 to `duration` (zero after), integrated in closed
    /// form from rest. @param amplitude [m/s2]; @param frequency [Hz]; @param phase [rad]; @param duration [s]
    static GroundMotion sine_acceleration(double amplitude, double frequency, double phase, double duration);

    double displacement(double time) const;  // m
    double velocity(double time) const;      // m/s
    double acceleration(double time) const;  // m/s2

    double duration() const;               // s, the time of the last sample, a delay included
    double residual_velocity() const;      // m/s at and after the end
    double residual_displacement() const;  // m at the end
    double peak_acceleration() const;      // m/s2, largest |a| of the samples (of the wave for a sine)
    /// Where it comes from, in words.
    const std::string& source() const { return source_; }

    /// The same motion times `factor`.
    GroundMotion scaled(double factor) const;
    /// The same motion, so much later [s], >= 0: the ground rests until then.
    GroundMotion delayed(double seconds) const;
    /// The same motion after adding the acceleration, linear in time, that makes velocity and displacement end at
    /// zero: only if asked, and reported by the caller.
    /// @throws InputError when the motion was not given as sampled acceleration, or is delayed
    GroundMotion with_end_correction() const;

 private:
    struct Cubic {
        double displacement, velocity, acceleration, jerk;  // at the start of the interval; jerk constant in it
    };
    /// a = amplitude sin(rate t + phase), and what of its integrals does not change with the time.
    struct Sine {
        double amplitude = 0, rate = 0, phase = 0, duration = 0;  // m/s2, rad/s, rad, s
        double velocity_factor = 0, displacement_factor = 0;      // m/s, m
        double cos_phase = 0, sin_phase = 0;
        double last_velocity = 0, last_displacement = 0;  // m/s, m, at `duration`

        void prepare();
        double displacement(double time) const;
        double velocity(double time) const;
        double acceleration(double time) const;
    };
    GroundMotion() = default;
    bool is_sine() const { return intervals_.empty(); }
    Cubic at(double time, double& since) const;

    std::vector<Cubic> intervals_;  // empty for a closed-form sine; the last one holds for all later times
    bool given_as_acceleration_ = false;
    double time_step_ = 0;
    double delay_ = 0;  // s
    double peak_acceleration_ = 0;
    Sine sine_;
    std::string source_;
};

}  // namespace voussoir
