#include "importers/patterns/convex_outlines.h"

#include <algorithm>

#include "libdda/errors.h"

namespace voussoir::importers::patterns
{
namespace
{

double turn(const Point& a, const Point& b, const Point& c)
{
    return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
}

bool is_inside(const Point& x, const Point& a, const Point& b, const Point& c)
{
    return turn(a, b, x) >= 0 && turn(b, c, x) >= 0 && turn(c, a, x) >= 0;
}

bool is_convex(const std::vector<Point>& outline)
{
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(outline[i], outline[(i + 1) % n], outline[(i + 2) % n]) < 0) return false;
    return true;
}

/// Two sides that are no neighbours have a common point inside both.
bool crosses_itself(const std::vector<Point>& outline)
{
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 2; k < n; ++k) {
            const Point &a = outline[i], &b = outline[i + 1], &c = outline[k], &d = outline[(k + 1) % n];
            if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
        }
    return false;
}

std::vector<std::vector<Point>> triangles_of(std::vector<Point> left)
{
    std::vector<std::vector<Point>> triangles;
    while (left.size() > 3) {
        const std::size_t n = left.size();
        std::size_t ear = n;
        for (std::size_t i = 0; i < n && ear == n; ++i) {
            const Point &a = left[(i + n - 1) % n], &b = left[i], &c = left[(i + 1) % n];
            bool is_ear = turn(a, b, c) > 0;
            for (std::size_t k = 0; k < n && is_ear; ++k)
                is_ear = left[k] == a || left[k] == b || left[k] == c || !is_inside(left[k], a, b, c);
            if (is_ear) ear = i;
        }
        if (ear == n) throw InputError("outline", "it crosses or touches itself", "give the corners in order");
        triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back(left);
    return triangles;
}

/// Both outlines without their common side, if they have one and the result is convex; else none.
std::vector<Point> joined(const std::vector<Point>& a, const std::vector<Point>& b)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k) {
            if (a[i] != b[(k + 1) % b.size()] || a[(i + 1) % a.size()] != b[k]) continue;
            std::vector<Point> all;
            for (std::size_t n = 1; n < a.size() + 1; ++n) all.push_back(a[(i + n) % a.size()]);
            for (std::size_t n = 2; n < b.size(); ++n) all.push_back(b[(k + n) % b.size()]);
            if (is_convex(all)) return all;
        }
    return {};
}

}  // namespace

std::vector<std::vector<Point>> convex_outlines(const std::vector<Point>& outline)
{
    std::vector<Point> clean = clean_outline(outline);
    if (clean.size() < 3) throw InputError("outline", "fewer than three corners", "an outline encloses an area");
    if (crosses_itself(clean)) throw InputError("outline", "it crosses itself", "give the corners in order");
    if (is_convex(clean)) return {clean};
    std::vector<std::vector<Point>> parts = triangles_of(clean);
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t k = i + 1; k < parts.size();) {
            std::vector<Point> both = joined(parts[i], parts[k]);
            if (both.empty()) {
                ++k;
                continue;
            }
            parts[i] = std::move(both);
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
            k = i + 1;
        }
    return parts;
}

}  // namespace voussoir::importers::patterns
