// Smooth pieces of a motion, each integrated to a stated tolerance and ended at an event.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace voussoir::app::studies::verify::references
{

/// y' = f(t, y), smooth until the event.
using Derivative = std::function<Eigen::VectorXd(double, const Eigen::VectorXd&)>;
/// The piece ends where this falls through zero.
using Event = std::function<double(double, const Eigen::VectorXd&)>;

struct OdePoint {
    double time = 0;
    Eigen::VectorXd y;
    double next_step = 0;  // s, what the error control would try next; 0: unknown
};

/// Dormand-Prince 5(4) with local extrapolation, every step's error estimate below `tolerance` x (1 + |y|) per
/// component. Ends at `end`, or earlier where `event` falls from positive to zero, located to the last bits by
/// repeating the last step with a shorter length.
/// @returns whether the event ended it
/// Source: [DormandPrince1980]
bool integrate(const Derivative& f, double end, double tolerance, const Event& event, OdePoint& point);

}  // namespace voussoir::app::studies::verify::references
