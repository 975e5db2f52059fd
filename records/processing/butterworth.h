// Digital Butterworth filters in second-order sections.
#pragma once

#include <vector>

#include "records/processing/processing.h"

namespace voussoir::records::processing
{

/// (b0 + b1 / z + b2 / z^2) / (1 + a1 / z + a2 / z^2)
struct FilterSection {
    double b0, b1, b2, a1, a2;
};

/// The sections of a filter. Its gain squared at f is 1 / (1 + q^(2 order)), with W = tan(pi f time_step) and, for
/// corners L and H warped alike, q = W / H (low pass), L / W (high pass), (W^2 - L H) / (W (H - L)) (band pass).
/// @param filter corners > 0 and below half the sampling rate; @param time_step [s]
/// Source: [OppenheimSchafer1989], 7.1 (bilinear transform) and app. B
std::vector<FilterSection> butterworth_sections(const Butterworth& filter, double time_step);

/// The samples through one section after the other, from rest.
void run_forward(const std::vector<FilterSection>& sections, std::vector<double>& samples);

/// The filtered samples, as Butterworth says: causal, or forward and backward with extended ends.
std::vector<double> filtered(const Butterworth& filter, double time_step, const std::vector<double>& samples);

/// Seconds by which a zero-phase filter extends each end: 1.5 order / its lowest corner or band width.
double extension_of(const Butterworth& filter);

/// `count` values that lead from `from` to zero by half a cosine wave, neither end included.
std::vector<double> fade_to_zero(double from, std::size_t count);

}  // namespace voussoir::records::processing
