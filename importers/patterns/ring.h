// The plan of a tower: a ring of stones between an outer and an inner outline.
#pragma once

#include <vector>

#include "importers/patterns/pattern.h"

namespace voussoir::importers::patterns
{

/// A ring about the origin, measured along its outer outline from the middle of the south side, counter-clockwise.
/// Of n sides, or round: then sides are the chords of its stones.
class Ring
{
 public:
    /// @param sides 4, 8, ...; 0: round @param width outside, across the flats or the diameter [m]
    /// @param thickness of the wall [m]; @param stone length of a stone outside [m]
    Ring(int sides, double width, double thickness, double stone);

    /// Once round [m].
    double length() const { return length_; }
    /// Length of a stone as the ring divides it [m].
    double stone() const { return stone_; }
    /// Nearer to a corner than this no stone may end: its inner side would be gone [m]; 0 of a round ring.
    double corner() const { return corner_; }
    int sides() const { return sides_; }
    /// Length of a side [m]; of a round ring all of it.
    double side() const { return sides_ == 0 ? length_ : length_ / sides_; }
    /// Where the head joints of a course lie, ascending, from 0 to length() [m]. Corner stones have a short leg
    /// and a long one, on the other side in the next course.
    std::vector<double> joints(int course) const;
    /// The convex parts of the plan of a stone from one place to another one, counter-clockwise.
    /// @pre from < to; both may exceed length()
    std::vector<std::vector<Point>> parts(double from, double to) const;
    /// The plan of a slab under the ring. @param projection beyond the wall [m]
    std::vector<Point> slab(double projection) const;

 private:
    std::vector<Point> on_side(int side, double from, double to) const;
    std::vector<Point> on_circle(double from, double to) const;

    int sides_ = 0;
    double width_, thickness_, stone_ = 0, length_ = 0, corner_ = 0;
    int per_side_ = 1;  // stones to a side; round: to a course
};

}  // namespace voussoir::importers::patterns
