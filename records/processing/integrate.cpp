// From acceleration to velocity to displacement, and back.

#include <algorithm>

#include "records/processing/steps.h"
#include "records/units.h"

namespace voussoir::records::processing
{

namespace
{

/// As many times as a quantity has been integrated.
int level(Quantity quantity)
{
    return quantity == Quantity::acceleration ? 0 : quantity == Quantity::velocity ? 1 : 2;
}

/// Velocity (h / 2 (a0 + a1)) and displacement (h v + h^2 / 6 (2 a0 + a1)) of an acceleration linear in between;
/// displacement of a velocity linear in between. As GroundMotion integrates, whose sums carry their rounding.
void integrate(Channel& channel, Quantity to, const std::string& place)
{
    const GroundMotion motion = to_ground_motion(channel, place);
    for (std::size_t i = 0; i < channel.samples.size(); ++i) {
        const double time = static_cast<double>(i) * channel.time_step;
        channel.samples[i] = to == Quantity::velocity ? motion.velocity(time) : motion.displacement(time);
    }
    channel.quantity = to;
}

/// Central differences, and second-order ones at the ends.
std::vector<double> differences(const std::vector<double>& y, double h)
{
    const std::size_t last = y.size() - 1;
    if (last == 1) return {(y[1] - y[0]) / h, (y[1] - y[0]) / h};
    std::vector<double> rate(y.size());
    for (std::size_t i = 1; i < last; ++i) rate[i] = (y[i + 1] - y[i - 1]) / (2 * h);
    rate[0] = (-3 * y[0] + 4 * y[1] - y[2]) / (2 * h);
    rate[last] = (3 * y[last] - 4 * y[last - 1] + y[last - 2]) / (2 * h);
    return rate;
}

}  // namespace

void apply(const Integrate& step, const std::string& place, ProcessedRecord& record)
{
    std::vector<double> ends;
    for (Channel& channel : record.channels) {
        if (level(channel.quantity) >= level(step.to))
            throw InputError(place,
                             "component \"" + channel.component + "\", a " + to_text(channel.quantity) +
                                 ", to be integrated to " + to_text(step.to),
                             "something to integrate");
        integrate(channel, step.to, place);
        ends.push_back(channel.samples.back());
    }
    record.sentences.push_back(std::string("integrated to ") + to_text(step.to) + ", from rest; at the end " +
                               per_channel(record.channels, ends));
}

void apply(const Differentiate& step, const std::string& place, ProcessedRecord& record)
{
    for (Channel& channel : record.channels) {
        if (level(channel.quantity) <= level(step.to))
            throw InputError(place,
                             "component \"" + channel.component + "\", a " + to_text(channel.quantity) +
                                 ", to be differentiated to " + to_text(step.to),
                             "something to differentiate");
        for (int i = level(channel.quantity); i > level(step.to); --i)
            channel.samples = differences(channel.samples, channel.time_step);
        channel.quantity = step.to;
    }
    record.sentences.push_back(std::string("differentiated to ") + to_text(step.to) + " by central differences");
}

}  // namespace voussoir::records::processing
