// Horizontal components turned to the monument's axes.

#include <cmath>
#include <numbers>

#include "records/processing/steps.h"

namespace voussoir::records::processing
{

namespace
{

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

/// Positions of the two horizontal channels of known azimuth.
std::vector<std::size_t> horizontal_pair(const std::vector<Channel>& channels, const std::string& place)
{
    std::vector<std::size_t> pair;
    std::string found;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const Channel& channel = channels[i];
        found += (found.empty() ? "" : ", ") + channel.component;
        if (channel.is_vertical) {
            found += " vertical";
        } else if (channel.azimuth && std::isfinite(*channel.azimuth)) {
            pair.push_back(i);
            found += " at " + figure(*channel.azimuth) + " deg";
        } else {
            found += " of unknown azimuth";
        }
    }
    if (pair.size() != 2)
        throw InputError(place, "rotation of components " + found,
                         "exactly two horizontal components of known azimuth, and at most a vertical one");
    return pair;
}

void require_rotatable(const Channel& first, const Channel& second, const std::string& place)
{
    require_alike({first, second}, place, true);
    if (first.quantity != second.quantity)
        throw InputError(place, "rotation of two different quantities",
                         "two accelerations, velocities or displacements");
    if (std::abs(std::sin(radians(*second.azimuth - *first.azimuth))) < std::sin(radians(10)))
        throw InputError(
            place,
            "azimuths " + figure(*first.azimuth) + " and " + figure(*second.azimuth) + " deg, nearly parallel",
            "two sensors at least 10 deg apart");
}

/// Degrees by which the sensors miss a right angle.
double skew(const Channel& first, const Channel& second)
{
    return std::asin(std::min(1.0, std::abs(std::cos(radians(*second.azimuth - *first.azimuth))))) * 180 /
           std::numbers::pi;
}

double compass(double degrees)
{
    const double turned = std::fmod(degrees, 360);
    return turned < 0 ? turned + 360 : turned;
}

}  // namespace

/// A sensor at azimuth z reads r = e sin z + n cos z of a motion e to the east and n to the north; two of them
/// give both. Towards azimuth t the motion is e sin t + n cos t, so (r1 sin(z2 - t) + r2 sin(t - z1)) / sin(z2 -
/// z1).
void apply(const Rotate& step, const std::string& place, ProcessedRecord& record)
{
    const std::vector<std::size_t> pair = horizontal_pair(record.channels, place);
    Channel &first = record.channels[pair[0]], &second = record.channels[pair[1]];
    require_rotatable(first, second, place);
    std::string sentence = "components " + first.component + " (" + figure(*first.azimuth) + " deg) and " +
                           second.component + " (" + figure(*second.azimuth) + " deg) rotated to x at azimuth " +
                           figure(compass(step.x_azimuth)) + " deg and y at " +
                           figure(compass(step.x_azimuth - 90)) + " deg";
    if (skew(first, second) > 0.5)
        sentence += "; the sensors are " + figure(skew(first, second)) +
                    " deg off a right angle, which is taken into account";
    const double z1 = radians(*first.azimuth), z2 = radians(*second.azimuth);
    const double x = radians(step.x_azimuth), y = x - std::numbers::pi / 2, angle = std::sin(z2 - z1);
    for (std::size_t i = 0; i < first.samples.size(); ++i) {
        const double r1 = first.samples[i], r2 = second.samples[i];
        first.samples[i] = (r1 * std::sin(z2 - x) + r2 * std::sin(x - z1)) / angle;
        second.samples[i] = (r1 * std::sin(z2 - y) + r2 * std::sin(y - z1)) / angle;
    }
    first.component = "x";
    first.azimuth = compass(step.x_azimuth);
    second.component = "y";
    second.azimuth = compass(step.x_azimuth - 90);
    for (Channel& channel : record.channels)
        if (channel.is_vertical) channel.component = "z";
    record.sentences.push_back(sentence);
}

}  // namespace voussoir::records::processing
