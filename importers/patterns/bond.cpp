#include "importers/patterns/bond.h"

#include <algorithm>
#include <cmath>

#include "importers/patterns/pattern.h"

namespace voussoir::importers::patterns
{

std::vector<double> joints_of_course(double from, double to, double length, int course)
{
    // Whole blocks are as long as they must be to fill the course.
    const int whole = std::max(1, static_cast<int>(std::lround((to - from) / length)));
    const double own = (to - from) / whole;
    std::vector<double> joints{from};
    if (course % 2 == 0)
        for (int i = 1; i < whole; ++i) joints.push_back(to_nanometre(from + own * i));
    else
        for (int i = 0; i < whole; ++i) joints.push_back(to_nanometre(from + own * (i + 0.5)));
    if (whole == 1) joints.resize(1);  // one block fills it: halves of it would be needless
    joints.push_back(to);
    return joints;
}

}  // namespace voussoir::importers::patterns
