// Vectors and tensors as a scene stores them: a planar one has no y.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "libdda/model/model.h"

namespace voussoir::app::results
{

/// "x", "y", "z", or "x", "z".
std::vector<std::string> axis_names(Kinematics kinematics);

/// Appends the components of `v` that the scene has.
void append_vector(std::vector<double>& values, const Eigen::Vector3d& v, Kinematics kinematics);
/// A moment, an axial vector: in a planar scene the one number about -y, from x to z.
void append_moment(std::vector<double>& values, const Eigen::Vector3d& moment, Kinematics kinematics);
std::vector<double> stored_vector(const Eigen::Vector3d& v, Kinematics kinematics);

/// Vector `index` of a flat list (vectors x dimension), in space.
Eigen::Vector3d vector_at(const std::vector<double>& values, std::size_t index, Kinematics kinematics);
Eigen::Vector3d moment_at(const std::vector<double>& values, std::size_t index, Kinematics kinematics);

/// The components of stress that a scene has: xx, yy, zz, xy, yz, xz; in plane strain xx, zz, xz, yy; in plane
/// stress xx, zz, xz; none of rigid blocks.
std::vector<std::string> stress_components(const Model& model);

/// The component of a tensor in space that is called `name`.
double component(const Eigen::Matrix3d& tensor, const std::string& name);
/// The symmetric tensor with these components; 0 where none is named.
Eigen::Matrix3d tensor_of(const std::vector<std::string>& names, const double* components);

}  // namespace voussoir::app::results
