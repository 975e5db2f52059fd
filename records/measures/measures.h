// What an earthquake engineer asks of a record, in single figures.
#pragma once

#include <functional>
#include <vector>

#include "records/record.h"
#include "records/units.h"

namespace voussoir::records::measures
{

/// Intensities and durations of an acceleration.
struct Measures {
    double peak_acceleration = 0;                 // m/s2, PGA
    double peak_velocity = 0;                     // m/s, PGV, within the record
    double peak_displacement = 0;                 // m, PGD, within the record
    double arias_intensity = 0;                   // m/s
    double cumulative_velocity = 0;               // m/s, CAV, integral of |a|
    double time_5 = 0, time_75 = 0, time_95 = 0;  // s, when these percentages of Arias intensity have arrived
    double duration_5_75 = 0, duration_5_95 = 0;  // s, significant durations
    double bracketed_duration = 0;     // s, from the first to the last |a| at the threshold; 0: never reached
    double predominant_period = 0;     // s, of the largest 5 % pseudo-acceleration from 0.02 to 10 s
    double mean_period = 0;            // s, Tm of the Fourier amplitudes; 0: none between 0.25 and 20 Hz
    double residual_velocity = 0;      // m/s at the end
    double residual_displacement = 0;  // m at the end
};

/// What measures depend on.
struct MeasureOptions {
    double bracket_threshold = 0.05 * standard_gravity;  // m/s2
    std::function<void(double)> tell = {};  // is told the share of the work that is done, now and then
};

/// Measures of an acceleration that is linear between its samples, as the engine integrates it: integrals are
/// exact, peaks of velocity and displacement those of the quadratics and cubics between the samples, and nothing
/// is removed. Uneven samples are measured as resampled_evenly gives them.
/// @throws InputError when the channel is not an acceleration with a unit
/// Source: [Arias1970], I = pi/(2g) integral a^2 dt; [TrifunacBrady1975], durations; [Bolt1973], bracketed
/// duration; [Rathje1998], mean period
Measures measures_of(const Channel& channel, const MeasureOptions& options = {});

/// Its peak velocity alone [m/s].
double peak_velocity(const Channel& channel);

/// Arias intensity up to each sample of an acceleration. @returns (n) [m/s]
std::vector<double> arias_up_to(const std::vector<double>& samples, double time_step);

/// When `cumulated` (arias_up_to) reaches `value`, exactly within the interval of linear acceleration.
/// @returns [s] from the first sample
double time_of_arias(const std::vector<double>& samples, double time_step, const std::vector<double>& cumulated,
                     double value);

}  // namespace voussoir::records::measures
