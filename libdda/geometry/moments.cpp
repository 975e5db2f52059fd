#include "libdda/geometry/moments.h"

#include <Eigen/Geometry>
#include <vector>

namespace voussoir
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{

/// Raw moments about a local origin: tetrahedra from that origin over outward triangles.
struct RawMoments {
    double volume = 0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();

    void add(const Vector3d& p, const Vector3d& q, const Vector3d& r)
    {
        const double v = p.dot(q.cross(r)) / 6;
        const Vector3d s = p + q + r;
        volume += v;
        first += v / 4 * s;
        second += v / 20 * (p * p.transpose() + q * q.transpose() + r * r.transpose() + s * s.transpose());
    }

    Moments about_centroid(const Vector3d& origin) const
    {
        Moments m;
        m.volume = volume;
        const Vector3d c = first / volume;
        m.centroid = origin + c;
        m.second = second - volume * c * c.transpose();
        return m;
    }
};

}  // namespace

Moments moments_of(const ConvexPolyhedron& shape)
{
    const Vector3d origin = shape.vertices.front();
    RawMoments raw;
    for (const std::vector<int>& face : shape.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            raw.add(shape.vertices[face[0]] - origin, shape.vertices[face[i]] - origin,
                    shape.vertices[face[i + 1]] - origin);
    return raw.about_centroid(origin);
}

Moments moments_of(std::span<const ConvexPolyhedron> parts)
{
    std::vector<Moments> each;
    Moments sum;
    Vector3d first = Vector3d::Zero();  // about the first part's centroid
    for (const ConvexPolyhedron& part : parts) {
        each.push_back(moments_of(part));
        sum.volume += each.back().volume;
        first += each.back().volume * (each.back().centroid - each.front().centroid);
    }
    sum.centroid = each.front().centroid + first / sum.volume;
    for (const Moments& m : each) {
        const Vector3d d = m.centroid - sum.centroid;
        sum.second += m.second + m.volume * d * d.transpose();
    }
    return sum;
}

Moments moments_of_surface(std::span<const Vector3d> vertices, std::span<const Eigen::Vector3i> triangles)
{
    const Vector3d& origin = vertices[triangles.front()[0]];
    RawMoments raw;
    for (const Eigen::Vector3i& t : triangles)
        raw.add(vertices[t[0]] - origin, vertices[t[1]] - origin, vertices[t[2]] - origin);
    return raw.about_centroid(origin);
}

}  // namespace voussoir
