// Where vertical joints lie in a course.
#pragma once

#include <vector>

namespace voussoir::importers::patterns
{

/// Beginning, joints and end of a course between two places [m]: whole lengths from the beginning, half a length
/// off in every second course, equal throughout so that both ends look alike. Pieces are never shorter than half
/// a length where the course is longer than one.
/// @param length of a block [m]; @param course its number: odd courses begin and end with half a block
std::vector<double> joints_of_course(double from, double to, double length, int course);

}  // namespace voussoir::importers::patterns
