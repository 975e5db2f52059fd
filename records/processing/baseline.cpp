// Mean, baseline, taper and end correction.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "records/processing/steps.h"

namespace voussoir::records::processing
{

namespace
{

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// The polynomial that fits the samples best, at the samples: a sum of polynomials that are orthogonal on these
/// very points (the discrete Legendre or Gram polynomials), so that no system of equations is solved.
/// Source: [Forsythe1957]
std::vector<double> fitted_polynomial(const std::vector<double>& samples, int order)
{
    const std::size_t count = samples.size();
    std::vector<double> before(count, 0.0), current(count, 1.0), next(count), fit(count, 0.0), rest = samples;
    const auto x = [&](std::size_t i) { return 2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1; };
    double square_before = 1;
    for (int k = 0; k <= order && k < static_cast<int>(count); ++k) {
        const double square = dot(current, current);
        const double share = dot(rest, current) / square;
        const double back = k > 0 ? square / square_before : 0;
        for (std::size_t i = 0; i < count; ++i) {
            fit[i] += share * current[i];
            rest[i] -= share * current[i];
            next[i] = x(i) * current[i] - back * before[i];  // even and odd in turn: no other term
        }
        before.swap(current);
        current.swap(next);
        square_before = square;
    }
    return fit;
}

void subtract(const std::vector<double>& values, std::vector<double>& samples)
{
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] -= values[i];
}

const char* unit_of_slope(Quantity quantity)
{
    return quantity == Quantity::acceleration ? "m/s3" : quantity == Quantity::velocity ? "m/s2" : "m/s";
}

/// "0.1 m/s2 + 0.02 m/s3 t" of a straight line through its ends.
std::string line_text(const std::vector<double>& fit, const Channel& channel)
{
    const double slope = (fit.back() - fit.front()) / duration_of(channel);
    return figure(fit.front()) + " " + si_unit(channel.quantity) + (slope < 0 ? " - " : " + ") +
           figure(std::abs(slope)) + " " + unit_of_slope(channel.quantity) + " t";
}

std::string largest_text(const std::vector<double>& fit, const Channel& channel)
{
    double largest = 0;
    for (const double value : fit) largest = std::max(largest, std::abs(value));
    return "at most " + figure(largest) + " " + si_unit(channel.quantity);
}

}  // namespace

void apply(const RemoveMean&, const std::string&, ProcessedRecord& record)
{
    std::vector<double> means;
    for (Channel& channel : record.channels) {
        const std::vector<double> fit = fitted_polynomial(channel.samples, 0);
        subtract(fit, channel.samples);
        means.push_back(fit.front());
    }
    record.sentences.push_back("mean removed: " + per_channel(record.channels, means));
}

void apply(const RemoveBaseline& step, const std::string&, ProcessedRecord& record)
{
    std::string sentence = step.order == 1
                               ? "linear baseline removed: "
                               : "polynomial baseline of order " + std::to_string(step.order) + " removed: ";
    for (Channel& channel : record.channels) {
        const std::vector<double> fit = fitted_polynomial(channel.samples, step.order);
        subtract(fit, channel.samples);
        if (&channel != &record.channels.front()) sentence += ", ";
        if (!channel.component.empty()) sentence += channel.component + " ";
        sentence += step.order == 1 ? line_text(fit, channel) : largest_text(fit, channel);
    }
    record.sentences.push_back(sentence);
}

void apply(const Taper& step, const std::string& place, ProcessedRecord& record)
{
    double length = 0;
    for (Channel& channel : record.channels) {
        const double duration = duration_of(channel);
        length = step.seconds ? *step.seconds : *step.fraction * duration;
        if (length > duration / 2)
            throw InputError(place, "a taper of " + figure(length) + " s",
                             "at most half the record's " + figure(duration) + " s");
        const std::size_t last = channel.samples.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const double from_end = static_cast<double>(std::min(i, last - i)) * channel.time_step;
            if (from_end >= length) continue;
            channel.samples[i] *= (1 - std::cos(std::numbers::pi * from_end / length)) / 2;
        }
    }
    record.sentences.push_back("cosine taper of " + figure(length) + " s at each end");
}

/// The added acceleration p + q t solves p T + q T^2/2 = -v(T), p T^2/2 + q T^3/6 = -d(T), as
/// GroundMotion::with_end_correction does.
void apply(const CorrectEnd&, const std::string& place, ProcessedRecord& record)
{
    require_accelerations(record.channels, place, "an end correction");
    std::string sentence = "end correction:";
    for (Channel& channel : record.channels) {
        const GroundMotion motion = to_ground_motion(channel, place);
        const double end = duration_of(channel);
        const double v = motion.residual_velocity(), d = motion.residual_displacement();
        const double constant = (2 * v * end - 6 * d) / (end * end);
        const double slope = (12 * d - 6 * v * end) / (end * end * end);
        for (std::size_t i = 0; i < channel.samples.size(); ++i)
            channel.samples[i] += constant + slope * static_cast<double>(i) * channel.time_step;
        sentence += (&channel == &record.channels.front() ? " " : "; ") + channel.component +
                    (channel.component.empty() ? "" : " ") + figure(constant) + " m/s2" +
                    (slope < 0 ? " - " : " + ") + figure(std::abs(slope)) +
                    " m/s3 t added, so that velocity and displacement end at zero instead of " + figure(v) +
                    " m/s and " + figure(d) + " m";
    }
    record.sentences.push_back(sentence);
}

}  // namespace voussoir::records::processing
