#include "importers/patterns/ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace voussoir::importers::patterns
{
namespace
{

constexpr double pi = std::numbers::pi;

/// Cosine and sine, exact at quarter turns.
Point direction(double angle)
{
    const auto cleaned = [](double x) { return std::abs(x) < 1e-15 ? 0.0 : x; };
    return {cleaned(std::cos(angle)), cleaned(std::sin(angle))};
}

}  // namespace

Ring::Ring(int sides, double width, double thickness, double stone)
    : sides_(sides), width_(width), thickness_(thickness)
{
    if (sides == 0) {
        length_ = pi * width;
        per_side_ = std::max(3, static_cast<int>(std::lround(length_ / stone)));
        stone_ = length_ / per_side_;
        return;
    }
    const double tangent = std::tan(pi / sides);
    corner_ = thickness * tangent;
    length_ = sides * width * tangent;
    per_side_ = std::max(1, static_cast<int>(std::lround((side() - 2 * corner_) / stone)));
    stone_ = (side() - 2 * corner_) / per_side_;
}

std::vector<double> Ring::joints(int course) const
{
    std::vector<double> joints;
    if (sides_ == 0) {
        for (int i = 0; i < per_side_; ++i) joints.push_back(stone_ * (i + (course % 2 == 0 ? 0.25 : 0.75)));
        return joints;
    }
    // From corner to corner: a side begins half a side before its middle.
    for (int s = 0; s < sides_; ++s)
        for (int i = 0; i < per_side_; ++i) {
            const double at = (s - 0.5) * side() + corner_ + stone_ * (i + (course % 2 == 0 ? 0.25 : 0.75));
            joints.push_back(at < 0 ? at + length_ : at);
        }
    std::sort(joints.begin(), joints.end());
    return joints;
}

std::vector<Point> Ring::on_side(int side, double from, double to) const
{
    // Along the side from its middle, outward across it.
    const double azimuth = -pi / 2 + 2 * pi * side / sides_, half = this->side() / 2;
    const Point out = direction(azimuth), along(-out.y(), out.x());
    const double apothem = width_ / 2, inner_half = half - corner_;
    const auto point = [&](double u, double r) { return to_nanometre(Point(r * out + u * along)); };
    // At a corner the inner outline turns earlier than the outer one.
    const double inner_from = from <= -half + 1e-9 ? -inner_half : from;
    const double inner_to = to >= half - 1e-9 ? inner_half : to;
    return {point(from, apothem), point(to, apothem), point(inner_to, apothem - thickness_),
            point(inner_from, apothem - thickness_)};
}

std::vector<Point> Ring::on_circle(double from, double to) const
{
    const double outer = width_ / 2, inner = outer - thickness_;
    const auto point = [&](double at, double r) {
        return to_nanometre(Point(r * direction(-pi / 2 + at / outer)));
    };
    return {point(from, outer), point(to, outer), point(to, inner), point(from, inner)};
}

std::vector<std::vector<Point>> Ring::parts(double from, double to) const
{
    std::vector<std::vector<Point>> parts;
    if (sides_ == 0) {
        const int count = std::max(1, static_cast<int>(std::ceil((to - from) / stone_ / 1.2)));
        for (int i = 0; i < count; ++i)
            parts.push_back(on_circle(from + (to - from) * i / count, from + (to - from) * (i + 1) / count));
        return parts;
    }
    const double half = side() / 2;
    for (int s = static_cast<int>(std::floor((from + half) / side() + 1e-12)); s * side() - half < to - 1e-9;
         ++s) {
        const double begin = std::max(from - s * side(), -half), end = std::min(to - s * side(), half);
        if (end - begin > 1e-9) parts.push_back(on_side(s % sides_, begin, end));
    }
    return parts;
}

std::vector<Point> Ring::slab(double projection) const
{
    const int corners = sides_ == 0 ? 2 * per_side_ : sides_;
    const double reach = (width_ / 2 + projection) / std::cos(pi / corners);
    std::vector<Point> outline;
    for (int i = 0; i < corners; ++i)
        outline.push_back(to_nanometre(Point(reach * direction(-pi / 2 + 2 * pi * (i - 0.5) / corners))));
    return outline;
}

}  // namespace voussoir::importers::patterns
