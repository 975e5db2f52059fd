#include "app/studies/converge/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir::app::studies::converge
{
namespace
{

// An order below this extrapolates further than the runs carry; above, it is chance.
constexpr double least_order = 0.5, highest_order = 6;
// Orders of neighbouring triples that differ by more are no order.
constexpr double order_spread = 0.5;
// Cosine between successive differences, taken over all times, above which they keep their direction.
constexpr double same_direction = 0.9;
// Differences below this share of the quantity are rounding.
constexpr double rounding = 1e-10;
// Two extrapolations may agree by luck: the reference is never surer than this share of the last correction.
constexpr double least_uncertainty = 0.1;
// Of the error that the last difference tells of when its order is not known (Roache's factor for two grids).
constexpr double safety_without_order = 3;

/// Three neighbouring runs, coarse to fine.
struct Triple {
    const Sample &coarse, &middle, &fine;
    double coarse_step, middle_step, fine_step;
};

/// What a triple shows: an order, or why there is none.
struct TripleOrder {
    std::optional<double> order;
    std::string why_not;
};

/// The p for which (h1^p - h2^p) / (h2^p - h3^p) equals the ratio of the differences; by bisection.
double order_of(double ratio, const Triple& runs)
{
    const auto left_over = [&](double p) {
        const double h1 = std::pow(runs.coarse_step / runs.middle_step, p);
        const double h3 = std::pow(runs.fine_step / runs.middle_step, p);
        return (h1 - 1) / (1 - h3) - ratio;
    };
    double low = 1e-6, high = 2 * highest_order;
    for (int i = 0; i < std::numeric_limits<double>::digits; ++i) {
        const double middle = (low + high) / 2;
        (left_over(middle) < 0 ? low : high) = middle;
    }
    return high;
}

TripleOrder order_shown_by(const Triple& runs, double resolution)
{
    const Sample first = runs.middle - runs.coarse, second = runs.fine - runs.middle;
    const double before = size_of(first), after = size_of(second);
    if (after <= std::max(resolution, rounding * size_of(runs.fine)))
        return {{}, resolution > 0 ? "the differences are below the resolution" : "the runs agree to rounding"};
    const double cosine = first.cwiseProduct(second).sum() / (first.norm() * second.norm());
    if (cosine < same_direction) return {{}, "the differences change sign"};
    const double order = order_of(before / after, runs);
    if (order < least_order)
        return {{}, before <= after ? "the differences do not decrease" : "the differences hardly decrease"};
    if (order > highest_order)
        return {{}, fmt::format("the differences decrease faster than order {:g}", highest_order)};
    return {order, ""};
}

Sample extrapolated(const Sample& coarse, const Sample& fine, double step_ratio, double order)
{
    return fine + (fine - coarse) / (std::pow(step_ratio, order) - 1);
}

/// Fills in order, reference and uncertainty [unit of the samples] where the runs allow. @returns why they do not
std::string extrapolate(const std::vector<Sample>& samples, const std::vector<double>& steps, double resolution,
                        Estimate& result)
{
    const std::size_t n = samples.size();
    if (n < 3) return "an order requires three runs";
    const auto triple = [&](std::size_t last) -> Triple {
        return {samples[last - 2], samples[last - 1], samples[last],
                steps[last - 2],   steps[last - 1],   steps[last]};
    };
    const TripleOrder finest = order_shown_by(triple(n - 1), resolution);
    if (!finest.order) return finest.why_not;
    const Sample reference =
        extrapolated(samples[n - 2], samples[n - 1], steps[n - 2] / steps[n - 1], *finest.order);
    const double correction = size_of(reference - samples[n - 1]);
    double uncertainty = correction;
    if (n > 3) {
        const TripleOrder before = order_shown_by(triple(n - 2), resolution);
        if (!before.order) return before.why_not;
        if (std::abs(*before.order - *finest.order) > order_spread)
            return fmt::format("the order changes from {:.2f} to {:.2f}", *before.order, *finest.order);
        const Sample other =
            extrapolated(samples[n - 3], samples[n - 2], steps[n - 3] / steps[n - 2], *before.order);
        uncertainty = std::max(size_of(reference - other), least_uncertainty * correction);
    }
    result.order = finest.order;
    result.reference = reference;
    result.uncertainty = uncertainty;
    return {};
}

/// The finest run as reference. No order is known: first order is taken, and a threefold safety.
void take_finest(const std::vector<Sample>& samples, const std::vector<double>& steps, Estimate& result)
{
    result.reference = samples.back();
    const std::size_t n = samples.size();
    result.uncertainty = std::numeric_limits<double>::infinity();
    if (n < 2) return;
    result.uncertainty = safety_without_order * result.differences[n - 2] / (steps[n - 2] / steps[n - 1] - 1);
    if (n > 2) result.uncertainty = std::max(result.uncertainty, result.differences[n - 3]);
}

}  // namespace

double size_of(const Sample& sample)
{
    return sample.size() == 0 ? 0 : sample.colwise().norm().maxCoeff();
}

Estimate estimate(const std::vector<Sample>& samples, const std::vector<double>& steps, double resolution)
{
    Estimate result;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
        result.differences.push_back(size_of(samples[i + 1] - samples[i]));
    result.no_order = extrapolate(samples, steps, resolution, result);
    if (!result.order) take_finest(samples, steps, result);
    result.uncertainty = std::max(result.uncertainty, resolution / 2);
    for (const Sample& sample : samples) result.errors.push_back(size_of(sample - result.reference));

    const double whole = size_of(result.reference);
    result.vanishes = result.order && result.uncertainty >= whole;
    result.scale = result.vanishes ? size_of(samples.back()) : whole;
    if (result.scale == 0) {
        for (const Sample& sample : samples) result.scale = std::max(result.scale, size_of(sample));
        result.vanishes = result.scale > 0;
    }
    const auto share = [&](double size) { return size > 0 ? size / result.scale : 0; };  // 0/0: nothing moves
    result.uncertainty = share(result.uncertainty);
    for (double& error : result.errors) error = share(error);
    for (double& difference : result.differences) difference = share(difference);
    return result;
}

}  // namespace voussoir::app::studies::converge
