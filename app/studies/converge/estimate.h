// How far each run of a refinement is from the limit, judged by the runs alone.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace voussoir::app::studies::converge
{

/// What a run gave for one quantity, (components x times): a history, or a single column for a peak or an end
/// value.
using Sample = Eigen::MatrixXd;

/// The largest length of a column: max over time |u|.
double size_of(const Sample& sample);

/// Errors, differences and the uncertainty are shares of `scale`.
struct Estimate {
    std::optional<double> order;      // of the error in the step; none when the runs show none
    std::string no_order;             // why not
    Sample reference;                 // extrapolated with the order, or the finest run
    double uncertainty = 0;           // of the reference; infinite when a single run says nothing about itself
    std::vector<double> errors;       // (runs): distance from the reference
    std::vector<double> differences;  // (runs - 1): between neighbours
    double scale = 0;  // the size of the reference, or where that vanishes of the finest run, or of the largest
    bool vanishes = false;  // the reference cannot be told from zero
};

/// Richardson's extrapolation u* = u_n + (u_n - u_{n-1}) / ((h_{n-1}/h_n)^p - 1) with the order p that the
/// differences of the three finest runs show. It is trusted only where the differences fall, keep their direction,
/// and the three runs before (where there are any) show nearly the same order; its uncertainty is then what those
/// three would have made of it, or with three runs the whole correction. Else the finest run is the reference, and
/// as uncertain as three times the error that the last difference d tells of at first order, d / (h_{n-1}/h_n -
/// 1), and at least as the difference before.
/// @param samples (runs) of equal shape, coarse to fine; at least one
/// @param steps (runs) falling: time steps, or inverse stiffness factors
/// @param resolution [unit of the samples] a sample is known to half of it: smaller differences say nothing
/// Source: [Richardson1911]; [Roache1994] (grid convergence index).
Estimate estimate(const std::vector<Sample>& samples, const std::vector<double>& steps, double resolution = 0);

}  // namespace voussoir::app::studies::converge
