// What the points of a face that is cut anew in every step remember of their slip.
// Source: docs/faces.md, "A joint that opens".
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <span>

#include "libdda/model/state.h"

namespace voussoir::contact
{

constexpr double in_a_row = 1e-4;  // second moment across by that along, of points

/// The elastic slip of the points that press, as a linear function of their place. Points of a face that was cut
/// move with the line: what they remember is not theirs alone but that of a place.
template <int D>
class SlipField
{
 public:
    SlipField() = default;
    SlipField(std::span<const ContactPointIn<D>> points, const VectorIn<D>& normal)
    {
        double area = 0;
        for (const ContactPointIn<D>& p : points) {
            if (p.gap >= 0) continue;
            area += p.area;
            centre_ += p.area * p.position;
            mean_ += p.area * p.elastic_slip;
        }
        if (!(area > 0)) return;
        centre_ /= area;
        mean_ /= area;
        MatrixIn<D> second = MatrixIn<D>::Zero(), with_slip = MatrixIn<D>::Zero();
        for (const ContactPointIn<D>& p : points) {
            if (p.gap >= 0) continue;
            const VectorIn<D> place = p.position - centre_;
            second += p.area * place * place.transpose();
            with_slip += p.area * p.elastic_slip * place.transpose();
        }
        const double size = second.trace();
        second += size * normal * normal.transpose();  // it has no slope across the face
        // Points in a row, or one alone, have none that could be told.
        if (second.determinant() > in_a_row * std::pow(size, D)) slope_ = with_slip * second.inverse();
    }
    VectorIn<D> at(const VectorIn<D>& place) const { return mean_ + slope_ * (place - centre_); }
    VectorIn<D> change(const VectorIn<D>& from, const VectorIn<D>& to) const { return slope_ * (to - from); }

 private:
    VectorIn<D> centre_ = VectorIn<D>::Zero(), mean_ = VectorIn<D>::Zero();
    MatrixIn<D> slope_ = MatrixIn<D>::Zero();
};

}  // namespace voussoir::contact
