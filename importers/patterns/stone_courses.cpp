#include "importers/patterns/stone_courses.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "importers/patterns/bond.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{

void add_course(Pattern& pattern, const CoursedBody& body, int number)
{
    const double length = body.block.length;
    std::vector<double> across{body.y.first, body.y.second};
    if (body.y.second - body.y.first > 1.5 * length)
        across = joints_of_course(body.y.first, body.y.second, length, number);
    int stone = 0;
    for (std::size_t row = 0; row + 1 < across.size(); ++row) {
        const std::vector<double> joints =
            joints_of_course(body.x.first, body.x.second, length, number + static_cast<int>(row));
        for (std::size_t i = 0; i + 1 < joints.size(); ++i)
            pattern.stones.push_back({body.name + "_c" + numbered(number, 99) + "_b" + numbered(++stone, 99),
                                      body.group,
                                      {make_box({joints[i], across[row], body.z.first},
                                                {joints[i + 1], across[row + 1], body.z.second})},
                                      Play::level});
    }
}

void add_courses(Pattern& pattern, const CoursedBody& body)
{
    const double foot = body.z.first, height = body.z.second - foot;
    const int courses = std::max(1, static_cast<int>(std::lround(height / body.block.height)));
    for (int course = 0; course < courses; ++course) {
        CoursedBody own = body;
        if (course > 0) own.z.first = to_nanometre(foot + height * course / courses);
        if (course + 1 < courses) own.z.second = to_nanometre(foot + height * (course + 1) / courses);
        add_course(pattern, own, course + 1);
    }
}

}  // namespace voussoir::importers::patterns
