// One factor for all channels.

#include <algorithm>
#include <cmath>
#include <functional>

#include "records/measures/measures.h"
#include "records/measures/response_spectrum.h"
#include "records/processing/steps.h"

namespace voussoir::records::processing
{

namespace
{

void multiply(double factor, ProcessedRecord& record)
{
    record.factor *= factor;
    for (Channel& channel : record.channels)
        for (double& sample : channel.samples) sample *= factor;
}

struct Largest {
    double value = 0;
    std::string component;
};

/// The measure of the channel of that name, or the largest of all.
Largest measured(const std::vector<Channel>& channels, const std::string& component, const std::string& place,
                 const std::function<double(const Channel&)>& measure)
{
    Largest largest;
    bool is_found = false;
    std::string names;
    for (const Channel& channel : channels) {
        names += (names.empty() ? "" : ", ") + channel.component;
        if (!component.empty() && channel.component != component) continue;
        is_found = true;
        const double value = measure(channel);
        if (value > largest.value) largest = {value, channel.component};
    }
    if (!is_found) throw InputError(place, "component \"" + component + "\"", "one of the record's: " + names);
    if (!(largest.value > 0))
        throw InputError(place, "a record without motion", "a record that can be scaled to a value");
    return largest;
}

void scale_to(double value, const Largest& largest, const std::string& what, ProcessedRecord& record)
{
    const double factor = value / largest.value;
    multiply(factor, record);
    record.sentences.push_back("all components scaled by " + figure(factor) + ": " + what + " of " +
                               (largest.component.empty() ? "the record" : largest.component) + " from " +
                               figure(largest.value) + " to " + figure(value));
}

}  // namespace

void apply(const Scale& step, const std::string&, ProcessedRecord& record)
{
    multiply(step.factor, record);
    record.sentences.push_back("all components scaled by " + figure(step.factor));
}

void apply(const ScaleToPeak& step, const std::string& place, ProcessedRecord& record)
{
    const bool to_velocity = step.peak == Quantity::velocity;
    const auto measure = [&](const Channel& channel) {
        if (channel.quantity == step.peak) return peak(channel);
        require_accelerations({channel}, place, "scaling to a peak");
        return measures::peak_velocity(channel);
    };
    const Largest largest = measured(record.channels, step.component, place, measure);
    scale_to(step.value, largest, to_velocity ? "peak velocity [m/s]" : "peak acceleration [m/s2]", record);
}

void apply(const ScaleToSpectrum& step, const std::string& place, ProcessedRecord& record)
{
    require_accelerations(record.channels, place, "scaling to a spectral value");
    for (const Channel& channel : record.channels) {
        if (step.period < channel.time_step / 1000)
            throw InputError(place, "period [s] = " + figure(step.period),
                             "at least a thousandth of the time step of " + figure(channel.time_step) + " s");
    }
    const auto measure = [&](const Channel& channel) {
        return measures::response_spectrum(channel, {step.period}, step.damping).pseudo_acceleration.front();
    };
    scale_to(step.value, measured(record.channels, step.component, place, measure),
             figure(100 * step.damping) + " % pseudo-acceleration at " + figure(step.period) + " s [m/s2]",
             record);
}

}  // namespace voussoir::records::processing
