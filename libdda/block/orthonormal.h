// Frames that are no longer quite orthonormal.
#pragma once

#include "libdda/geometry/plane.h"

namespace voussoir::step
{

/// The frame whose first axis is that of `frame`, and the others as near as may be (Gram and Schmidt).
template <int D>
MatrixIn<D> orthonormal(MatrixIn<D> frame)
{
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < i; ++j) frame.col(i) -= frame.col(j).dot(frame.col(i)) * frame.col(j);
        frame.col(i).normalize();
    }
    return frame;
}

}  // namespace voussoir::step
