// The volume of a convex hull, quickly.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voussoir::importers::exact
{

/// Volume of the convex hull of points in plain doubles, for the comparison of hulls: points within 1e-9 of the
/// extent count as lying in a facet. 0 when they lie in a plane. Source: [BarberDobkinHuhdanpaa1996] (quickhull).
double hull_volume(const std::vector<Eigen::Vector3d>& points);

}  // namespace voussoir::importers::exact
