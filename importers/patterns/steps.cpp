#include "importers/patterns/steps.h"

#include <cmath>
#include <vector>

#include "importers/patterns/bond.h"
#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{
namespace
{

double depth_of(const Steps& steps)
{
    return steps.depth > 0 ? steps.depth : 1.5 * steps.going;
}

void check(const Steps& steps)
{
    std::vector<Fault> faults;
    check_number("number", steps.number, 1, faults);
    check_positive("rise", steps.rise, faults);
    check_positive("going", steps.going, faults);
    check_positive("width", steps.width, faults);
    check_positive("landing", steps.landing, faults);
    check_positive("stone_length", steps.stone_length, faults);
    if (!faults.empty()) throw InputError(faults);
    if (steps.landing < steps.going - 1e-9)
        faults.push_back({"landing", std::to_string(steps.landing) + " m", "must be at least going"});
    if (depth_of(steps) <= steps.going)
        faults.push_back({"depth", std::to_string(steps.depth) + " m",
                          "must be more than going: each step bears on the one below"});
    const double length = steps.number * steps.going + steps.landing;
    check_stones("number", steps.number * (length / depth_of(steps) + 1) * (steps.width / steps.stone_length + 1),
                 faults);
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace

Pattern steps(const Steps& steps, const std::string& name)
{
    check(steps);
    const double back = to_nanometre((steps.number - 1) * steps.going + steps.landing);
    const double half = to_nanometre(steps.width / 2), below = to_nanometre(steps.rise);
    Pattern pattern;
    pattern.stones.push_back({name + "slab",
                              foundation_group,
                              {make_box({-below, -half - below, -below}, {back + below, half + below, 0})}});
    for (int step = 0; step < steps.number; ++step) {
        const double front = to_nanometre(step * steps.going);
        const double foot = to_nanometre(step * steps.rise), top = to_nanometre((step + 1) * steps.rise);
        // A stone of the nosing is never shorter than asked for: it bears beyond the nosing above it.
        const int rows = std::max(1, static_cast<int>(std::floor((back - front) / depth_of(steps) + 1e-9)));
        int number = 0;
        for (int row = 0; row < rows; ++row) {
            const double from = to_nanometre(front + (back - front) * row / rows),
                         to = to_nanometre(front + (back - front) * (row + 1) / rows);
            const std::vector<double> joints = joints_of_course(-half, half, steps.stone_length, step + row);
            for (std::size_t i = 0; i + 1 < joints.size(); ++i)
                pattern.stones.push_back(
                    {name + "step_" + std::to_string(step + 1) + "_b" + numbered(++number, 99),
                     "steps",
                     {make_box({from, joints[i], foot}, {to, joints[i + 1], top})},
                     Play::level});
        }
    }
    return pattern;
}

}  // namespace voussoir::importers::patterns
