// A stone on its way to a certificate.
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "importers/exact/certify.h"
#include "importers/exact/surface_checks.h"

namespace voussoir::importers::exact
{

/// printf into a string.
template <class... Values>
std::string format(const char* pattern, Values... values)
{
    std::array<char, 256> buffer{};
    std::snprintf(buffer.data(), buffer.size(), pattern, values...);  // NOLINT: patterns are literals
    return buffer.data();
}

struct Draft {
    mesh::PolygonSurface surface;
    CertifyOptions options;
    double diagonal = 0;       // m
    std::vector<int> shell;    // per face: 0 the outside, others cavities
    std::vector<bool> turned;  // per face: it runs the other way than in the file
    SurfaceExamination examination;
    Certificate certificate;

    std::string at(int vertex) const
    {
        const Eigen::Vector3d x = surface.vertices[vertex] + options.origin;
        return format("(%.9g, %.9g, %.9g)", x.x(), x.y(), x.z());
    }
    std::string along(const std::pair<int, int>& edge) const
    {
        return "from " + at(edge.first) + " to " + at(edge.second);
    }
    void repaired(mesh::Repair repair) { certificate.repairs.push_back(std::move(repair)); }
    void mark_edges(const std::string& label, const std::vector<std::pair<int, int>>& edges);
    void mark_faces(const std::string& label, const std::vector<int>& faces);
};

/// A step to the certificate: returns the reason for refusal, or nothing.
using CertifyStep = std::string (*)(Draft&);

// The shape of a closed, outward surface: one convex part, or several.
std::string check_convex(Draft& draft);

/// Whether faces bulge by no more than `allowed` [m] and no vertex lies outside any.
bool is_convex(const Draft& draft, double allowed);

/// The same as the options ask for it: by its hull, simplified, or as drawn.
std::string check_shape(Draft& draft);

/// Takes the convex hull of the vertices in place of the stone. @param why it is refused else; empty: it was asked
/// for
std::string become_hull(Draft& draft, const std::string& why);

}  // namespace voussoir::importers::exact
