#include "records/processing/butterworth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace voussoir::records::processing
{

namespace
{

using Complex = std::complex<double>;

/// Poles of the low pass with corner 1, those in the upper half plane and the real one last.
std::vector<Complex> prototype_poles(int order)
{
    std::vector<Complex> poles;
    for (int k = 0; k < order / 2; ++k) {
        const double angle = std::numbers::pi * (2 * k + 1 + order) / (2 * order);
        poles.emplace_back(std::cos(angle), std::sin(angle));
    }
    if (order % 2 == 1) poles.emplace_back(-1, 0);
    return poles;
}

/// z of an s in units in which the bilinear transform is z = (1 + s) / (1 - s).
Complex bilinear(const Complex& s)
{
    return (1.0 + s) / (1.0 - s);
}

/// A section with two poles p and q (conjugates, or both real) and the zeros of `numerator`.
FilterSection section(const FilterSection& numerator, const Complex& p, const Complex& q)
{
    return {numerator.b0, numerator.b1, numerator.b2, -(p + q).real(), (p * q).real()};
}

/// Divides by the gain at z, so that the gain there is 1.
void normalise(FilterSection& section, const Complex& z)
{
    const Complex top = section.b0 + section.b1 / z + section.b2 / (z * z);
    const double gain = std::abs(top / (1.0 + section.a1 / z + section.a2 / (z * z)));
    section.b0 /= gain;
    section.b1 /= gain;
    section.b2 /= gain;
}

/// Low pass (all zeros at z = -1) or high pass (all at z = 1, poles at corner / pole).
std::vector<FilterSection> one_sided_sections(int order, double corner, bool low_pass)
{
    const double sign = low_pass ? 1 : -1;
    std::vector<FilterSection> sections;
    for (const Complex& pole : prototype_poles(order)) {
        const Complex z = bilinear(low_pass ? pole * corner : corner / pole);
        if (pole.imag() == 0)
            sections.push_back({1, sign, 0, -z.real(), 0});
        else
            sections.push_back(section({1, 2 * sign, 1, 0, 0}, z, std::conj(z)));
        normalise(sections.back(), sign);
    }
    return sections;
}

/// Each pole p of the prototype gives two, the roots of s^2 - p width s + low high = 0.
std::vector<FilterSection> band_sections(int order, double low, double high)
{
    const double width = high - low, centre = std::sqrt(low * high);
    const FilterSection numerator{1, 0, -1, 0, 0};
    std::vector<FilterSection> sections;
    for (const Complex& pole : prototype_poles(order)) {
        const Complex half = pole * width / 2.0, root = std::sqrt(half * half - low * high);
        const Complex p = bilinear(half + root), q = bilinear(half - root);
        if (pole.imag() == 0) {
            sections.push_back(section(numerator, p, q));
        } else {
            sections.push_back(section(numerator, p, std::conj(p)));
            sections.push_back(section(numerator, q, std::conj(q)));
        }
    }
    for (FilterSection& each : sections) normalise(each, bilinear({0, centre}));
    return sections;
}

}  // namespace

std::vector<FilterSection> butterworth_sections(const Butterworth& filter, double time_step)
{
    const auto warped = [&](double corner) { return std::tan(std::numbers::pi * corner * time_step); };
    if (filter.low_corner && filter.high_corner)
        return band_sections(filter.order, warped(*filter.low_corner), warped(*filter.high_corner));
    if (filter.low_corner) return one_sided_sections(filter.order, warped(*filter.low_corner), false);
    return one_sided_sections(filter.order, warped(*filter.high_corner), true);
}

void run_forward(const std::vector<FilterSection>& sections, std::vector<double>& samples)
{
    for (const FilterSection& s : sections) {
        double first = 0, second = 0;  // transposed direct form II
        for (double& sample : samples) {
            const double out = s.b0 * sample + first;
            first = s.b1 * sample - s.a1 * out + second;
            second = s.b2 * sample - s.a2 * out;
            sample = out;
        }
    }
}

double extension_of(const Butterworth& filter)
{
    double slowest = filter.low_corner ? *filter.low_corner : *filter.high_corner;
    if (filter.low_corner && filter.high_corner)
        slowest = std::min(slowest, *filter.high_corner - *filter.low_corner);
    return 1.5 * filter.order / slowest;
}

std::vector<double> fade_to_zero(double from, std::size_t count)
{
    std::vector<double> fade(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(count + 1);
        fade[i] = from * (1 + std::cos(std::numbers::pi * share)) / 2;
    }
    return fade;
}

std::vector<double> filtered(const Butterworth& filter, double time_step, const std::vector<double>& samples)
{
    const std::vector<FilterSection> sections = butterworth_sections(filter, time_step);
    if (!filter.zero_phase) {
        std::vector<double> result = samples;
        run_forward(sections, result);
        return result;
    }
    const auto count = static_cast<std::size_t>(std::ceil(extension_of(filter) / time_step));
    std::vector<double> extended = fade_to_zero(samples.front(), count);
    std::reverse(extended.begin(), extended.end());
    extended.insert(extended.end(), samples.begin(), samples.end());
    const std::vector<double> after = fade_to_zero(samples.back(), count);
    extended.insert(extended.end(), after.begin(), after.end());
    run_forward(sections, extended);
    std::reverse(extended.begin(), extended.end());
    run_forward(sections, extended);
    std::reverse(extended.begin(), extended.end());
    const auto begin = extended.begin() + static_cast<std::ptrdiff_t>(count);
    return {begin, begin + static_cast<std::ptrdiff_t>(samples.size())};
}

}  // namespace voussoir::records::processing
