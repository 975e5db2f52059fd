#include "importers/patterns/arch_bridge.h"

#include <array>
#include <cmath>

#include "libdda/errors.h"

namespace voussoir::importers::patterns
{

namespace
{

/// A point of the elevation: x along the span, z up [m].
struct Point {
    double x = 0, z = 0;
};

struct Joint {
    Point intrados, extrados;
};

double to_nanometre(double metres)
{
    return std::round(metres * 1e9) / 1e9 + 0.0;  // + 0.0: no negative zero
}

Point mirrored(const Point& point)
{
    return {0.0 - point.x, point.z};
}

void check(const ArchBridge& bridge)
{
    std::vector<Fault> faults;
    const auto require = [&](bool good, const char* name, double value, const char* expected) {
        if (!good) faults.push_back({name, std::to_string(value), expected});
    };
    const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
    require(positive(bridge.span), "span", bridge.span, "must be > 0 m");
    require(positive(bridge.rise) && bridge.rise < bridge.span / 2, "rise", bridge.rise,
            "must be > 0 m and less than half the span");
    require(bridge.voussoirs >= 2 && bridge.voussoirs <= 99999, "voussoirs", bridge.voussoirs,
            "must be 2 to 99999");
    require(positive(bridge.springing_thickness), "springing thickness", bridge.springing_thickness,
            "must be > 0 m");
    require(positive(bridge.crown_thickness), "crown thickness", bridge.crown_thickness, "must be > 0 m");
    require(positive(bridge.width), "width", bridge.width, "must be > 0 m");
    require(positive(bridge.abutment_length) && bridge.abutment_length > bridge.springing_thickness,
            "abutment length", bridge.abutment_length, "must be > springing thickness");
    require(positive(bridge.abutment_depth), "abutment depth", bridge.abutment_depth, "must be > 0 m");
    if (!faults.empty()) throw InputError(faults);
}

/// All joints from left to right; the right half mirrors the left one.
std::vector<Joint> joints_of(const ArchBridge& bridge)
{
    const double half_span = bridge.span / 2;
    const double radius = (half_span * half_span + bridge.rise * bridge.rise) / (2 * bridge.rise);
    const double springing_angle = 2 * std::atan(bridge.rise / half_span);  // from the crown
    std::vector<Joint> joints(bridge.voussoirs + 1);
    for (int i = 0; 2 * i <= bridge.voussoirs; ++i) {
        const double share = 1.0 - 2.0 * i / bridge.voussoirs;  // 1 at the springing, 0 at the crown
        const double angle = springing_angle * share;
        const double thickness =
            bridge.crown_thickness + (bridge.springing_thickness - bridge.crown_thickness) * share * share;
        const auto on_radius = [&](double r) {
            return Point{to_nanometre(-r * std::sin(angle)),
                         to_nanometre(r * std::cos(angle) - (radius - bridge.rise))};
        };
        joints[i] = {on_radius(radius), on_radius(radius + thickness)};
        if (i == 0) joints[i].intrados = {to_nanometre(-half_span), 0};  // exact, whatever the sine rounds to
        joints[bridge.voussoirs - i] = {mirrored(joints[i].intrados), mirrored(joints[i].extrados)};
    }
    return joints;
}

/// The outline, clockwise in the elevation as seen from -y (x right, z up), drawn across the width.
mesh::PolygonSurface prism(std::string name, const std::vector<Point>& outline, double width)
{
    mesh::PolygonSurface surface{std::move(name), {}, {}};
    const int n = static_cast<int>(outline.size());
    for (const double y : {-width / 2, width / 2})
        for (const Point& point : outline) surface.vertices.emplace_back(point.x, y, point.z);
    std::vector<int> near, far;
    for (int i = 0; i < n; ++i) {
        near.push_back(n - 1 - i);
        far.push_back(n + i);
        const int next = (i + 1) % n;
        surface.faces.push_back({i, next, n + next, n + i});
    }
    surface.faces.push_back(near);
    surface.faces.push_back(far);
    return surface;
}

std::string voussoir_name(int number, int count)
{
    std::string digits = std::to_string(number);
    const std::size_t width = std::max<std::size_t>(2, std::to_string(count).size());
    return "voussoir_" + std::string(width - digits.size(), '0') + digits;
}

/// Clockwise from the foot of the front: bottom, back, top, skewback, front.
std::vector<Point> left_abutment(const ArchBridge& bridge, const Joint& skewback)
{
    const double back = to_nanometre(skewback.intrados.x - bridge.abutment_length);
    const double bottom = to_nanometre(-bridge.abutment_depth);
    return {{skewback.intrados.x, bottom},
            {back, bottom},
            {back, skewback.extrados.z},
            skewback.extrados,
            skewback.intrados};
}

std::vector<Point> right_abutment(const ArchBridge& bridge, const Joint& skewback)
{
    const std::vector<Point> left =
        left_abutment(bridge, {mirrored(skewback.intrados), mirrored(skewback.extrados)});
    std::vector<Point> right;
    for (auto point = left.rbegin(); point != left.rend(); ++point) right.push_back(mirrored(*point));
    return right;
}

}  // namespace

std::vector<mesh::PolygonSurface> arch_bridge(const ArchBridge& bridge)
{
    check(bridge);
    const std::vector<Joint> joints = joints_of(bridge);
    std::vector<mesh::PolygonSurface> stones;
    stones.push_back(prism("abutment_left", left_abutment(bridge, joints.front()), bridge.width));
    for (int i = 0; i < bridge.voussoirs; ++i) {
        const Joint &left = joints[i], &right = joints[i + 1];
        stones.push_back(prism(voussoir_name(i + 1, bridge.voussoirs),
                               {left.intrados, left.extrados, right.extrados, right.intrados}, bridge.width));
    }
    stones.push_back(prism("abutment_right", right_abutment(bridge, joints.back()), bridge.width));
    return stones;
}

}  // namespace voussoir::importers::patterns
