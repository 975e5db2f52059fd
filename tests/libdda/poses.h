// Blocks put where a test wants them, and the parts that contact search sees.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <vector>

#include "libdda/contact/placed_part.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::testing
{

/// Puts a block's centroid and turns it; the material stays unstrained.
inline void set_pose(const Model& model, State& state, int block, const Eigen::Vector3d& centroid,
                     const Eigen::Matrix3d& rotation)
{
    double* x = state.coordinates.data() + block * coordinates_per_block(model.kinematics);
    if (is_planar(model.kinematics)) {
        Eigen::Map<Eigen::Vector2d>{x} = from_space<2>(centroid);
        const Eigen::Matrix2d own = from_space<2>(rotation);
        if (is_deformable(model.kinematics))
            Eigen::Map<Eigen::Matrix2d>{x + 2} = own;
        else
            x[2] = std::atan2(own(1, 0), own(0, 0));
        return;
    }
    Eigen::Map<Eigen::Vector3d>{x} = centroid;
    if (is_deformable(model.kinematics)) {
        Eigen::Map<Eigen::Matrix3d>{x + 3} = rotation;
        return;
    }
    const Eigen::Quaterniond q(rotation);
    const double coefficients[4] = {q.w(), q.x(), q.y(), q.z()};
    std::copy(coefficients, coefficients + 4, x + 3);
}

inline std::vector<contact::PlacedPart> placed(const Model& model, const State& state)
{
    std::vector<contact::PlacedPart> parts;
    contact::place_parts(model, state, 1, parts);
    return parts;
}

inline Eigen::Matrix3d turned(double angle, const Eigen::Vector3d& axis)
{
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// Numbers that are the same on every machine: the standard distributions are not.
class Random
{
 public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
    Eigen::Vector3d vector(double size = 1)
    {
        const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
        return {x, y, z};
    }
    Eigen::Matrix3d rotation()
    {
        const double angle = between(0, 3);
        return turned(angle, vector() + Eigen::Vector3d(0, 0, 1e-3));
    }
    template <class Vector>
    void fill(Vector& values, double size)
    {
        for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = between(-size, size);
    }

 private:
    std::mt19937 engine_;
};

}  // namespace voussoir::testing
