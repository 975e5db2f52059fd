#include "importers/patterns/survey.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "importers/patterns/even_numbers.h"
#include "importers/patterns/parameter_checks.h"

namespace voussoir::importers::patterns
{
namespace
{

using Eigen::Vector3d;
using Faces = std::vector<std::vector<int>>;

Vector3d deviation(EvenNumbers& numbers)
{
    const double x = numbers.deviation(), y = numbers.deviation(), z = numbers.deviation();
    return {x, y, z};
}

std::vector<double> sizes_of(const StoneGrid& grid)
{
    std::vector<double> sizes;
    for (const StoneGrid::Stone& stone : grid.stones())
        sizes.push_back(std::cbrt(volume_of(grid.corners(), stone.faces)));
    return sizes;
}

std::vector<Vector3d> warped_corners(const StoneGrid& grid, const std::vector<double>& sizes, const Survey& survey)
{
    std::vector<double> smallest(grid.corners().size(), INFINITY);
    for (std::size_t s = 0; s < sizes.size(); ++s)
        for (const std::vector<int>& face : grid.stones()[s].faces)
            for (const int corner : face) smallest[corner] = std::min(smallest[corner], sizes[s]);
    std::vector<Vector3d> corners = grid.corners();
    EvenNumbers numbers(survey.seed);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector3d move = deviation(numbers);
        if (survey.warp > 0 && !grid.held()[i]) corners[i] += survey.warp * smallest[i] * move;
    }
    return corners;
}

/// Which of two diagonals all stones at a quadrilateral take: that through its lowest number, or the other.
bool through_lowest(const std::vector<int>& face, std::uint64_t seed)
{
    std::vector<int> sorted = face;
    std::sort(sorted.begin(), sorted.end());
    std::uint64_t mixed = seed;
    for (const int corner : sorted) mixed = EvenNumbers(mixed ^ static_cast<std::uint64_t>(corner)).bits();
    return EvenNumbers(mixed).share() < 0.5;
}

Faces in_triangles(const Faces& faces, const Survey& survey, EvenNumbers& numbers)
{
    Faces triangles;
    for (const std::vector<int>& face : faces) {
        if (face.size() != 4) {
            triangles.push_back(face);
            continue;
        }
        const auto lowest = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
        const bool through =
            survey.diagonals == Diagonals::shared ? through_lowest(face, survey.seed) : numbers.share() < 0.5;
        const std::size_t first = through ? lowest : lowest + 1;
        const auto at = [&](std::size_t i) { return face[(first + i) % 4]; };
        triangles.push_back({at(0), at(1), at(2)});
        triangles.push_back({at(0), at(2), at(3)});
    }
    return triangles;
}

/// The numbers of a stone's own vertices by those of the grid's corners, in the order in which its faces name
/// them.
std::map<int, int> own_numbers(const Faces& faces)
{
    std::map<int, int> own;
    for (const std::vector<int>& face : faces)
        for (const int corner : face) own.try_emplace(corner, static_cast<int>(own.size()));
    return own;
}

Faces renumbered(Faces faces, const std::map<int, int>& numbers)
{
    for (std::vector<int>& face : faces)
        for (int& corner : face) corner = numbers.at(corner);
    return faces;
}

double to_nanometre(double metres)
{
    return std::round(metres * 1e9) / 1e9 + 0.0;  // + 0.0: no negative zero
}

}  // namespace

std::vector<mesh::PolygonSurface> surveyed(const StoneGrid& grid, const Survey& survey)
{
    std::vector<Fault> faults;
    check_survey(survey, faults);
    if (!faults.empty()) throw InputError(faults);
    const std::vector<double> sizes = sizes_of(grid);
    const std::vector<Vector3d> corners = warped_corners(grid, sizes, survey);
    EvenNumbers noise(EvenNumbers(survey.seed ^ 1).bits()), diagonals(EvenNumbers(survey.seed ^ 2).bits());
    std::vector<mesh::PolygonSurface> surfaces;
    for (std::size_t s = 0; s < sizes.size(); ++s) {
        const Faces& faces = grid.stones()[s].faces;
        const std::map<int, int> own = own_numbers(faces);
        mesh::PolygonSurface surface{grid.stones()[s].name, std::vector<Vector3d>(own.size()), {}};
        for (const auto& [corner, vertex] : own) surface.vertices[vertex] = corners[corner];
        for (Vector3d& x : surface.vertices) {
            x += survey.noise * sizes[s] * deviation(noise);
            x = x.unaryExpr(&to_nanometre);
        }
        const bool cut = survey.diagonals != Diagonals::none;
        surface.faces = renumbered(cut ? in_triangles(faces, survey, diagonals) : faces, own);
        surfaces.push_back(std::move(surface));
    }
    return surfaces;
}

}  // namespace voussoir::importers::patterns
