// The filter step.

#include "records/processing/butterworth.h"
#include "records/processing/steps.h"

namespace voussoir::records::processing
{

namespace
{

void require_corners(const Butterworth& step, const Channel& channel, const std::string& place)
{
    const double highest = step.high_corner ? *step.high_corner : *step.low_corner;
    const double nyquist = 0.5 / channel.time_step;
    if (highest >= nyquist)
        throw InputError(place, "a corner at " + figure(highest) + " Hz",
                         "below half the sampling rate, " + figure(nyquist) + " Hz");
    // Beyond this a record says nothing, and the ends of a zero-phase filter would be extended without bound.
    const double longest = 100 * step.order * duration_of(channel);
    if (extension_of(step) > longest)
        throw InputError(place,
                         "a corner or band of " + figure(1.5 * step.order / extension_of(step)) + " Hz for " +
                             figure(duration_of(channel)) + " s of record",
                         "at least " + figure(1.5 * step.order / longest) + " Hz");
}

std::string band_text(const Butterworth& step)
{
    if (step.low_corner && step.high_corner)
        return "band pass, " + figure(*step.low_corner) + " to " + figure(*step.high_corner) + " Hz";
    if (step.low_corner) return "high pass, " + figure(*step.low_corner) + " Hz";
    return "low pass, " + figure(*step.high_corner) + " Hz";
}

}  // namespace

void apply(const Butterworth& step, const std::string& place, ProcessedRecord& record)
{
    for (const Channel& channel : record.channels) require_corners(step, channel, place);
    for (Channel& channel : record.channels) channel.samples = filtered(step, channel.time_step, channel.samples);
    std::string sentence = "Butterworth " + band_text(step) + ", order " + std::to_string(step.order);
    sentence += step.zero_phase ? ", zero-phase (forward and backward, -6 dB at a corner; ends extended by " +
                                      figure(extension_of(step)) + " s of fading, then removed)"
                                : ", causal (-3 dB at a corner)";
    record.sentences.push_back(sentence);
}

}  // namespace voussoir::records::processing
