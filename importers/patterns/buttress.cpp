#include "importers/patterns/buttress.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/stone_courses.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{
namespace
{

std::string metres(double value)
{
    return std::to_string(value) + " m";
}

void check(const Buttress& buttress)
{
    std::vector<Fault> faults;
    check_positive("width", buttress.width, faults);
    check_positive("block", buttress.block.length, faults);
    check_positive("block", buttress.block.height, faults);
    if (!(buttress.weathering > 0 && buttress.weathering < std::numbers::pi / 2))
        faults.push_back({"weathering", in_degrees(buttress.weathering), "must be > 0 and < 90 deg"});
    if (buttress.stages.empty()) faults.push_back({"stages", "none", "give at least one {height, depth}"});
    double stones = 0;
    for (std::size_t i = 0; i < buttress.stages.size(); ++i) {
        const ButtressStage& stage = buttress.stages[i];
        const std::string key = "stages[" + std::to_string(i) + "]";
        check_positive(key + ".height", stage.height, faults);
        check_positive(key + ".depth", stage.depth, faults);
        if (i > 0 && stage.depth >= buttress.stages[i - 1].depth)
            faults.push_back({key + ".depth", metres(stage.depth), "must be less than that of the stage below"});
        stones += (stage.height / buttress.block.height + 1) * (stage.depth / buttress.block.length + 1) *
                  (buttress.width / buttress.block.length + 1);
    }
    if (faults.empty()) check_stones("block", stones, faults);
    if (!faults.empty()) throw InputError(faults);
}

void check(const FlyingButtress& buttress)
{
    std::vector<Fault> faults;
    if (buttress.curve.shape == ArchShape::circular && buttress.curve.rise > buttress.curve.span / 2 * (1 + 1e-9))
        throw InputError("rise", metres(buttress.curve.rise),
                         "must be at most the span; an elliptic half arch rises higher");
    check_curve(buttress.curve, faults);
    check_positive("width", buttress.width, faults);
    check_positive("block", buttress.block.length, faults);
    check_positive("block", buttress.block.height, faults);
    check_positive("pier.depth", buttress.pier_depth, faults);
    check_positive("pier.height", buttress.pier_height, faults);
    check_positive("wall_thickness", buttress.wall_thickness, faults);
    if (!(buttress.pinnacle >= 0)) faults.push_back({"pinnacle", metres(buttress.pinnacle), "must be >= 0 m"});
    if (!faults.empty()) throw InputError(faults);
    const Point reach = joints_of(buttress.curve).back().extrados;
    const double least = reach.x() - buttress.curve.span / 2 + 0.3 * buttress.block.length;
    if (buttress.pier_depth < least)
        faults.push_back({"pier.depth", metres(buttress.pier_depth),
                          "the end of the arch and a stone behind it need " + metres(least)});
    check_stones("block",
                 (buttress.pier_height + buttress.pinnacle) / buttress.block.height *
                     (buttress.pier_depth / buttress.block.length + 1),
                 faults);
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace

Pattern buttress(const Buttress& buttress, const std::string& name)
{
    check(buttress);
    Pattern pattern;
    const double half = to_nanometre(buttress.width / 2), more = to_nanometre(buttress.block.height / 2);
    const double deepest = to_nanometre(buttress.stages[0].depth);
    pattern.stones.push_back({name + "slab",
                              foundation_group,
                              {make_box({0, -half - more, -2 * more}, {deepest + more, half + more, 0})}});
    double foot = 0;
    for (std::size_t i = 0; i < buttress.stages.size(); ++i) {
        const ButtressStage& stage = buttress.stages[i];
        const std::string own = name + "stage_" + std::to_string(i + 1);
        const double depth = to_nanometre(stage.depth), bed = to_nanometre(foot + stage.height);
        add_courses(pattern, {own, "buttress", {0, depth}, {-half, half}, {foot, bed}, buttress.block});
        const bool is_last = i + 1 == buttress.stages.size();
        const double next = is_last ? 0 : to_nanometre(buttress.stages[i + 1].depth);
        foot = to_nanometre(bed + (depth - next) * std::tan(buttress.weathering));
        pattern.stones.push_back(
            {own + "_weathering",
             "buttress",
             {prism_along_y({{0, bed}, {depth, bed}, {next, foot}, {0, foot}}, -half, half, own + "_weathering")},
             Play::across});
    }
    return pattern;
}

Pattern flying_buttress(const FlyingButtress& buttress, const std::string& name)
{
    check(buttress);
    Pattern pattern;
    const double half = to_nanometre(buttress.width / 2), more = to_nanometre(buttress.block.height / 2);
    const std::vector<ArchJoint> joints = joints_of(buttress.curve);
    const std::size_t crown = joints.size() / 2;
    const double face = joints.back().intrados.x(), back = to_nanometre(face + buttress.pier_depth);
    const double foot = to_nanometre(-buttress.pier_height);
    const int courses = std::max(1, static_cast<int>(std::lround(buttress.pier_height / buttress.block.height)));
    const double bed = to_nanometre(-buttress.pier_height / courses);
    const auto add = [&](const std::string& own, const char* group, ConvexPolyhedron shape) {
        pattern.stones.push_back({name + own, group, {std::move(shape)}, Play::across});
    };
    const double low = to_nanometre(joints[crown].intrados.y() - buttress.block.height),
                 high = to_nanometre(joints[crown].extrados.y() + buttress.block.height);
    add("wall", foundation_group,
        make_box({-to_nanometre(buttress.wall_thickness), -half - more, low}, {0, half + more, high}));
    add("slab", foundation_group,
        make_box({face - more, -half - more, foot - 2 * more}, {back + more, half + more, foot}));
    if (bed > foot)
        add_courses(pattern, {name + "pier", "pier", {face, back}, {-half, half}, {foot, bed}, buttress.block});
    const Point& end = joints.back().extrados;
    add("impost", "pier",
        prism_along_y({{face, bed}, {back, bed}, {back, end.y()}, end, {face, 0}}, -half, half, name + "impost"));
    for (std::size_t i = crown; i + 1 < joints.size(); ++i) {
        const std::string own = "voussoir_" + numbered(static_cast<int>(i - crown) + 1, 99);
        add(own, "voussoirs",
            prism_along_y({joints[i].intrados, joints[i].extrados, joints[i + 1].extrados, joints[i + 1].intrados},
                          -half, half, name + own));
    }
    const double free = buttress.block.length / 8;  // the pinnacle stands clear of the arch
    if (buttress.pinnacle > 0)
        add_courses(pattern, {name + "pinnacle",
                              "pinnacle",
                              {to_nanometre(end.x() + free), back},
                              {-half, half},
                              {end.y(), to_nanometre(end.y() + buttress.pinnacle)},
                              buttress.block});
    return pattern;
}

}  // namespace voussoir::importers::patterns
