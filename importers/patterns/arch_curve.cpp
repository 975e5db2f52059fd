#include "importers/patterns/arch_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "importers/patterns/parameter_checks.h"

namespace voussoir::importers::patterns
{
namespace
{

constexpr double right_angle = std::numbers::pi / 2;

/// A piece of the left half, from the springing up: a circle by its centre, its radius and two angles above the
/// horizontal through the centre, as seen to the left.
struct Arc {
    Point centre;
    double radius = 0, from = 0, to = 0;
    double length() const { return radius * (to - from); }
    Point normal(double angle) const { return {-std::cos(angle), std::sin(angle)}; }
};

/// A point of the intrados and its outward normal.
struct CurvePoint {
    Point at, normal;
};

std::vector<Arc> left_arcs(const ArchCurve& curve)
{
    const double half = curve.span / 2, rise = curve.rise;
    if (curve.shape == ArchShape::pointed) {
        const double offset = (rise * rise - half * half) / curve.span;
        return {{{offset, 0}, half + offset, 0, std::atan2(rise, offset)}};
    }
    if (curve.shape == ArchShape::polycentric) {
        // Side circles about (-(half - side), 0), a middle one about (0, rise - middle), tangent where the radius
        // leaves the vertical by `beta`.
        const double beta = right_angle - curve.side_arc, s = std::sin(beta), c = std::cos(beta);
        const double det = c * s - (1 - c) * (1 - s);
        const double side = (rise * s - (1 - c) * half) / det, middle = (c * half - (1 - s) * rise) / det;
        return {{{side - half, 0}, side, 0, curve.side_arc},
                {{0, rise - middle}, middle, curve.side_arc, right_angle}};
    }
    const double radius = (half * half + rise * rise) / (2 * rise);
    return {{{0, rise - radius}, radius, right_angle - 2 * std::atan(rise / half), right_angle}};
}

/// The point at a length from the left springing [m].
CurvePoint on_arcs(const std::vector<Arc>& arcs, double length)
{
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        const Arc& arc = arcs[i];
        if (length > arc.length() && i + 1 < arcs.size()) {
            length -= arc.length();
            continue;
        }
        const double angle = arc.from + length / arc.radius;
        return {arc.centre + arc.radius * arc.normal(angle), arc.normal(angle)};
    }
    return {};
}

/// Half an ellipse as a table of lengths by the angle of the auxiliary circle.
class Ellipse
{
 public:
    explicit Ellipse(const ArchCurve& curve) : half_(curve.span / 2), rise_(curve.rise)
    {
        lengths_.push_back(0);
        for (int i = 1; i <= steps; ++i) {  // Simpson's rule in each step
            const double a = angle(i - 1), b = angle(i);
            lengths_.push_back(lengths_.back() + (b - a) / 6 * (speed(a) + 4 * speed((a + b) / 2) + speed(b)));
        }
    }
    double length() const { return lengths_.back(); }
    CurvePoint at(double length) const
    {
        const auto next = std::lower_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
        const auto i = static_cast<int>(next - lengths_.begin());
        double t = angle(i);
        for (int k = 0; k < 20; ++k) {  // Newton, by the length from the step's end
            const double left = angle(i) - t;
            const double arc = left / 6 * (speed(t) + 4 * speed(t + left / 2) + speed(angle(i)));
            t -= ((*next - arc) - length) / speed(t);
        }
        const Point normal(-rise_ * std::cos(t), half_ * std::sin(t));
        return {{-half_ * std::cos(t), rise_ * std::sin(t)}, normal.normalized()};
    }

 private:
    static constexpr int steps = 2000;
    static double angle(int i) { return right_angle * i / steps; }
    double speed(double t) const { return std::hypot(half_ * std::sin(t), rise_ * std::cos(t)); }

    double half_, rise_;
    std::vector<double> lengths_;
};

ArchJoint joint_at(const CurvePoint& point, double thickness)
{
    return {to_nanometre(point.at), to_nanometre(Point(point.at + thickness * point.normal))};
}

ArchJoint mirrored(const ArchJoint& joint)
{
    const auto turned = [](const Point& x) { return Point(0.0 - x.x(), x.y()); };
    return {turned(joint.intrados), turned(joint.extrados)};
}

}  // namespace

void check_curve(const ArchCurve& curve, std::vector<Fault>& faults)
{
    check_positive("span", curve.span, faults);
    check_positive("rise", curve.rise, faults);
    check_positive("thickness", curve.thickness, faults);
    check_number("voussoirs", curve.voussoirs, 2, faults);
    if (!faults.empty()) return;
    const double half = curve.span / 2;
    const std::string rise = std::to_string(curve.rise) + " m";
    if (curve.shape == ArchShape::circular && curve.rise > half * (1 + 1e-9))
        faults.push_back({"rise", rise, "must be at most half the span; a pointed arch rises higher"});
    if (curve.shape == ArchShape::pointed && curve.rise <= half)
        faults.push_back({"rise", rise, "must be more than half the span in a pointed arch"});
    if (curve.shape == ArchShape::polycentric) {
        const std::vector<Arc> arcs = left_arcs(curve);
        if (!(curve.side_arc > 0 && curve.side_arc < right_angle) || curve.rise > half ||
            !(arcs[0].radius > 0 && arcs[1].radius > 0))
            faults.push_back({"rise", rise,
                              "must be less than half the span, and more than the side arcs reach: a polycentric "
                              "arch has three tangent arcs"});
    }
}

std::vector<ArchJoint> joints_of(const ArchCurve& curve)
{
    const std::vector<Arc> arcs = left_arcs(curve);
    const Ellipse ellipse(curve);
    const bool elliptic = curve.shape == ArchShape::elliptic;
    double half_length = elliptic ? ellipse.length() : 0;
    if (!elliptic)
        for (const Arc& arc : arcs) half_length += arc.length();
    const double ends = curve.springing_thickness > 0 ? curve.springing_thickness : curve.thickness;
    std::vector<ArchJoint> joints(curve.voussoirs + 1);
    for (int i = 0; 2 * i <= curve.voussoirs; ++i) {
        const double share = 1 - 2.0 * i / curve.voussoirs;  // 1 at the springing, 0 at the crown
        const double length = half_length * (1 - share);
        const double thickness = curve.thickness + (ends - curve.thickness) * share * share;
        joints[i] = joint_at(elliptic ? ellipse.at(length) : on_arcs(arcs, length), thickness);
        if (i == 0) joints[i].intrados = {to_nanometre(-curve.span / 2), 0};  // exact, whatever the sine gives
        if (2 * i == curve.voussoirs) joints[i] = apex_of(curve);
        joints[curve.voussoirs - i] = mirrored(joints[i]);
    }
    return joints;
}

ArchJoint apex_of(const ArchCurve& curve)
{
    double top = curve.rise + curve.thickness;
    if (curve.shape == ArchShape::pointed) {
        const Arc arc = left_arcs(curve)[0];
        const double outer = arc.radius + curve.thickness;
        top = std::sqrt(outer * outer - arc.centre.x() * arc.centre.x());
    }
    return {{0, to_nanometre(curve.rise)}, {0, to_nanometre(top)}};
}

}  // namespace voussoir::importers::patterns
