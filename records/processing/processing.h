// Processing of records: steps in the order the user gives, each with a sentence on what it did.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "records/record.h"
#include "records/synthetic/matching.h"

namespace voussoir::records::processing
{

/// Keeps the samples nearest to `start` .. `end`, both included.
struct TimeWindow {
    double start = 0;                                      // s, from the first sample
    double end = std::numeric_limits<double>::infinity();  // s; infinity: to the last sample
};

/// Keeps the time in which the joint Arias intensity of all channels (the sum of theirs) grows from one fraction
/// to the other: one window for all.
struct AriasWindow {
    double from = 0.001, to = 0.99;                            // fractions of the intensity
    double lead = 0;                                           // s kept before
    double longest = std::numeric_limits<double>::infinity();  // s, lead included; the end is cut
};

/// Subtracts the mean of the samples, of each channel its own.
struct RemoveMean {
};

/// Subtracts the polynomial in time that fits the samples best (least squares), of each channel its own.
struct RemoveBaseline {
    int order = 1;  // 0 to 6; 1 is a straight line
};

/// Multiplies both ends by half a cosine wave, from zero at the outermost sample. One of the two is given.
struct Taper {
    std::optional<double> seconds = {};   // of each end
    std::optional<double> fraction = {};  // of the duration, each end; at most 0.5
};

/// Butterworth filter: second-order sections by the bilinear transform, its corners prewarped. A low pass has only
/// `high_corner`, a high pass only `low_corner`, a band pass both (and 2 x order poles).
/// Causal: -3 dB at the corners, starting from rest. Zero-phase: forward and backward, so -6 dB at the corners and
/// twice the steepness; each end is extended by its last sample, fading to zero by half a cosine wave over
/// 1.5 order / corner seconds, so that ends do not ring, and cut again.
struct Butterworth {
    int order = 4;                           // 1 to 10
    std::optional<double> low_corner = {};   // Hz
    std::optional<double> high_corner = {};  // Hz
    bool zero_phase = true;                  // else causal
};

/// Another time step. Coarser: band-limited by a Fourier transform, zero phase, passing all below 0.8 of half the
/// new sampling rate and nothing above it. Finer: on the motion the engine uses (straight lines between samples of
/// acceleration and velocity, its cubics between those of displacement).
struct Resample {
    double time_step = 0.01;  // s
};

/// Multiplies all channels by one factor.
struct Scale {
    double factor = 1;  // -
};

/// Multiplies all channels by the one factor that brings the peak of `component` (empty: the largest of all
/// channels) to `value`: the peak acceleration or velocity (of the exact integral of an acceleration).
struct ScaleToPeak {
    Quantity peak = Quantity::acceleration;  // or velocity
    double value = 1;                        // m/s2 or m/s, > 0
    std::string component = {};              // as the record names it
};

/// As ScaleToPeak, to a value of the pseudo-acceleration spectrum.
struct ScaleToSpectrum {
    double period = 1;           // s
    double value = 1;            // m/s2, > 0
    double damping = 0.05;       // ratio
    std::string component = {};  // as the record names it
};

/// Turns the two horizontal channels of known azimuth (at any angle of at least 10 deg to each other) to the
/// monument's axes: x at `x_azimuth`, y 90 deg to its left seen from above, z up. The vertical becomes "z".
struct Rotate {
    double x_azimuth = 0;  // deg clockwise from north
};

/// Adds the acceleration, linear in time, that makes velocity and displacement end at zero.
struct CorrectEnd {
};

/// Integrates up to `to`: exactly for an acceleration linear between samples, from rest.
struct Integrate {
    Quantity to = Quantity::velocity;  // or displacement
};

/// Differentiates down to `to` by central differences (second order, one-sided at the ends), once or twice.
struct Differentiate {
    Quantity to = Quantity::acceleration;  // or velocity
};

/// Matches every channel, each by itself, to a target spectrum: see match_spectrum.
struct Match {
    synthetic::TargetSpectrum target = {};   // of all channels
    synthetic::MatchSettings settings = {};  // periods and tolerance
};

/// Any of the steps.
using ProcessingStep =
    std::variant<TimeWindow, AriasWindow, RemoveMean, RemoveBaseline, Taper, Butterworth, Resample, Scale,
                 ScaleToPeak, ScaleToSpectrum, Rotate, CorrectEnd, Integrate, Differentiate, Match>;
/// Steps in their order.
using Processing = std::vector<ProcessingStep>;

/// What came out.
struct ProcessedRecord {
    std::vector<Channel> channels;       // as processed
    std::vector<std::string> sentences;  // what was done: at least one per step, in order
    double start = 0;                    // s, when the first sample now was, from the first that all channels have
    double factor = 1;                   // -, of all steps that scale
    double arias_share = 1;              // -, of the joint Arias intensity that the windows kept
};

/// Runs the steps in their order, and nothing else; but uneven channels are first resampled_evenly and channels
/// that begin at different moments brought into step, which is said.
/// @param channels of one record, with units
/// @throws InputError (place "processing[2]", from 0): first every parameter out of range, before anything runs;
/// then what a step finds wrong with the channels it gets
ProcessedRecord process(const std::vector<Channel>& channels, const Processing& steps);

}  // namespace voussoir::records::processing
